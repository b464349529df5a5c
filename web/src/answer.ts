// What the engine says, and what is asked of it: the types on both sides of the worker.
//
// Next door: the worker (`engine.worker`), who asks (`compute`).

export interface Deviation {
  rmsd: number;
  maximum: number;
  maximumAbsolute: number;
  mean: number;
}

export interface Clash {
  smallestPitch: number | null;
  contactPitch: number;
  time: number;
  winding: number;
  firstContact: number | null;
}

export interface SpringFacts {
  name: string;
  material: string;
  byGeometry: boolean;
  stiffness: number;
  mass: number;
  restLength: number;
  minLength: number;
  maxLength: number;
  windings: number;
  /** Whole windings, and masses that stand for each. */
  masses: number;
  massesPerWinding: number;
  coilRadius: number;
  wireDiameter: number;
  contactPitch: number;
  solidLength: number;
  nominalForce: number;
  surgeFrequency: number;
  transitTime: number;
}

export interface ConditionFacts {
  name: string;
  kind: string;
  duration: number;
  window: [number, number];
  sampleRate: number;
}

/** What windings did that were asked to meet, as `results.json` has it. */
export interface ContactFacts {
  /** `e = 0.5`, or `ζ_c = 3`; and whether the spec is silent on it. */
  law: string;
  isAssumed: boolean;
  /** Whether ends meet their seats. */
  ends: boolean;
  /** When windings first met [s], which and how fast [m/s]; null where none did. */
  first: number | null;
  between: string | null;
  speed: number | null;
  touches: number;
  fastest: number;
  /** Energy lost [J]. */
  lost: number;
  pairs: { between: string; touches: number; closed: number; speed: number }[];
  lifts: number;
  /** How long ends were off their seats in all [s]. */
  aloft: number;
  /** Until when a change of the input by a millionth moves no end force by more than `apart` [N]; null in a preview. */
  holdsUntil: number | null;
  apart: number;
  until: number;
}

export interface Facts {
  exact: boolean;
  spring: SpringFacts;
  meanLength: number;
  staticForce: number;
  lines: number[];
  conditions: ConditionFacts[];
  dampings: { label: string; ratio: number | null }[];
  isBand: boolean;
  condition: number;
  damping: number;
  truth: string;
  goal: number | null;
  clash: Clash;
  /** Null where windings pass through one another. */
  contact: ContactFacts | null;
  forces: Record<string, Deviation>;
}

export interface ExactFacts extends Facts {
  lengths: [number, number];
  sensors: { name: string; kind: string; sampleRate: number | null; deviation: Deviation }[];
  warnings: { subject: string; text: string }[];
}

export type Kind = 'axial' | 'torsional' | 'lateral' | 'mixed';

/** A mode and where it shows; side force and couple at end 2 per newton of its axial force, null where it has none. */
export interface Mode {
  frequency_hz: number;
  kind: Kind;
  axial_strength: number;
  side_force_n_per_n: number | null;
  couple_m: number | null;
}

/** The modes of the coil as a helix with its ends held in one way, as `spring --json` has them. */
export interface UnderEnds {
  ends: string;
  buckles: boolean;
  modes: Mode[];
}

/** The same at a length, and with the ends as loose as they may be. */
export interface ModesAt extends UnderEnds {
  length_m: number;
  loosest: UnderEnds | null;
}

/** What the lines of the modes are of; the lines themselves are its series, see `modes/lines`. */
export interface LinesFacts {
  /** How the ends are held; and how as loose as they may be, where that lies between two ways. */
  ends: string[];
  /** Up to where there are lines [Hz]. */
  top: number;
  /** Number of a condition and what drives the spring there [Hz]. */
  driven: [number, number][];
  /** Whether a condition drives every frequency. */
  broad: boolean[];
  /** Whether the forces of the page are of the paper's chain, with this first frequency [Hz]. */
  isChain: boolean;
  modelFrequency: number;
}

/** The modes at a length, and one of them: its positions are x, y, z of points of the wire [m] and how far each moves, the farthest by 1. */
export interface ShapeFacts {
  length: number;
  under: UnderEnds;
  mode: Mode;
  /** At ends 1 and 2 per newton of axial force there, null where there is none. */
  ends: { side_force_n_per_n: number | null; tilting_couple_m: number | null; axis_couple_m: number | null }[];
  windings: number;
  wireDiameter: number;
}

/** Size and phase [rad]; null where it has no limit. */
export type Polar = [number, number] | null;

