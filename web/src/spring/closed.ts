// Which windings lie on each other at a time, and which ends are off their seats, where windings were asked to meet.
//
// Next door: how they are drawn (`draw`), from when to when they do (`coilsense-web`, `contact`).

import type { Series } from '../answer';

/** A touch that is shorter is drawn for this share of what is shown [1]: hard windings that bounce are together for no time at all. */
const SHORTEST = 0.03;

/** What is together at a time. */
export interface Closed {
  /** One for each gap: seat 1 and the first winding, each winding and the next, the last and seat 2. */
  gaps: Uint8Array;
  /** In words: `3|4`, `seat 2`. */
  words: string[];
  /** Ends off their seats: 1, 2. */
  off: number[];
}

/** At a time [s] of a spring of so many windings; null where windings pass through one another. */
export function closedAt(series: Series, time: number, windings: number, [from, to]: [number, number]): Closed | null {
  if (!series['closed from']) return null;
  const least = SHORTEST * (to - from);
  const holding = (what: string, of: string): Set<number> => {
    const [begin, end, place] = ['from', 'to', of].map((name) => series[`${what} ${name}`] ?? new Float64Array());
    const found = new Set<number>();
    begin?.forEach((start, index) => {
      if (start <= time && time < Math.max(end?.[index] ?? 0, start + least)) found.add(place?.[index] ?? 0);
    });
    return found;
  };
  const gaps = new Uint8Array(windings + 1);
  const closed = [...holding('closed', 'gap')].sort((a, b) => a - b);
  for (const gap of closed) gaps[gap] = 1;
  const words = closed.map((gap) => (gap === 0 ? 'seat 1' : gap === windings ? 'seat 2' : `${gap}|${gap + 1}`));
  return { gaps, words, off: [...holding('off', 'end')].sort((a, b) => a - b) };
}
