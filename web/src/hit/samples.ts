// A force as sound: its swing about the mean, as loud as any other, in and out gently; and which lines are heard in it.
//
// Next door: what plays it (`listen`).

import type { Answer, ExactFacts } from '../answer';

/** Shorter is repeated, longer cut [s]. */
const SHORT = 0.5;
const LONG = 3;
/** In and out [s]. */
const FADE = 0.03;
/** Lines below a share of the strongest are not named, nor what no ear hears [1, Hz]. */
const FAINT = 0.1;
const HEARD: [number, number] = [20, 16_000];
const MOST_NAMED = 5;
/** What swings by less is still [share of the nominal force]. */
const STILL = 1e-9;

/** Samples from −1 to 1 at a rate, or null where nothing swings. */
export function samples({ facts, series }: Answer<ExactFacts>, rate: number): Float32Array<ArrayBuffer> | null {
  const force = series['F_o'] ?? new Float64Array();
  const own = facts.conditions[facts.condition]?.sampleRate ?? rate;
  const mean = force.reduce((sum, value) => sum + value, 0) / Math.max(1, force.length);
  const most = force.reduce((most, value) => Math.max(most, Math.abs(value - mean)), 0);
  if (force.length < 2 || most < STILL * facts.spring.nominalForce) return null;
  const once = Math.min((force.length - 1) / own, LONG);
  const [count, turns] = [Math.floor(once * rate), once < SHORT ? Math.ceil((2 * SHORT) / once) : 1];
  const round = Float32Array.from({ length: count }, (_, index) => {
    const at = (index / rate) * own;
    const low = Math.floor(at);
    const [one = 0, two = one] = [force[low], force[low + 1]];
    const value = (one + (at - low) * (two - one) - mean) / most;
    return value * Math.min(1, index / rate / FADE, (count - 1 - index) / rate / FADE);
  });
  const all = new Float32Array(Math.min(count * turns, Math.floor(LONG * rate)));
  for (let turn = 0; turn < turns; turn++) {
    const start = turn * count;
    if (start < all.length) all.set(round.subarray(0, all.length - start), start);
  }
  return all;
}

/** The strongest lines of the force that an ear hears [Hz], by frequency: where one of the coil's own lies within the spectrum's step, that. */
export function heard({ facts, series }: Answer<ExactFacts>): number[] {
  const [frequency, spectrum] = [series['frequency'], series['spectrum F_o']];
  if (!frequency || !spectrum) return [];
  const strength = (at: number) => spectrum[at] ?? 0;
  const strongest = [...frequency.keys()]
    .filter((at) => at > 0 && (frequency[at] ?? 0) >= HEARD[0] && (frequency[at] ?? 0) <= HEARD[1])
    .filter((at) => strength(at) >= strength(at - 1) && strength(at) > strength(at + 1))
    .sort((a, b) => strength(b) - strength(a))
    .slice(0, MOST_NAMED);
  const step = frequency[1] ?? 0;
  const least = FAINT * strength(strongest[0] ?? 0);
  return strongest
    .filter((at) => strength(at) >= least)
    .map((at) => facts.lines.find((line) => Math.abs(line - (frequency[at] ?? 0)) <= step) ?? frequency[at] ?? 0)
    .sort((a, b) => a - b);
}
