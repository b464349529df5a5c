// What `coilsense analyze --json` prints, as far as the page shows it.
//
// Next door: who asks for it (`judge`), the card that shows it (`verdict`).

/** One sensor's verdict in its worst case. */
export interface Ranked {
  sensor: string;
  combined_n: number;
  combined_percent: number;
  worst_condition: string;
  worst_damping: string;
  /** Null where the spec has no goal. */
  meets_goal: boolean | null;
  bandwidth_hz: number | null;
  lag_s: number;
  share_inside_goal: number | null;
  worst_specimen_n: number;
  nominal_n: number;
  fixes: { change: string; combined_n: number; lag_s: number | null }[];
}

export interface Outcome {
  /** The answer as the command prints it, a sentence each. */
  answer: string[];
  goal: { error_n: number | null; bandwidth_hz: number | null; force: string };
  nominal_force_n: number;
  ranking: Ranked[];
}
