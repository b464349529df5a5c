// What the engine says of all candidates, and how its numbers are written.
//
// Next door: the same as a table (`table`), as points (`scatter`), one of them over time (`picked`).

import type { Answer } from '../answer';
import { digits, fixed } from '../dom';
import type { Shaping } from './shaping';

export interface Candidate {
  name: string;
  origin: string;
  against: string;
  rms_error_n: number;
  worst_rms_error_n: number;
  worst_run: string;
  lag_at_bandwidth_rad: number;
  noise_gain: number;
}

/** What `coilsense mitigate --json` prints, as far as it is shown. */
export interface Ranking {
  advice: string[];
  nominal_force_n: number;
  sampling_rate_hz: number;
  /** Where a number is from; null where it was asked for. */
  sampling_rate_from: string | null;
  noise_n: number;
  noise_from: string | null;
  stiffness_tolerance: number;
  stiffness_tolerance_from: string | null;
  mass_tolerance: number;
  mass_tolerance_from: string | null;
  bandwidth_hz: number;
  most_lag_rad: number;
  log: string | null;
  seeds: number;
  candidates: Candidate[];
  left_out: { name: string; reason: string }[];
  /** Where a condition moves u1. */
  command_shaping: Shaping | null;
}

/** Settings in one precision: the name they have, and the files by their endings. */
export interface Export {
  name: string;
  h: string;
  rs: string;
  json: string;
}

export interface Facts {
  json: string;
  best: (number | null)[];
  run: string | null;
  exports: ({ single: Export; double: Export } | null)[];
}

export interface Judged {
  ranking: Ranking;
  answer: Answer<Facts>;
}

/** What is true, and what those are that are held against it. */
export const GROUPS = [
  ['k·Δl', 'Filters of F_i, held against k·Δl'],
  ['F_o', 'Estimators, held against F_o'],
] as const;

const IN_DEGREES = 180 / Math.PI;
/** In degrees, as are all angles that are shown. */
export const lag = (one: Candidate): number => IN_DEGREES * one.lag_at_bandwidth_rad;
export const mostLag = ({ ranking }: Judged): number => IN_DEGREES * ranking.most_lag_rad;
export const share = ({ ranking }: Judged, force: number): number => (100 * force) / ranking.nominal_force_n;
export const percent = (judged: Judged, force: number): string => `${fixed(share(judged, force), 3)} %`;
/** A lag without a sign before a zero. */
export const degrees = (angle: number): string => `${fixed(Math.round(10 * angle) / 10 + 0, 1)}°`;

/** Candidates that are to give `truth`, with their numbers in the ranking, best first. */
export const those = ({ ranking }: Judged, truth: string): { one: Candidate; number: number }[] =>
  ranking.candidates.map((one, number) => ({ one, number })).filter(({ one }) => one.against === truth);

/** A candidate in one line. */
export const told = (judged: Judged, one: Candidate): string =>
  `${one.name}: ${percent(judged, one.worst_rms_error_n)} at worst, ${percent(judged, one.rms_error_n)} on the nominal spring, ${degrees(lag(one))} late`;

/** On what they were judged. */
export function conditions({ ranking }: Judged): string {
  const [rate, noise, bandwidth] = [ranking.sampling_rate_hz, ranking.noise_n, ranking.bandwidth_hz].map((value) =>
    digits(value),
  );
  const from = (words: string | null) => (words === null ? '' : ` (${words})`);
  const off = (tolerance: number, words: string | null) => `±${digits(100 * tolerance)} %${from(words)}`;
  const k = off(ranking.stiffness_tolerance, ranking.stiffness_tolerance_from);
  const m = off(ranking.mass_tolerance, ranking.mass_tolerance_from);
  const noisy = `${noise} N rms of noise${from(ranking.noise_from)}`;
  const series = ranking.seeds === 1 ? 'one series' : `${ranking.seeds} series`;
  return ranking.log === null
    ? `Sampled at ${rate} Hz${from(ranking.sampling_rate_from)} with ${noisy}, ${series}; k ${k}, m ${m}; lag at ${bandwidth} Hz.`
    : `On ${ranking.log} as recorded, ${rate} Hz: no noise added and no box, so that worst is what it leaves there; designs for ${noisy}, k ${k}, m ${m}; lag at ${bandwidth} Hz.`;
}
