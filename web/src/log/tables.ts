// The spring and its lines in numbers.
//
// Next door: what is said of them in words (`found`), drawn (`pictures`).

import { digits, make, rich } from '../dom';
import type { Estimate, Identification } from './identification';

/** So many digits that the interval's ends differ, and four at least. */
function telling({ value, low, high }: Estimate): number {
  const places = Math.ceil(Math.log10(Math.abs(value) / Math.max(high - low, 1e-12 * Math.abs(value))));
  return Number.isFinite(places) ? Math.min(Math.max(places + 2, 4), 9) : 4;
}

export function numbers(found: Identification): HTMLElement {
  // What a mount may do to f1 is part of its interval.
  const within = (estimate: Estimate | null, range: [number, number] | null): Estimate | null =>
    estimate && range ? { ...estimate, low: range[0], high: range[1] } : estimate;
  const mode = found.damping_ratio_mode ?? 1;
  const rows: [string, string, string, Estimate | null, number][] = [
    [
      'first surge frequency f1',
      'Hz',
      'first_frequency_hz',
      within(found.first_frequency_hz, found.first_frequency_range_hz),
      1,
    ],
    [mode === 1 ? 'damping ratio ζ' : `damping ratio ζ of mode ${mode}`, '', 'damping_ratio', found.damping_ratio, 1],
    ['stiffness k', 'N/m', 'stiffness_n_per_m', found.stiffness_n_per_m, 1],
    ['mass of the active coil', 'g', 'mass_kg', within(found.mass_kg, found.mass_range_kg), 1e3],
    ['length at zero force', 'mm', 'length_at_zero_force_m', found.length_at_zero_force_m, 1e3],
  ];
  const row = ([label, unit, key, value, factor]: (typeof rows)[number]) =>
    make(
      'tr',
      { 'data-quantity': key },
      make('th', { scope: 'row' }, label),
      ...(value
        ? [value.value, value.low, value.high].map((one) =>
            make('td', {}, `${digits(factor * one, telling(value))} ${unit}`),
          )
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

export function lines(found: Identification): HTMLElement {
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
