// Inductance over length: the curve through it, and the theories of the coil beside it.
//
// Next door: the numbers (`coilsense-web`, `log/calibrated`), what else a log says (`found`).

import type { Answer } from '../answer';
import { digits, make } from '../dom';
import { download } from '../download';
import { curves } from '../plots/curves';
import type { Look } from '../plots/looks';
import { button, card, list } from './found';
import { permeability } from './permeability';

interface Misfit {
  r2: number;
  rmse_m: number;
  rmse_percent_of_range: number;
  largest_residual_m: number;
}

/** What `coilsense calibrate --json` prints, as far as it is shown. */
interface Calibration {
  answer: string[];
  account: string[];
  relation: 'inverse-length' | 'cubic' | 'steel';
  length_rms_percent_of_range: number | null;
  judged_on: 'others' | 'all';
  steel: { relative_permeability: number; offset_h: number } | null;
  cubic: { alpha_h_m: number; beta_h: number; gamma_h_m2: number } | null;
  inverse_length: Misfit & { alpha_per_h_m: number; beta_per_m: number };
  inductance: Misfit;
  theories: ({ name: string; refused: string | null } & Partial<Misfit>)[];
}

/** What the engine tells beside it: for which permeabilities of its wire the coil was computed. */
export interface Told {
  json: string;
  permeabilities: number[] | null;
}

const none = new Float64Array();

export function showCalibration(host: HTMLElement, name: string, answer: Answer<Told>): void {
  const told = JSON.parse(answer.facts.json) as Calibration;
  const save = () => download(`${name}-calibration.json`, answer.facts.json, 'application/json');
  const figures = make('div', { class: 'figures wide' });
  const ask =
    'Say under “The spring” that it is that of the tab Spring, or its windings, coil radius and wire: then theories are compared.';
  host.replaceChildren(
    card(
      'Calibration',
      make('p', { class: 'curve' }, fitted(told)),
      list(told.answer),
      table(told),
      ...(told.theories.length === 0 ? [make('p', { class: 'hint' }, ask)] : []),
      make('details', {}, make('summary', {}, 'What became of the rows'), list(told.account)),
      make('div', { class: 'downloads' }, button('Calibration (JSON)', save)),
    ),
    ...magnetic(told, answer),
    figures,
  );
  draw(figures, told, answer);
}

/** What magnetic wire would make of the coil, where it is known. */
function magnetic(told: Calibration, { facts: { permeabilities }, series }: Answer<Told>): HTMLElement[] {
  const [lengths, measured, fit] = [series['length'], series['inductance'], series['fit at points']];
  if (!permeabilities || !lengths || !measured || !fit) return [];
  return [
    permeability({
      permeabilities,
      inductances: permeabilities.map((_, number) => series[`permeable ${number}`] ?? none),
      lengths,
      measured,
      alpha: told.inverse_length.alpha_per_h_m,
      left: measured.map((value, index) => value - (fit[index] ?? NaN)),
      fitted: told.steel?.relative_permeability ?? null,
    }),
  ];
}

/** The calibration that was asked for, in a line. */
function fitted({ inverse_length, steel, cubic }: Calibration): string {
  if (steel) {
    const { relative_permeability: permeability, offset_h: offset } = steel;
    return `Magnetic wire: relative permeability ${digits(permeability, 4)}, constant ${digits(1e9 * offset, 4)} nH`;
  }
  if (cubic) {
    const { alpha_h_m: alpha, beta_h: beta, gamma_h_m2: gamma } = cubic;
    const numbers = `α = ${digits(1e6 * alpha, 5)} µH m, β = ${digits(1e6 * beta, 5)} µH, γ = ${digits(1e6 * gamma, 5)} µH m²`;
    return `L = α/l + β + γ/l², ${numbers}`;
  }
  const { alpha_per_h_m: alpha, beta_per_m: beta } = inverse_length;
  return `1/l = α L + β, α = ${digits(alpha, 5)} 1/(H m), β = ${digits(beta, 5)} 1/m`;
}

