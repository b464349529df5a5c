// What holds for all of the shown times: where the ends go, how far the coil is strained, what the forces are about.
//
// Next door: one moment of it (`draw`), which moment (`player`).

import type { Facts, Series } from '../answer';
import type { Shown } from '../compute';
import { digits, fixed } from '../dom';
import { strains } from './draw';

/** The largest strain is drawn as so much of a pitch. */
const OPEN = 0.6;
const GAINS = [200, 100, 50, 20, 10, 5, 2];

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

export function survey({ frames, answer, times }: Shown): Scene {
  const { positions, columns } = frames;
  let [left, right, peak] = [Infinity, -Infinity, 0];
  for (let frame = 0; frame < frames.times.length; frame++) {
    left = Math.min(left, positions[frame * columns] ?? 0);
    right = Math.max(right, positions[(frame + 1) * columns - 1] ?? 0);
    // Every sixth frame tells the largest strain well enough for a colour.
    if (frame % 6 === 0)
      for (const strain of strains(positions.subarray(frame * columns, (frame + 1) * columns)))
        peak = Math.max(peak, Math.abs(strain));
  }
  const gain = peak > 0 ? (GAINS.find((gain) => gain * peak <= OPEN) ?? 1) : 1;
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

/** Number of the time that is nearest; times rise. */
export function nearest(times: Float64Array, time: number): number {
  let [low, high] = [0, times.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((times[middle] ?? 0) <= time) low = middle;
    else high = middle;
  }
  return time - (times[low] ?? 0) < (times[high] ?? 0) - time ? low : high;
}

export function label({ spring }: Facts, peak: number, contact: number | null): string {
  const touch =
    contact === null ? 'No windings touch in what is shown.' : `Windings touch from ${fixed(1e3 * contact, 1)} ms on.`;
  return `The spring ${spring.name} with its ${spring.masses} windings, end 1 at the left, coloured by local pitch, which changes by up to ${digits(100 * peak, 2)} percent. ${touch}`;
}
