// The keys of a spec that the page lets people set, in their words. What a value may be is for the engine to say.
//
// Next door: how a field looks and works (`inputs`).

import type { Spec } from './document';

export interface Field {
  key: string;
  label: string;
  /** A word or two on what it does. */
  hint?: string;
  /** A slider beside it: from a share of the preset's value to a multiple of it, evenly or by factors. */
  slide?: { from: number; to: number; scale: 'linear' | 'log'; whole?: boolean };
  /** What holds where nothing is said, with its unit: the slider begins there. */
  usual?: string;
  /** One of these words, the first being what holds where nothing is said. */
  words?: readonly string[];
  /** How people call them, where otherwise. */
  names?: Readonly<Record<string, string>>;
  /** What else changes with it: the spec with its new value, and what must go or come with that. */
  then?: (spec: Spec) => Spec;
  /** One of these of the engine's catalogue, or none. */
  list?: 'materials' | 'sensors';
  /** On a line of its own, since its words are long. */
  wide?: boolean;
  /** Two values, as a list in the spec. */
  pair?: boolean;
  /** A number without a unit. */
  number?: boolean;
  /** Words of the user's own. */
  free?: boolean;
}

const log = (factor: number) => ({ from: 1 / factor, to: factor, scale: 'log' as const });
const around = { from: 0.7, to: 1.4, scale: 'linear' as const };

/** Of a spring by its values, the telling ones first. */
export const BY_VALUES: readonly Field[] = [
  { key: 'stiffness', label: 'Stiffness k', hint: 'stiffer rings faster', slide: log(4) },
  { key: 'mass', label: 'Mass m', hint: 'of the windings: heavier rings slower', slide: log(4) },
];
export const SHAPE: readonly Field[] = [
  { key: 'windings', label: 'Windings N', number: true, slide: { ...around, from: 0.2, to: 2, whole: true } },
  { key: 'rest_length', label: 'Rest length l0', slide: around },
  { key: 'min_length', label: 'Shortest in use', slide: around },
  { key: 'max_length', label: 'Longest in use', slide: around },
];
const MATERIAL: Field = { key: 'material', label: 'Material', list: 'materials', wide: true };
export const RADII: readonly Field[] = [
  { key: 'coil_radius', label: 'Coil radius r', hint: 'to the centre of the wire', slide: around },
  { key: 'wire_radius', label: 'Wire radius ρ', slide: around },
  MATERIAL,
];
/** Of a spring by its geometry. */
export const BY_GEOMETRY: readonly Field[] = [
  { key: 'wire_diameter', label: 'Wire diameter d', hint: 'its fourth power is in k', slide: around },
  { key: 'coil_diameter', label: 'Coil diameter D', hint: 'mean, wire centre to wire centre', slide: around },
];
export const ENDS: readonly Field[] = [
  MATERIAL,
  { key: 'end_type', label: 'Ends', wide: true, words: ['hooks', 'open', 'open-ground', 'closed', 'closed-ground'] },
  { key: 'initial_tension', label: 'Initial tension F0' },
];

const LENGTH: Field = { key: 'length', label: 'Mean length', hint: 'min, mid, max, a length, or a share of the range' };
const PROFILE: Field = { key: 'profile', label: 'Windings move', words: ['uniform', 'linear'] };
const AMPLITUDE: Field = {
  key: 'amplitude',
  label: 'Amplitude',
  hint: 'a length, or a share of the range',
  slide: { from: 0, to: 4, scale: 'linear' },
};
const START: Field = { key: 'start', label: 'Windings begin', words: ['rest', 'massless'] };
const BEGIN: Field = { key: 'begin', label: 'When' };
const END: Field = { key: 'end', label: 'Driven end', number: true };

