// What the engine says of a log: the command's own JSON, and what the page shows beside it.
//
// Next door: who shows it (`found`, `tables`, `pictures`, `recorded`).

export interface Estimate {
  value: number;
  low: number;
  high: number;
}

/** What `coilsense identify --json` prints, as far as it is shown. */
export interface Identification {
  verdict: string;
  evidence: string[];
  record_next: string[];
  answer: string[];
  first_frequency_hz: Estimate | null;
  first_frequency_range_hz: [number, number] | null;
  damping_ratio: Estimate | null;
  damping_ratio_mode: number | null;
  stiffness_n_per_m: Estimate | null;
  mass_kg: Estimate | null;
  mass_range_kg: [number, number] | null;
  length_at_zero_force_m: Estimate | null;
  no_stiffness_because: string | null;
  lines: {
    frequency_hz: Estimate;
    damping_ratio: Estimate | null;
    kind: string;
    number: number | null;
    reason: string;
  }[];
  account: string[];
}

/** Of every log that can be read. */
export interface Recorded {
  /** Rows of which the smallest and the largest value are drawn; 1 where all are. */
  group: number;
  /** What the log says of its being simulated. */
  simulated: string | null;
  /** The second device's clock. */
  clock: {
    file: string;
    /** What was added to its times [s]. */
    offset: number;
    found: {
      channels: [string, string];
      halfWidth: number;
      drift: [number, number] | null;
      correlation: number;
    } | null;
  } | null;
  /** When it was struck [s]. */
  hits?: number[];
  /** Why it says nothing. */
  refusal?: string;
}

/** Of a log that says something. */
export interface Said extends Recorded {
  json: string;
  spectra: string[];
  spec: string | null;
  noSpecBecause: string | null;
}

export const saysSomething = (facts: Recorded): facts is Said => 'json' in facts;
