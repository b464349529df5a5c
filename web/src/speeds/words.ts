// What the curve over speed says, and what it leaves out.
//
// Next door: the curve (`curve`), where it is computed (`points`).

import type { Facts } from '../answer';
import { digits, make, rich } from '../dom';
import { narrowest, step, type At } from './points';

const percent = (share: number) => `${digits(100 * share)}\u00a0%`;
/** A speed to a tenth of a percent. */
export const speedOf = (share: number) => `${Number((100 * share).toFixed(1))}\u00a0%`;

/** The forces that are told: those at the ends and by length, but the one that is taken as true. */
export const forcesOf = ({ truth }: Facts): string[] => ['F_o', 'F_i', 'F_x'].filter((force) => force !== truth);

/** Between which values the force that is told first lies, and where it is worst: as long as no windings pass through one another. */
export function sentence(points: readonly At[], facts: Facts): (string | Node)[] {
  const [force = 'F_o'] = forcesOf(facts);
  const off = (point: At) => point.off[force] ?? 0;
  const real = facts.contact ? points : points.filter(({ touch }) => !touch);
  const [first] = real;
  if (!first) return ['At every speed so far windings would touch, so that a real coil would do something else.'];
  const least = real.reduce((a, b) => (off(b) < off(a) ? b : a), first);
  const most = real.reduce((a, b) => (off(b) > off(a) ? b : a), first);
  return [
    make('b', {}, rich(force)),
    rich(
      ` is off from ${facts.truth} by ${percent(off(least))} of F_nom at ${speedOf(least.speed)} of the recorded speed, and by `,
    ),
    make('b', {}, percent(off(most))),
    ` at ${speedOf(most.speed)}, ${real.length < points.length ? 'the worst of the speeds at which no windings touch' : 'where it is worst'}.`,
  ];
}

/** How far the curve may be trusted: what is still missing, what lies between the points, where windings touch. */
export function doubts(points: readonly At[], facts: Facts, wanted: number): string[] {
  const missing = wanted - points.length;
  const width = narrowest(facts);
  const touching = points.filter(({ touch }) => touch);
  const [first, last] = [touching[0], touching[touching.length - 1]];
  const meet = facts.contact ? 'meet' : 'would touch';
  const what = facts.contact ? '' : ': a real coil would do something else there';
  return [
    missing > 0 ? `${points.length} of ${wanted} speeds so far: peaks between them are still missing.` : '',
    missing <= 0 && step(wanted) > 0.75 * width
      ? `A resonance may be as narrow as ${percent(width)} of the speed, and the points are ${percent(step(wanted))} apart: a peak may be higher than it is drawn, or missing.`
      : '',
    first && last
      ? `In grey, ${first === last ? 'at' : `${speedOf(first.speed)} to`} ${speedOf(last.speed)}: speeds at which windings ${meet}${what}.`
      : '',
  ].filter(Boolean);
}
