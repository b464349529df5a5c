// What holds for all of the shown times: where the ends go, how far the coil is strained, what the forces are about.
//
// Next door: one moment of it (`draw`), which moment (`player`).

import type { Clash, ContactFacts, Series, SpringFacts } from '../answer';
import { clamp, digits, fixed } from '../dom';
import { strains } from './draw';

/** The largest strain is drawn as so much of a pitch. */
const OPEN = 0.6;
/** So many frames tell the largest strain well enough for a colour. */
const ENOUGH = 400;
/** By how much displacements may be drawn larger. */
export const GAINS = [1, 2, 5, 10, 20, 50, 100, 200];

/** Seconds of the spring per second of the viewer. */
export const SPEEDS = [1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005, 0.0002];
/** Where nobody chose, what is shown takes about so long [s]. */
const ROUND = 10;

/** The speed at which shown times take about as long as people like to look. */
export function usualSpeed([from, to]: [number, number]): number {
  const off = (slow: number) => Math.abs(Math.log((to - from) / slow / ROUND));
  return SPEEDS.reduce((best, slow) => (off(slow) < off(best) ? slow : best), 1);
}

/** Positions u1, x_1…x_N, u2 [m] at some times [s]. */
export interface Frames {
  times: Float64Array;
  positions: Float32Array;
  columns: number;
}

/** What the spring needs of its dimensions to be drawn and spoken of. */
export type Coil = Pick<
  SpringFacts,
  'name' | 'masses' | 'coilRadius' | 'wireDiameter' | 'contactPitch' | 'nominalForce'
>;

interface Told {
  spring: Coil;
  clash: Pick<Clash, 'firstContact'>;
  contact?: Pick<ContactFacts, 'first'> | null;
}

/** When windings first touch or, where they were asked to, meet [s]. */
export const firstContact = ({ contact, clash }: Told): number | null => (contact ? contact.first : clash.firstContact);

/** A motion, and which part of it is seen. */
export interface Seen {
  frames: Frames;
  times: [number, number];
  /** With time, F_i and F_o. */
  answer: { series: Series; facts: Told };
}

export interface Scene {
  /** Ends over all of the shown times [m]. */
  left: number;
  right: number;
  /** Largest local strain [1], and by how much displacements are drawn larger. */
  peak: number;
  gain: number;
  /** Mean of both end forces [N], and the largest departure from it [N]. */
  mean: number;
  departure: number;
}

export function survey({ frames, answer, times }: Seen): Scene {
  const { positions, columns } = frames;
  let [left, right, peak] = [Infinity, -Infinity, 0];
  const stride = Math.ceil(frames.times.length / ENOUGH);
  for (let frame = 0; frame < frames.times.length; frame++) {
    left = Math.min(left, positions[frame * columns] ?? 0);
    right = Math.max(right, positions[(frame + 1) * columns - 1] ?? 0);
    if (frame % stride === 0)
      for (const strain of strains(positions.subarray(frame * columns, (frame + 1) * columns)))
        peak = Math.max(peak, Math.abs(strain));
  }
  const gain = peak > 0 ? (GAINS.findLast((gain) => gain * peak <= OPEN) ?? 1) : 1;
  return { left, right, peak, gain, ...departures(answer.series, times) };
}

/** Mean of the end forces over the shown times [N], and the largest departure from it [N]. */
function departures(series: Series, [from, to]: [number, number]): { mean: number; departure: number } {
  const time = series['time'] ?? new Float64Array();
  const [first, past] = [nearest(time, from), nearest(time, to) + 1];
  const forces = ['F_i', 'F_o'].map((name) => (series[name] ?? new Float64Array()).subarray(first, past));
  const mean =
    forces.reduce((sum, values) => sum + values.reduce((a, b) => a + b, 0), 0) / Math.max(1, 2 * (past - first));
  const departure = forces.reduce((most, values) => values.reduce((a, b) => Math.max(a, Math.abs(b - mean)), most), 0);
  return { mean, departure };
}

/** Number of the last time that is not later, or of the first; times rise. */
function last(times: Float64Array, time: number): number {
  let [low, high] = [0, times.length];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((times[middle] ?? 0) <= time) low = middle;
    else high = middle;
  }
  return low;
}

/** Number of the time that is nearest. */
export function nearest(times: Float64Array, time: number): number {
  const low = last(times, time);
  const next = times[low + 1] ?? Infinity;
  return next - time <= time - (times[low] ?? 0) ? low + 1 : low;
}

/** Positions at a time [m]: between frames along the straight line. */
export function positionsAt({ times, positions, columns }: Frames, time: number): Float32Array {
  const low = last(times, time);
  const next = Math.min(low + 1, times.length - 1);
  const [from, to] = [times[low] ?? 0, times[next] ?? 0];
  const part = to > from ? clamp((time - from) / (to - from), 0, 1) : 0;
  return Float32Array.from({ length: columns }, (_, node) => {
    const start = positions[low * columns + node] ?? 0;
    return start + part * ((positions[next * columns + node] ?? 0) - start);
  });
}

export function label(facts: Told, peak: number): string {
  const { spring } = facts;
  const [first, verb] = [firstContact(facts), facts.contact ? 'meet' : 'touch'];
  const touch =
    first === null ? `No windings ${verb} in what is shown.` : `Windings ${verb} from ${fixed(1e3 * first, 1)} ms on.`;
  return `The spring ${spring.name} with its ${spring.masses} windings, end 1 at the left, coloured by local pitch, which changes by up to ${digits(100 * peak, 2)} percent. ${touch}`;
}