/** A spring driven by a sine at one end. */
export interface DrivenFacts {
  /** Number of the driven end; whether it is moved, or else pulled by a force; what end 2 is tied to. */
  driven: 1 | 2;
  isMoved: boolean;
  tied: 'position' | 'force' | 'mass';
  /** From where to where there is a curve [Hz]. */
  range: [number, number];
  undamped: boolean;
  /** How far a force may be off to be taken for the one at the driven end [1]. */
  within: number;
}

/** What stands out of the curve of the two ends over frequency; the curve itself is its series. */
export interface CurveFacts extends DrivenFacts {
  /** Up to where the other end, and k times the deflection, may be taken for the driven end [Hz]; null where nowhere. */
  until: { through: number | null; length: number | null };
  /** Where the other end has most of the driven end's force [Hz], and how much of it; null without a limit. */
  peaks: [number, number | null][];
  /** Of the mounted spring, and of the sines that drive the condition [Hz]. */
  modes: number[];
  lines: number[];
}

/** The two ends at one frequency [Hz]; motion along the coil is its series. */
export interface PointFacts extends DrivenFacts {
  frequency: number;
  /** Forces over k times the motion of the driven end, or over its force. */
  own: Polar;
  other: Polar;
  byLength: Polar;
  /** Over the force at the driven end. */
  through: Polar;
  lengthOverOwn: Polar;
  /** How far the other end is off where it is taken for the driven one [1]; null without a limit. */
  off: number | null;
}

export interface PaperFacts {
  cells: {
    table: string;
    spring: string;
    condition: string;
    force: string;
    printed: number;
    computed: Record<'tables' | 'text', { percent: number; differs: boolean; samplingRange: [number, number] | null }>;
  }[];
  warnings: string[];
}

/** What a spec may name: keys and values of each material and each class of sensors, as the engine's tables write them. */
export interface Catalogue {
  /** The material of a spec that names none. */
  usual: string;
  materials: Record<string, string>[];
  sensors: Record<string, string>[];
}

export type Series = Record<string, Float64Array>;

export interface Answer<F> {
  facts: F;
  series: Series;
  /** u1, x_1…x_N, u2 of each sample [m]; empty where nobody asked for them. */
  positions: Float32Array;
}

interface Case {
  text: string;
  condition: number;
  damping: number;
}

/** What only the larger engine answers of a case that is looked at; `masses`: for each winding. */
export type OfResponse =
  | ({ kind: 'response'; masses: number } & Case)
  | ({ kind: 'response-at'; masses: number; frequency: number; places: number } & Case);

export type Question =
  | ({ kind: 'preview'; from: number; to: number; samples: number } & Case)
  | ({ kind: 'exact' } & Case)
  | ({ kind: 'csv' } & Case)
  | { kind: 'modes'; text: string; lengths: number }
  | { kind: 'shape'; text: string; length: number; loosest: boolean; number: number; points: number }
  | OfResponse
  | { kind: 'paper' }
  | { kind: 'catalogue' };

/** A file that the user gave: the worker reads it piece by piece. */
export interface Log {
  name: string;
  file: Blob;
}

/** What only the larger engine answers. */
export type Job =
  | { kind: 'columns' | 'calibrate'; log: Log; asked: string }
  | { kind: 'identify'; log: Log; second: Log | null; asked: string }
  | { kind: 'trial'; text: string; condition: number; damping: number }
  | { kind: 'mitigate-usual' | 'mitigate'; text: string; asked: string }
  | { kind: 'mitigate-log'; text: string; asked: string; log: Log };

/** How an error begins after which the engine is no more to be used. */
export const STOPPED = 'the engine stopped: ';

/** To the worker: first the compiled engine, files as they come, then questions. */
export type ToWorker =
  { engine: WebAssembly.Module } | { file: string; text: string } | { id: number; question: Question };

/** To the larger engine's worker: all of it at once. */
export type ToWorkshop = { engine: WebAssembly.Module; files: Map<string, string>; job: Job };

/** To the worker that judges: a spec with the files that it may name, or that nobody waits for the one before any more. */
export type ToJudge =
  { id: number; engine: WebAssembly.Module; files: Map<string, string>; text: string } | { id: number };

/** From it: how many cases are settled, then the verdict. */
export type FromJudge = { id: number } & ({ told: [number, number] } | { facts: unknown } | { error: string });

/** From the worker while it works: how much is done, and of how much; of a file that is read its name, and bytes. */
export type Told = { told: [number, number, string?] };

/** From the worker. */
export type FromWorker = { id: number; milliseconds: number } & (
  { answer: Answer<unknown> } | { bytes: Uint8Array<ArrayBuffer> } | { text: string } | { error: string }
);
