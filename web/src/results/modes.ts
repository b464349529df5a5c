// Every mode of the coil: what rings, and where it shows; one length and one way of the ends at a time.
//
// Next door: what of it a reader must know (`warnings`).

import type { ExactFacts, ModesAt } from '../answer';
import { digits, make } from '../dom';

interface Choice {
  words: string;
  buckles: boolean;
  modes: ModesAt['modes'];
}

const HEADS = ['Frequency', 'Kind', 'Line', 'Side force', 'Couple'];

export class Modes {
  private readonly select = make('select', { 'aria-label': 'Length and ends' });
  private readonly body = make('tbody');
  private readonly element = make(
    'details',
    {},
    make('summary', {}, 'Every mode of the coil'),
    make(
      'p',
      { class: 'facts' },
      'The wire as a helix. Line: how strong a mode stands in the axial force, in % of an axial mode of a bar. Side force and couple at end 2 go with one newton of its axial force.',
    ),
    this.select,
    make(
      'div',
      { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Modes of the coil' },
      make(
        'table',
        { class: 'modes' },
        make('thead', {}, make('tr', {}, ...HEADS.map((text) => make('th', { scope: 'col' }, text)))),
        this.body,
      ),
    ),
  );
  private choices: Choice[] = [];

  constructor(host: HTMLElement) {
    host.replaceChildren(this.element);
    this.select.addEventListener('change', () => this.fill());
  }

  /** Those of the exact answer; while there is none, the last ones in grey. */
  show(sheet: ExactFacts['sheet'] | null): void {
    this.body.classList.toggle('stale', sheet === null);
    if (!sheet) return;
    const chosen = this.select.selectedIndex;
    this.choices = sheet.modesAt.flatMap((at) =>
      [at, ...(at.loosest ? [at.loosest] : [])].map(({ ends, buckles, modes }) => ({
        words: `${(1e3 * at.length_m).toFixed(1)} mm, ${ends}${buckles ? ': the spring buckles' : ''}`,
        buckles,
        modes,
      })),
    );
    this.select.replaceChildren(...this.choices.map(({ words }) => make('option', {}, words)));
    if (chosen >= 0 && chosen < this.choices.length) this.select.selectedIndex = chosen;
    this.element.hidden = this.choices.length === 0;
    this.fill();
  }

  private fill(): void {
    const choice = this.choices[this.select.selectedIndex];
    const number = (value: number | null, scale: number, unit: string) =>
      value === null ? '–' : `${digits(scale * value)} ${unit}`;
    this.body.replaceChildren(
      ...(choice?.modes ?? []).slice(0, 10).map((mode) => {
        const cells = [
          mode.kind,
          number(mode.axial_strength, 100, '%'),
          number(mode.side_force_n_per_n, 1, 'N/N'),
          number(mode.couple_m, 1e3, 'mm'),
        ];
        return make(
          'tr',
          { 'data-kind': mode.kind },
          make('th', { scope: 'row' }, `${mode.frequency_hz.toFixed(1)} Hz`),
          ...cells.map((text) => make('td', {}, text)),
        );
      }),
    );
  }
}
