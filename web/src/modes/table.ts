// All modes at one length with the ends held in one way; one of them is picked.
//
// Next door: the same over length (`chart`), the picked one (`wire`).

import type { UnderEnds } from '../answer';
import { digits, make } from '../dom';
import { sample } from '../plots/looks';
import { LOOKS } from './kinds';

/** Modes that are told. */
const SHOWN = 10;
const HEADS = ['Mode', 'Kind', 'Line', 'Side force', 'Couple'];

export class Table {
  private readonly caption = make('caption');
  private readonly body = make('tbody');
  readonly element = make(
    'div',
    { class: 'of-length' },
    make(
      'div',
      { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Modes of the coil' },
      make(
        'table',
        { class: 'modes' },
        this.caption,
        make('thead', {}, make('tr', {}, ...HEADS.map((text) => make('th', { scope: 'col' }, text)))),
        this.body,
      ),
    ),
    make(
      'p',
      { class: 'facts' },
      'Line: how strong a mode stands in the axial force, in % of an axial mode of a bar. Side force and couple at end 2 go with one newton of its axial force. Pick a mode to see it move.',
    ),
  );

  constructor(private readonly picked: (number: number) => void) {}

  show({ ends, buckles, modes }: UnderEnds, chosen: number): void {
    this.caption.textContent = `Lowest modes, ${ends}.${buckles ? ' The spring buckles at this length: these are of one that a guide keeps straight.' : ''}`;
    const focused = this.body.contains(document.activeElement)
      ? document.activeElement?.closest('tr')?.getAttribute('data-number')
      : null;
    const row = (mode: UnderEnds['modes'][number], index: number) => this.row(mode, index + 1, chosen);
    this.body.replaceChildren(...modes.slice(0, Math.max(SHOWN, chosen)).map(row));
    if (focused) this.body.querySelector<HTMLElement>(`tr[data-number="${focused}"] button`)?.focus();
  }

  clear(): void {
    this.caption.textContent = '';
    this.body.replaceChildren();
  }

  private row(mode: UnderEnds['modes'][number], number: number, chosen: number): HTMLElement {
    const { kind, frequency_hz } = mode;
    const cell = (value: number | null, scale: number, unit: string) =>
      make('td', {}, value === null ? '–' : `${digits(scale * value)} ${unit}`);
    const pick = make(
      'button',
      {
        type: 'button',
        class: 'line pick',
        'aria-pressed': String(number === chosen),
        onclick: () => this.picked(number),
      },
      sample(LOOKS[kind]),
      make('span', {}, `${frequency_hz.toFixed(1)} Hz`),
    );
    return make(
      'tr',
      { 'data-kind': kind, 'data-number': number },
      make('th', { scope: 'row' }, pick),
      make('td', {}, kind),
      cell(mode.axial_strength, 100, '%'),
      cell(mode.side_force_n_per_n, 1, 'N/N'),
      cell(mode.couple_m, 1e3, 'mm'),
    );
  }
}