/** The calibration that was asked for, eq. (13)'s curve both ways, then the theories, the nearest first. */
function table(told: Calibration): HTMLElement {
  const { inverse_length, inductance, theories } = told;
  const far = (theory: Calibration['theories'][number]) => theory.rmse_m ?? Infinity;
  const rows: [string, Partial<Misfit>, string | null][] = [
    ...taken(told),
    ['fit 1/l = αL + β', inverse_length, null],
    ['fit L = α/l + β', inductance, null],
    ...[...theories]
      .sort((a, b) => far(a) - far(b))
      .map((theory): (typeof rows)[number] => [theory.name, theory, theory.refused]),
  ];
  const row = ([name, misfit, refused]: (typeof rows)[number]) => {
    const { r2, rmse_m, rmse_percent_of_range, largest_residual_m } = misfit;
    const numbers = [
      digits(r2 ?? NaN, 6),
      `${digits(1e3 * (rmse_m ?? NaN), 4)} mm`,
      `${digits(rmse_percent_of_range ?? NaN, 4)} %`,
      `${digits(1e3 * (largest_residual_m ?? NaN), 4)} mm`,
    ].map((text) => make('td', {}, text));
    const cells = refused === null ? numbers : [make('td', { colspan: 4, class: 'words' }, refused)];
    return make('tr', { 'data-theory': name }, make('th', { scope: 'row' }, name), ...cells);
  };
  const heads = ['Curve', 'R²', 'RMSE', 'of the range', 'at most'].map((text) => make('th', { scope: 'col' }, text));
  return make(
    'div',
    { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Curves one by one' },
    make(
      'table',
      {},
      make('caption', {}, 'How far off the length is that each reads from the inductances.'),
      make('thead', {}, make('tr', {}, ...heads)),
      make('tbody', {}, ...rows.map(row)),
    ),
  );
}

/** The row of another calibration than 1/l = αL + β. */
function taken({
  relation,
  length_rms_percent_of_range: percent,
  judged_on: on,
}: Calibration): [string, object, string][] {
  if (relation === 'inverse-length') return [];
  const name = relation === 'steel' ? 'fit of magnetic wire' : 'fit L = α/l + β + γ/l²';
  const where = on === 'others' ? 'on the points left over' : 'on all points';
  return [
    [
      name,
      {},
      percent === null ? 'some points have no length on it' : `${digits(percent, 4)} % of the range RMS ${where}`,
    ],
  ];
}

const COLOURS = ['blue', 'green', 'red', 'soft'] as const;
const DASHES = [
  [8, 4],
  [2, 3],
  [10, 3, 2, 3],
] as const;
/** Each theory alone: colours first, then dashes. */
const theoryLook = (number: number): Look => ({
  colour: COLOURS[number % COLOURS.length] ?? 'soft',
  dash: [...(DASHES[Math.floor(number / COLOURS.length) % DASHES.length] ?? [])],
  width: 1.4,
});

function draw(host: HTMLElement, told: Calibration, { series }: Answer<unknown>): void {
  const of = (name: string) => series[name] ?? none;
  const [lengths, drawn] = [of('length'), of('drawn length')];
  // One axis for dots and curves: all their lengths, with nothing where the other has a point.
  const all = Float64Array.from(new Set([...lengths, ...drawn])).sort();
  const place = new Map(Array.from(all, (length, index) => [length, index]));
  const on = (at: Float64Array, values: Float64Array) => {
    const spread = new Array<number | null>(all.length).fill(null);
    values.forEach((value, index) => (spread[place.get(at[index] ?? NaN) ?? -1] = 1e6 * value));
    return spread;
  };
  curves(host, {
    title: 'Inductance over length',
    x: { label: 'Length [mm]', values: all.map((length) => 1e3 * length) },
    y: { label: 'L [µH]' },
    curves: [
      { look: 'F_i', label: 'recorded', values: on(lengths, of('inductance')), dots: true },
      { look: 'F_L', label: 'fit', values: on(drawn, of('fit')), spans: true },
      ...told.theories.map(({ name }, number) => ({
        look: theoryLook(number),
        label: name,
        values: on(drawn, of(`theory ${number}`)),
        spans: true,
      })),
    ],
  });
}
