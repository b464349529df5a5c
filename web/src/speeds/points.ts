// At which speeds of a recorded motion its case is computed, in an order in which the curve is soon seen whole: halves of what is between them.
//
// Next door: who asks (`part`), the curve (`curve`), what it says (`words`).

import type { Facts } from '../answer';

/** Shares of the recorded speed from which to which. */
export const FROM = 0.4;
export const TO = 1.6;
const FEWEST = 25;
const MOST = 41;
/** Around so many of the highest peaks the curve is looked at more closely, so often halved. */
const PEAKS = 3;
const HALVINGS = 3;

/** What one speed came to. */
export interface At {
  speed: number;
  /** Root mean square deviation of each force from the one taken as true, over F_nom. */
  off: Record<string, number>;
  /** Windings would touch, or do. */
  touch: boolean;
}

/**
 * How narrow a resonance may be over the speed, as a share of it: twice the damping ratio, or what a record of that length can tell apart; the greater of
 * both.
 */
export function narrowest({ dampings, damping, conditions, condition, spring }: Facts): number {
  const seconds = conditions[condition]?.window[1] ?? 1;
  return Math.max(2 * (dampings[damping]?.ratio ?? 0), 1 / (spring.surgeFrequency * seconds));
}

/** How far points are from each other, as a share of the speed. */
export const step = (count: number): number => Math.log(TO / FROM) / (count - 1);

/** So many points, by factors, that a resonance has two of them. */
export function count(facts: Facts): number {
  const wanted = 1 + Math.ceil(Math.log(TO / FROM) / (0.5 * narrowest(facts)));
  return Math.min(MOST, Math.max(FEWEST, wanted));
}

/** So many speeds, the ends and then the middles of what is between those before. */
export function inOrder(count: number): number[] {
  const speed = (index: number) => FROM * Math.exp(step(count) * index);
  const order = [0, count - 1];
  const seen = new Set(order);
  for (let width = 2 ** Math.ceil(Math.log2(count)); width >= 1; width /= 2)
    for (let index = width; index < count - 1; index += width)
      if (!seen.has(index)) {
        seen.add(index);
        order.push(index);
      }
  return order.map(speed);
}

/** Speeds beside the highest peaks that are not there yet; none once they are near enough. */
export function closer(points: readonly At[], force: string, count: number): number[] {
  const at = (index: number) => points[index]?.off[force] ?? 0;
  const tops = points
    .map((_, index) => index)
    .filter((index) => at(index) > 0 && at(index) >= at(index - 1) && at(index) >= at(index + 1))
    .sort((a, b) => at(b) - at(a))
    .slice(0, PEAKS);
  const least = step(count) / 2 ** HALVINGS;
  return tops.flatMap((index) =>
    [index - 1, index + 1].flatMap((other) => {
      const [here, there] = [points[index]?.speed ?? 0, points[other]?.speed];
      return there !== undefined && Math.abs(Math.log(there / here)) > 1.01 * least ? [Math.sqrt(here * there)] : [];
    }),
  );
}
