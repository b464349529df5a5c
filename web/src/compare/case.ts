// One of the two states that are compared: its case, exact or not yet, its verdict, and how both are told in words.
//
// Next door: who keeps one (`part`), what differs in their inputs (`inputs`), both side by side (`card`).

import type { Answer, ExactFacts } from '../answer';
import { sections } from '../document';
import { PRESETS } from '../presets';
import type { Outcome } from '../results/outcome';
import type { State } from '../state';

/** A verdict, why there is none, or null while it is pending. */
export type Judged = { outcome: Outcome } | { reason: string } | null;

export interface Case {
  state: State;
  /** Null while it is pending. */
  exact: Answer<ExactFacts> | null;
  /** Why it cannot be computed, where it cannot. */
  failed: string;
  judged: Judged;
}

/** The name of what happens in a state. */
export function conditionOf({ spec, view }: State): string {
  const one = sections(spec, 'condition')[view.condition] ?? {};
  return String(one['name'] ?? one['kind'] ?? '');
}

/** Which spring it is, what happens to it, and how it is damped, as far as that is known. */
export function named({ state, exact }: Case): string {
  const label = PRESETS.find(({ id }) => id === state.preset)?.label ?? state.preset;
  const spring = exact?.facts.spring.name || label;
  const damping = exact?.facts.dampings[exact.facts.damping]?.label;
  return `${spring}, “${conditionOf(state)}”${damping ? `, ${damping}` : ''}`;
}

/** Where the coil rings by itself: on a mass at end 2 the lowest line is that mass's swing [Hz]. */
export const ring = ({ lines, spring }: ExactFacts): number =>
  lines.find((line) => line > 0.4 * spring.surgeFrequency) ?? lines[0] ?? NaN;

/** Windings would touch, and nobody asked for what they do then. */
export const isBeyond = ({ contact, clash }: ExactFacts): boolean => contact === null && clash.firstContact !== null;
