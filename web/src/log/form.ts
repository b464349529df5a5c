// What the user says of a log: which column is which channel in which unit, how it was sampled, what may be mended, what spring it is.
//
// Next door: what comes of it (`found`), who asks (`tabs/log`).

import { make } from '../dom';

export interface Column {
  text: string;
  name: string;
  unit: string | null;
}

const CHANNELS = ['time', 'u1', 'u2', 'F_i', 'F_o', 'F_x', 'F_L', 'L'] as const;
const MEANINGS: Record<(typeof CHANNELS)[number], string> = {
  time: 'time',
  u1: 'u1, of end 1',
  u2: 'u2, of end 2',
  F_i: 'F_i, at end 1',
  F_o: 'F_o, at end 2',
  F_x: 'F_x, k·Δl',
  F_L: 'F_L, by L',
  L: 'L, inductance',
};

const field = (label: string, input: HTMLElement, hint = '') =>
  make(
    'div',
    { class: 'field' },
    make('label', { for: input.id }, label),
    input,
    hint ? make('span', { class: 'hint' }, hint) : null,
  );
const text = (id: string, hint = '') =>
  make('input', { type: 'text', id: `log-${id}`, placeholder: hint, autocomplete: 'off', spellcheck: 'false' });
const tick = (id: string, label: string) => {
  const input = make('input', { type: 'checkbox', id: `log-${id}` });
  return { input, element: make('label', { class: 'tick', for: input.id }, input, ` ${label}`) };
};

export class Form {
  readonly element = make('div', { class: 'fields', hidden: true });
  private rows: { select: HTMLSelectElement; unit: HTMLInputElement; column: Column }[] = [];
  private readonly columns = make('div', {});
  private readonly texts = {
    'sample-rate': text('sample-rate', '2.5 kHz'),
    resample: text('resample', '2.5 kHz'),
    from: text('from', '2 s'),
    to: text('to', '10 s'),
    mass: text('mass', '65 g'),
    'length-at-zero': text('length-at-zero', '200 mm'),
  };
  private readonly ticks = {
    'drop-incomplete': tick('drop-incomplete', 'leave out rows that lack a value or cannot be read'),
    sort: tick('sort', 'put rows into the order of their times'),
    'merge-repeated': tick('merge-repeated', 'take the mean of rows with the same time'),
  };
  private readonly known = tick('known', 'it is the spring of the tab Spring');

  constructor(changed: () => void) {
    const { texts, ticks } = this;
    this.element.append(
      this.columns,
      make(
        'details',
        {},
        make('summary', {}, 'The spring'),
        this.known.element,
        field('or its mass', texts.mass, 'With the stiffness it foretells f1.'),
      ),
      make(
        'details',
        {},
        make('summary', {}, 'Sampling, and what may be mended'),
        field('Sample rate', texts['sample-rate'], 'Of a log without a time column.'),
        field('Resample to', texts.resample),
        field('Leave out before', texts.from),
        field('and after', texts.to),
        ...Object.values(ticks).map(({ element }) => element),
      ),
      make(
        'details',
        {},
        make('summary', {}, 'Calibration'),
        field('Length at zero', texts['length-at-zero'], 'Where positions read zero; needs columns L and u1 or u2.'),
      ),
    );
    this.element.addEventListener('change', changed);
  }

  show(columns: Column[]): void {
    this.rows = columns.map((column, index) => {
      const named = CHANNELS.find((channel) => channel === column.name) ?? '';
      const label = column.text || `column ${index + 1}`;
      const choices = [
        make('option', { value: '' }, '–'),
        ...CHANNELS.map((channel) =>
          make('option', { value: channel, selected: channel === named }, MEANINGS[channel]),
        ),
      ];
      const select = make('select', { 'aria-label': `${label} is` }, ...choices);
      const unit = make('input', {
        type: 'text',
        value: column.unit ?? '',
        placeholder: 'unit',
        'aria-label': `Unit of ${label}`,
        size: 5,
        autocomplete: 'off',
      });
      return { select, unit, column };
    });
    const row = ({ select, unit, column }: (typeof this.rows)[number], index: number) =>
      make(
        'tr',
        {},
        make('th', { scope: 'row' }, column.text || `#${index + 1}`),
        make('td', {}, select),
        make('td', {}, unit),
      );
    const heads = ['Column', 'is', 'Unit'].map((word) => make('th', { scope: 'col' }, word));
    this.columns.replaceChildren(
      make(
        'table',
        { class: 'columns' },
        make('thead', {}, make('tr', {}, ...heads)),
        make('tbody', {}, ...this.rows.map(row)),
      ),
    );
    this.element.hidden = false;
  }

  /** Whether a column is an inductance and another a position. */
  get canCalibrate(): boolean {
    const chosen = this.rows.map(({ select }) => select.value);
    return chosen.includes('L') && (chosen.includes('u1') || chosen.includes('u2'));
  }

  /** As the engine takes it; `spec` is that of the page's spring. */
  asked(spec: string): string {
    const chosen = this.rows.flatMap(({ select, unit }, index) =>
      select.value ? [`${select.value}=#${index + 1}${unit.value.trim() ? ` [${unit.value.trim()}]` : ''}`] : [],
    );
    const values = Object.entries(this.texts).map(([name, { value }]) => [name, value]);
    const ticks = Object.entries(this.ticks).map(([name, { input }]) => [name, input.checked]);
    return JSON.stringify({
      column: chosen,
      ...Object.fromEntries([...values, ...ticks]),
      ...(this.known.input.checked ? { spec } : {}),
    });
  }
}