/** Of each kind of condition, the one to drag first. */
export const CONDITION: Record<string, { first: readonly Field[]; more: readonly Field[] }> = {
  impact: {
    first: [
      {
        key: 'velocity',
        label: 'How hard it is hit',
        hint: 'speed of the windings at t = 0',
        slide: { from: 0, to: 4, scale: 'linear' },
      },
    ],
    more: [LENGTH, PROFILE],
  },
  'end-stop': {
    first: [{ key: 'velocity', label: 'Speed at the stop', hint: 'left out: the range in 1 s' }],
    more: [{ key: 'at', label: 'Stopped at', words: ['min', 'max'] }, PROFILE],
  },
  harmonic: {
    first: [
      {
        key: 'frequency',
        label: 'Frequency',
        hint: 'in Hz, or in surge frequencies: 0.5 f1',
        slide: { from: 0.1, to: 2, scale: 'linear' },
      },
      AMPLITUDE,
    ],
    more: [LENGTH, { key: 'phase', label: 'Phase at t = 0' }, START, END],
  },
  sweep: {
    first: [{ key: 'frequency', label: 'Frequency from, to', pair: true }, AMPLITUDE],
    more: [LENGTH, START, END],
  },
  step: { first: [AMPLITUDE], more: [LENGTH, BEGIN, END] },
  ramp: {
    first: [AMPLITUDE, { key: 'rise_time', label: 'How long it takes', slide: { from: 0.05, to: 4, scale: 'linear' } }],
    more: [LENGTH, BEGIN, END],
  },
  pulse: {
    first: [AMPLITUDE, { key: 'width', label: 'How long it lasts', slide: { from: 0.05, to: 4, scale: 'linear' } }],
    more: [LENGTH, BEGIN, END],
  },
  recorded: {
    first: [
      {
        key: 'playback_speed',
        label: 'Speed of the recording',
        slide: { from: 0.4, to: 1.6, scale: 'linear' },
        usual: '100 %',
      },
    ],
    more: [LENGTH, START],
  },
};
export const TIMING: readonly Field[] = [
  { key: 'duration', label: 'Simulated for' },
  { key: 'window', label: 'Judged from, to', pair: true },
  { key: 'sample_rate', label: 'Samples' },
];

export const SENSOR: readonly Field[] = [
  { key: 'name', label: 'Name', wide: true, free: true },
  { key: 'kind', label: 'Kind', wide: true, words: ['load-cell', 'deflection', 'two-encoder', 'inductance'] },
  { key: 'class', label: 'Like', list: 'sensors', wide: true },
  { key: 'end', label: 'At end', number: true },
  { key: 'bandwidth', label: 'Bandwidth (−3 dB)' },
  { key: 'delay', label: 'Delay' },
  { key: 'averaging', label: 'Averaged over' },
  { key: 'sample_rate', label: 'Sampled at' },
  { key: 'noise', label: 'Noise, rms' },
  { key: 'resolution', label: 'Resolution' },
];

export const GOAL: readonly Field[] = [
  {
    key: 'error',
    label: 'Your limit',
    hint: 'standard uncertainty, of F_nom or in N',
    slide: { from: 0.05, to: 5, scale: 'log' },
  },
  {
    key: 'force',
    label: 'Force taken as true',
    words: ['F_x', 'F_i', 'F_o'],
    names: { F_x: 'k × stretch', F_i: 'at end 1', F_o: 'at end 2' },
  },
  { key: 'bandwidth', label: 'Bandwidth', hint: 'of the goal; left empty, errors of every frequency count' },
];

/** How far real springs are off, to either side: of a spring by values, by geometry, and of any. */
export const OFF_VALUES: readonly Field[] = [
  { key: 'stiffness_tolerance', label: 'k, ±' },
  { key: 'mass_tolerance', label: 'm, ±' },
];
export const OFF_GEOMETRY: readonly Field[] = [
  { key: 'stiffness_tolerance', label: 'k, ±', hint: 'as measured; else of wire, coil and G' },
  { key: 'wire_diameter_tolerance', label: 'd, ±' },
  { key: 'coil_diameter_tolerance', label: 'D, ±' },
  { key: 'shear_modulus_tolerance', label: 'G, ±' },
];
export const OFF_LENGTH: readonly Field[] = [{ key: 'rest_length_tolerance', label: 'l0, ±', hint: 'a length' }];
export const WARMTH: readonly Field[] = [
  { key: 'temperature_change', label: 'ΔT, ±', hint: 'of temperature, since the calibration' },
];

/** What a condition that the user adds begins as; lengths and shares fit every spring. */
export const TEMPLATES: Record<string, Record<string, string | number | string[]>> = {
  impact: { kind: 'impact', velocity: '0.25 m/s' },
  'end-stop': { kind: 'end-stop', at: 'max' },
  harmonic: { kind: 'harmonic', frequency: '0.5 f1', amplitude: '1 %', phase: '-90 deg', start: 'massless' },
  sweep: { kind: 'sweep', frequency: ['0.2 f1', '1.2 f1'], amplitude: '0.5 %' },
  step: { kind: 'step', amplitude: '2 %', begin: '5 ms' },
  ramp: { kind: 'ramp', amplitude: '10 %', begin: '5 ms', rise_time: '20 ms' },
  pulse: { kind: 'pulse', amplitude: '5 %', begin: '5 ms', width: '10 ms' },
};
