// What a hit or a pull is in a spec: an impact with the pointer's speed, or an end that goes back by as far as it was pulled.
//
// Next door: how it is done by hand and by keys (`gesture`), when it is shown (`hands`).

import { sections, withValue, type Section, type Spec } from '../document';
import { clamp, digits, fixed } from '../dom';

/** How fast all windings move at once, towards end 2 [m/s]. */
export interface Hit {
  kind: 'hit';
  speed: number;
}

/** How far an end was pulled before it was let go, towards end 2 [m]. */
export interface Pull {
  kind: 'pull';
  end: 1 | 2;
  by: number;
}

export type Act = Hit | Pull;

/** The spring that is hit. */
export interface Rest {
  /** Between the ends once all is still, the shortest and the longest in use [m]. */
  length: number;
  shortest: number;
  longest: number;
  /** How long a wave takes from end to end [s]. */
  oneWay: number;
}

/** Of a click or a key, where what is shown has no speed of its own [m/s]. */
const USUAL_SPEED = 0.25;
/** Faster than any hand; the engine takes every speed [m/s]. */
export const FASTEST = 10;
/** Slower or shorter is no hit and no pull: what is written of it would be zero [m/s, m]. */
export const LEAST = { hit: 0.0005, pull: 0.00005 };
/**
 * An end that is let go is back within this share of a wave's way [1]. In no time at all (a step) the outermost windings would touch from
 * about a millimetre on: S_T's lie 2.4 mm apart.
 */
const SHARE = 0.25;
const NAMES = { hit: 'your hit', pull: 'your pull' };

/** The condition that an act is written into: the one that is shown where it is of that kind, else one of its own. */
function place(spec: Spec, shown: number, kinds: readonly string[], name: string): number {
  const all = sections(spec, 'condition');
  if (kinds.includes(String(all[shown]?.['kind']))) return shown;
  const known = all.findIndex((one) => one['name'] === name && kinds.includes(String(one['kind'])));
  return known < 0 ? all.length : known;
}

/** A spec with an act as its condition, and the number of that. */
export function applied(act: Act, spec: Spec, shown: number, rest: Rest): { spec: Spec; condition: number } {
  const name = NAMES[act.kind];
  const condition = place(spec, shown, act.kind === 'hit' ? ['impact'] : ['step', 'ramp'], name);
  const all = sections(spec, 'condition');
  const values: Section = act.kind === 'hit' ? { velocity: `${plain(act.speed)} m/s` } : pulled(act, rest);
  const before = all[condition];
  const added: Section = before ? {} : { name, ...kept(all[shown]), ...begun(act, rest) };
  const changed = Object.entries({ ...added, ...values }).reduce(
    (copy, [key, value]) => withValue(copy, `condition.${condition}.${key}`, value),
    before ? spec : { ...structuredClone(spec), condition: [...structuredClone(all), {}] },
  );
  return { spec: changed, condition };
}

/** What a condition of its own begins as. */
const begun = ({ kind }: Act, { oneWay }: Rest): Section =>
  kind === 'hit' ? { kind: 'impact' } : { kind: 'ramp', rise_time: `${plain(1e3 * SHARE * oneWay, 2)} ms` };

/** Goes on as what was shown before: the same length, as many samples a second. */
const kept = (shown: Section = {}): Section =>
  Object.fromEntries(['length', 'sample_rate'].flatMap((key) => (shown[key] === undefined ? [] : [[key, shown[key]]])));

/** It begins at the pulled length, and the end goes back from there. */
function pulled({ end, by }: Pull, { length }: Rest): Section {
  const from = length + (end === 1 ? -by : by);
  return { length: `${plain(1e3 * from, 6)} mm`, amplitude: `${plain(-1e3 * by)} mm`, end };
}

/** As the engine reads it: a plain minus, no power of ten. */
const plain = (value: number, count = 4): string => String(Number(value.toPrecision(count)));

/** Within what a spring can do: of a pull, the lengths in use. */
export function limited(act: Act, { length, shortest, longest }: Rest): Act {
  if (act.kind === 'hit') return { ...act, speed: round(clamp(act.speed, -FASTEST, FASTEST), 1e3) };
  const [least, most] = [Math.min(shortest, length) - length, Math.max(longest, length) - length];
  const by = act.end === 1 ? clamp(act.by, -most, -least) : clamp(act.by, least, most);
  return { ...act, by: round(by, 1e4) };
}

const round = (value: number, steps: number): number => Math.round(steps * value) / steps;

/** Whether it does anything at all. */
export const isNothing = (act: Act): boolean =>
  act.kind === 'hit' ? Math.abs(act.speed) < LEAST.hit : Math.abs(act.by) < LEAST.pull;

const METRES: Record<string, number> = { 'm/s': 1, 'cm/s': 1e-2, 'mm/s': 1e-3, 'km/h': 1 / 3.6 };

/** The speed of an impact that is shown [m/s], else the usual one. */
export function speedOf(shown: Section | undefined): number {
  const [, number = '', unit = ''] = /^\s*([-+]?[\d.]+)\s*(\S+)\s*$/.exec(String(shown?.['velocity'] ?? '')) ?? [];
  const speed = Number(number) * (METRES[unit] ?? NaN);
  return shown?.['kind'] === 'impact' && Number.isFinite(speed) && speed !== 0 ? speed : USUAL_SPEED;
}

/** When a wave sets out [s], and from which end. */
export interface Onset {
  time: number;
  end: 1 | 2;
}

/** Of a blow or a jump; what is driven steadily has none, nor what has a time that is written in other units. */
export function onset(shown: Section | undefined): Onset | null {
  const kind = String(shown?.['kind']);
  if (kind === 'impact' || kind === 'end-stop') return { time: 0, end: 1 };
  if (!['step', 'ramp', 'pulse'].includes(kind)) return null;
  const [, number = '', unit = ''] = /^\s*([\d.]+)\s*(m?s)\s*$/.exec(String(shown?.['begin'] ?? '0 s')) ?? [];
  return unit ? { time: Number(number) * (unit === 's' ? 1 : 1e-3), end: shown?.['end'] === 2 ? 2 : 1 } : null;
}

/** As it stands beside an arrow. */
export const figure = (act: Act): string =>
  act.kind === 'hit' ? `${fixed(act.speed, 2)} m/s` : `${fixed(1e3 * act.by, 1)} mm`;

/** In words, for who hears the page. */
export function told(act: Act): string {
  const value = act.kind === 'hit' ? act.speed : act.by;
  const towards = `towards end ${value < 0 ? 1 : 2}`;
  return act.kind === 'hit'
    ? `${digits(Math.abs(act.speed))} m/s ${towards}`
    : `end ${act.end} by ${digits(1e3 * Math.abs(act.by))} mm ${towards}`;
}
