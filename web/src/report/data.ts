// The block of JSON in a report, unpacked and checked. Its form is described beside the report's writer, in
// `crates/coilsense-lab/src/report/viewer/README.md`.
//
// Next door: what is shown of it (`charts`, `signals`, `spring/player`).

import { clamp } from '../dom';
import { KNOWN, look, type Look } from '../plots/looks';
import type { Coil, Frames } from '../spring/scene';

export interface Report {
  spring: string;
  nominal_force_n: number;
  reference: string;
  cases: PackedCase[];
}

/** A condition at a damping, as it is written. */
export interface PackedCase {
  id: string;
  condition: string;
  damping: string;
  start_s: number;
  step_s: number;
  count: number;
  signals: { name: string; kind: 'force' | 'position'; offset: number; data: string }[];
  goal_n: number | null;
  surge_lines_hz: number[];
  first_contact_s: number | null;
  windings: PackedWindings | null;
}

interface PackedWindings {
  count: number;
  frames: number;
  start_s: number;
  step_s: number;
  wire_diameter_m: number;
  coil_radius_m: number;
  contact_pitch_m: number;
  gaps_per_pitch: number;
  metres_per_unit: number;
  zero_m: number;
  data: string;
}

export interface Signal {
  name: string;
  kind: 'force' | 'position';
  unit: 'N' | 'mm';
  look: Look;
  /** In its unit; NaN is a gap. */
  values: Float64Array;
  /** How many decimals say something. */
  decimals: number;
  /** Of a force that is judged: its error [N], and the largest one of the case. */
  error: Float64Array | null;
  worst: number;
}

export interface Case {
  packed: PackedCase;
  times: Float64Array;
  signals: Signal[];
  /** How many decimals of an error say something. */
  decimals: number;
  windings: { frames: Frames; coil: Coil; gapsPerPitch: number } | null;
}

/** Dashes of what has no look of its own, so that lines differ on paper without colours, too. */
const DASHES = [
  [12, 3],
  [4, 3],
  [12, 3, 4, 3],
  [9, 3, 2, 3, 2, 3],
  [2, 4],
  [7, 2],
];

/** What a report holds; throws where that cannot be read. */
export function read(text: string): Report {
  let report: Partial<Report> | null;
  try {
    report = JSON.parse(text) as Partial<Report> | null;
  } catch {
    throw new Error('its data end early or are no JSON');
  }
  if (!report?.cases?.length) throw new Error('it holds no case');
  return report as Report;
}

/** Least and largest value between two samples; null where all are gaps. */
export function extent(values: Float64Array, first = 0, last = values.length - 1): [number, number] | null {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values.subarray(first, last + 1)) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? [low, high] : null;
}

/** Decimals that show about a thousandth of a span. */
const decimalsOf = (span: number): number => (span > 0 ? clamp(3 - Math.ceil(Math.log10(span)), 0, 6) : 3);
const spanOf = (values: Float64Array): number => {
  const [low, high] = extent(values) ?? [0, 0];
  return high - low;
};

/** A case, unpacked; throws where it is damaged. */
export function unpack(report: Report, packed: PackedCase): Case {
  const { count, start_s, step_s } = packed;
  if (!(Number.isInteger(count) && count > 1 && step_s > 0 && Number.isFinite(start_s)))
    throw new Error('its times are damaged');
  const signals = packed.signals.map((signal, index) => unpackSignal(packed, signal, index));
  judge(signals, report.reference);
  for (const signal of signals)
    signal.decimals = decimalsOf(
      Math.max(...signals.filter(({ kind }) => kind === signal.kind).map(({ values }) => spanOf(values))),
    );
  return {
    packed,
    times: Float64Array.from({ length: count }, (_, index) => start_s + index * step_s),
    signals,
    decimals: decimalsOf(2 * Math.max(0, ...signals.map(({ worst }) => worst))),
    windings: packed.windings && unpackWindings(report, packed.windings),
  };
}

function unpackSignal(packed: PackedCase, given: PackedCase['signals'][number], index: number): Signal {
  const { name, kind, offset, data } = given;
  const view = bytes(data, `the signal ${name}`, 4 * packed.count);
  const [unit, factor] = kind === 'position' ? (['mm', 1e3] as const) : (['N', 1] as const);
  const values = Float64Array.from(
    { length: packed.count },
    (_, at) => factor * (offset + view.getFloat32(4 * at, true)),
  );
  // Sensors take turns, in the order of the case, which is that of all cases.
  const turn = packed.signals.slice(0, index).filter((before) => !(before.name in KNOWN)).length;
  const turned = { ...look(`reading ${turn}`), width: 1.5, dash: DASHES[turn % DASHES.length] ?? [] };
  return { name, kind, unit, look: KNOWN[name] ?? turned, values, decimals: 0, error: null, worst: 0 };
}

/** Each force against the reference. What has no sample beside it is not judged: it must not seem to meet a goal. */
function judge(signals: Signal[], reference: string): void {
  const truth = signals.find(({ name }) => name === reference)?.values;
  for (const signal of signals) {
    if (!truth || signal.name === reference || signal.kind !== 'force') continue;
    const error = signal.values.map((value, index) => value - (truth[index] ?? NaN));
    const found = extent(error);
    if (found) [signal.error, signal.worst] = [error, Math.max(-found[0], found[1])];
  }
}

function unpackWindings(report: Report, given: PackedWindings): Case['windings'] {
  const columns = given.count + 2;
  const view = bytes(given.data, 'the windings', 2 * columns * given.frames);
  const { zero_m: zero, metres_per_unit: unit } = given;
  return {
    frames: {
      columns,
      times: Float64Array.from({ length: given.frames }, (_, frame) => given.start_s + frame * given.step_s),
      positions: Float32Array.from(
        { length: columns * given.frames },
        (_, at) => zero + unit * view.getInt16(2 * at, true),
      ),
    },
    coil: {
      name: report.spring,
      masses: given.count,
      coilRadius: given.coil_radius_m,
      wireDiameter: given.wire_diameter_m,
      contactPitch: given.contact_pitch_m,
      nominalForce: report.nominal_force_n,
    },
    gapsPerPitch: given.gaps_per_pitch,
  };
}

/** What base64 stands for, of this many bytes; `what` says whose they are. */
function bytes(text: string, what: string, count: number): DataView {
  let raw: string;
  try {
    raw = atob(text);
  } catch {
    throw new Error(`${what}: its numbers cannot be read`);
  }
  if (raw.length !== count) throw new Error(`${what}: ${raw.length} bytes, not ${count}`);
  return new DataView(Uint8Array.from(raw, (letter) => letter.charCodeAt(0)).buffer);
}
