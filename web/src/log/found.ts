// What a log says: the answer, the spring with its intervals, the lines, what speaks for it, what to record next; and the curves that show it.
//
// Next door: what is asked (`form`), who asks (`tabs/log`).

import type { Answer } from '../answer';
import { digits, download, make, rich } from '../dom';
import { curves } from '../plots/curves';

interface Estimate {
  value: number;
  low: number;
  high: number;
}

/** What `coilsense identify --json` prints, as far as it is shown. */
interface Identification {
  verdict: string;
  evidence: string[];
  record_next: string[];
  answer: string[];
  first_frequency_hz: Estimate | null;
  damping_ratio: Estimate | null;
  stiffness_n_per_m: Estimate | null;
  mass_kg: Estimate | null;
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

interface CurveFit {
  answer: string[];
  inverse_length: { alpha_per_h_m: number; beta_per_m: number };
}

export interface LogFacts {
  json: string;
  spectra: string[];
}

const none = new Float64Array();
const list = (items: string[]) =>
  make('ul', { class: 'plainlist' }, ...items.map((text) => make('li', {}, rich(text))));
const card = (title: string, ...children: Node[]) =>
  make(
    'section',
    { class: 'card', 'aria-label': title },
    make('div', { class: 'head' }, make('h2', {}, title)),
    ...children,
  );

export function showFound(host: HTMLElement, name: string, answer: Answer<LogFacts>): void {
  const found = JSON.parse(answer.facts.json) as Identification;
  const figures = make('div', { class: 'figures' });
  const save = () => download(`${name}-identification.json`, answer.facts.json, 'application/json');
  host.replaceChildren(
    make(
      'section',
      { class: 'card verdict', 'aria-label': 'Verdict' },
      ...found.answer.map((line, index) => make(index === 0 ? 'h2' : 'p', {}, rich(line))),
    ),
    card('The spring', numbers(found)),
    card('What speaks for it', list(found.evidence)),
    ...(found.record_next.length > 0 ? [card('What to record next', list(found.record_next))] : []),
    figures,
    card('Lines', lines(found)),
    card('What became of the rows', list(found.account)),
    make(
      'div',
      { class: 'downloads' },
      make('button', { type: 'button', class: 'plain', onclick: save }, 'Everything (JSON)'),
    ),
  );
  draw(figures, found, answer);
}

function numbers(found: Identification): HTMLElement {
  const rows: [string, string, string, Estimate | null, number][] = [
    ['first surge frequency f1', 'Hz', 'first_frequency_hz', found.first_frequency_hz, 1],
    ['damping ratio ζ', '', 'damping_ratio', found.damping_ratio, 1],
    ['stiffness k', 'N/m', 'stiffness_n_per_m', found.stiffness_n_per_m, 1],
    ['mass of the active coil', 'g', 'mass_kg', found.mass_kg, 1e3],
    ['length at zero force', 'mm', 'length_at_zero_force_m', found.length_at_zero_force_m, 1e3],
  ];
  const row = ([label, unit, key, value, factor]: (typeof rows)[number]) =>
    make(
      'tr',
      { 'data-quantity': key },
      make('th', { scope: 'row' }, label),
      ...(value
        ? [value.value, value.low, value.high].map((one) => make('td', {}, `${digits(factor * one, 4)} ${unit}`))
        : [
            make(
              'td',
              { colspan: 3, class: 'words' },
              key === 'stiffness_n_per_m' ? (found.no_stiffness_because ?? 'not found') : 'not found',
            ),
          ]),
    );
  const heads = ['Value', 'from', 'to'].map((text) => make('th', { scope: 'col' }, text));
  return make(
    'div',
    { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'The spring in numbers' },
    make(
      'table',
      {},
      make('caption', {}, 'With intervals that hold in 95 of 100 cases.'),
      make('thead', {}, make('tr', {}, make('th', { scope: 'col' }, 'Quantity'), ...heads)),
      make('tbody', {}, ...rows.map(row)),
    ),
  );
}

function lines(found: Identification): HTMLElement {
  const row = ({ frequency_hz, damping_ratio, kind, number, reason }: Identification['lines'][number]) =>
    make(
      'tr',
      {},
      make('th', { scope: 'row' }, `${digits(frequency_hz.value, 4)} Hz`),
      make('td', {}, damping_ratio ? digits(damping_ratio.value, 3) : '–'),
      make('td', {}, number === null ? kind : `${kind} ${number}`),
      make('td', { class: 'words' }, rich(reason)),
    );
  const heads = ['Frequency', 'ζ', 'What', 'Why'].map((text) =>
    make('th', { scope: 'col', class: text === 'Why' ? 'words' : '' }, text),
  );
  return make(
    'div',
    { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Lines one by one' },
    make('table', {}, make('thead', {}, make('tr', {}, ...heads)), make('tbody', {}, ...found.lines.map(row))),
  );
}

function draw(host: HTMLElement, found: Identification, { facts, series }: Answer<LogFacts>): void {
  const of = (name: string) => series[name] ?? none;
  const seen = found.lines.map(({ frequency_hz }) => frequency_hz.value);
  facts.spectra.forEach((label, number) => {
    const frequency = of(`spectrum ${number} frequency`);
    const highest = seen.length > 0 ? 1.15 * Math.max(...seen) : Infinity;
    const past = frequency.findIndex((f) => f > highest);
    const count = past < 0 ? frequency.length : past;
    const named = found.lines.map(({ frequency_hz, kind, number: which }) => ({
      x: frequency_hz.value,
      label: kind === 'mode' ? `f${which}` : kind === 'alias' ? `f${which} folded` : kind === 'unknown' ? '' : kind,
    }));
    curves(host, {
      title: `Spectrum of ${label}`,
      x: { label: 'Frequency [Hz]', values: frequency.subarray(0, count) },
      y: { label: 'Density [N/√Hz]', logarithmic: true },
      curves: [{ look: number === 0 ? 'F_o' : 'F_i', label, values: of(`spectrum ${number}`).subarray(0, count) }],
      marks: named,
    });
  });
  if (of('ring time').length > 1) {
    curves(host, {
      title: 'The strongest tap and what was fitted',
      x: { label: 'Time since the tap [ms]', values: of('ring time'), factor: 1e3 },
      y: { label: 'Force [N]' },
      curves: [
        { look: 'F_i', label: 'recorded', values: of('ring measured') },
        { look: 'F_o', label: 'fitted', values: of('ring fitted') },
      ],
    });
  }
  if (of('length').length > 1)
    dots(host, 'Force over length, means of 0.2 s', ['Length [mm]', 'Force [N]'], of('length'), of('force'), 1);
}

/** Inductance over length. */
export function showCalibration(host: HTMLElement, name: string, answer: Answer<{ json: string }>): void {
  const told = JSON.parse(answer.facts.json) as CurveFit;
  const { alpha_per_h_m: alpha, beta_per_m: beta } = told.inverse_length;
  const save = () => download(`${name}-calibration.json`, answer.facts.json, 'application/json');
  const figures = make('div', { class: 'figures' });
  host.replaceChildren(
    card(
      'Calibration',
      make('p', { class: 'curve' }, `1/l = α L + β, α = ${digits(alpha, 5)} 1/(H m), β = ${digits(beta, 5)} 1/m`),
      list(told.answer),
      make(
        'div',
        { class: 'downloads' },
        make('button', { type: 'button', class: 'plain', onclick: save }, 'Calibration (JSON)'),
      ),
    ),
    figures,
  );
  dots(
    figures,
    'Inductance over length',
    ['Length [mm]', 'L [µH]'],
    answer.series['length'] ?? none,
    answer.series['inductance'] ?? none,
    1e6,
  );
}

function dots(
  host: HTMLElement,
  title: string,
  [x, y]: [string, string],
  lengths: Float64Array,
  values: Float64Array,
  factor: number,
): void {
  const order = [...lengths.keys()].sort((a, b) => (lengths[a] ?? 0) - (lengths[b] ?? 0));
  curves(host, {
    title,
    x: { label: x, values: Float64Array.from(order, (index) => 1e3 * (lengths[index] ?? 0)) },
    y: { label: y },
    curves: [
      { look: 'F_i', label: 'recorded', values: order.map((index) => factor * (values[index] ?? 0)), dots: true },
    ],
  });
}
