// Pages of what is shown, which the strip turns like those of a book: each of a few ways of the wave.
//
// Next door: who turns them (`strip`, `record/picture`).

import { clamp } from '../dom';

/** Ways of the wave on a page. */
const WAYS = 4;
/** Most pages of what is shown: more would flicker. */
const PAGES = 18;

/** From and to [s] of the page that a time is on; `way` is how long a wave takes from end to end [s]. */
export function pageAt(time: number, [from, to]: [number, number], way: number): [number, number] {
  const whole = to - from;
  const height = Math.min(whole, Math.max(WAYS * way, whole / PAGES));
  const number = Math.floor(clamp(time - from, 0, whole - height / 1e3) / height);
  const start = Math.min(from + number * height, to - height);
  return [start, start + height];
}
