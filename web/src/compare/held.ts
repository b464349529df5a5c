// The curves that are kept, for whoever draws them.
//
// Next door: who keeps them (`part`), on the screen (`ghost`), for a document (`results/take`).

import type { Answer, ExactFacts } from '../answer';
import { FORCE_LINES, readings, type Line } from '../plots/lines';
import type { View } from '../state';

/** How much wider than a curve of now a kept one is drawn, and how much of the ground shines through: the width alone tells them apart. */
export const WIDER = 2.75;
export const PALE = 0.38;

interface Held {
  answer: Answer<ExactFacts>;
  /** What it is of. */
  words: string;
}

let held: Held | null = null;

export const hold = (next: Held | null): void => void (held = next);
export const heldNow = (): Held | null => held;

/** Which of the kept curves are drawn: the forces that are not hidden, and readings of the sensors that are asked for, by name. */
export const keptLines = ({ hidden, sensors }: View): Line[] =>
  held
    ? [...FORCE_LINES.filter(({ name }) => !hidden.includes(name)), ...readings(held.answer.facts, sensors)].filter(
        ({ series }) => held?.answer.series[series],
      )
    : [];
