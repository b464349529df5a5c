// Which column of a log is which channel in which unit: a table, as the titles say it until the user says otherwise.
//
// Next door: what else is said of a log (`form`), a log to judge on (`mitigate/drop`).

import { make, rich } from '../dom';

export interface Column {
  text: string;
  name: string;
  unit: string | null;
  /** The channel that its title names, or what it is guessed to be by its unit and words. */
  channel: string | null;
  guessed: boolean;
}

/** What the user says of columns: `is TITLE` and `unit TITLE`, each with a word before it for a second device. */
type Words = Record<string, string>;

const MEANINGS = {
  time: 'time',
  u1: 'u1, of end 1',
  u2: 'u2, of end 2',
  F_i: 'F_i, at end 1',
  F_o: 'F_o, at end 2',
  F_x: 'F_x, k·Δl',
  F_L: 'F_L, by L',
  L: 'L, inductance',
};
/** Of a column that the user leaves out though its title names a channel. */
const NONE = '-';

interface Row {
  key: string;
  /** What the title says by itself. */
  guess: { channel: string; unit: string };
  select: HTMLSelectElement;
  unit: HTMLInputElement;
}

export class ColumnTable {
  readonly element = make('div', {});
  private rows: Row[] = [];

  /** `before` goes before each name that an address knows; `whose` tells the tables apart for those who hear them. */
  constructor(
    private readonly before: string,
    private readonly whose: string,
  ) {}

  get isEmpty(): boolean {
    return this.rows.length === 0;
  }

  show(columns: Column[]): void {
    this.rows = columns.map((column, index) => {
      const { channel } = column;
      return this.row(column, index, channel && channel in MEANINGS ? channel : '');
    });
    const guesses = columns.flatMap(({ text, channel, guessed }, index) =>
      guessed && channel ? [`${text || `column ${index + 1}`} is ${channel}`] : [],
    );
    const guess = make(
      'p',
      { class: 'hint guess' },
      rich(`A guess by unit and title: ${guesses.join(', ')}. Correct it here if it is wrong.`),
    );
    const shown = ({ key, select, unit }: Row) =>
      make('tr', {}, make('th', { scope: 'row' }, key), make('td', {}, select), make('td', {}, unit));
    const heads = ['Column', 'is', 'Unit'].map((word) => make('th', { scope: 'col' }, word));
    this.element.hidden = columns.length === 0;
    this.element.replaceChildren(
      make(
        'table',
        { class: 'columns' },
        make('thead', {}, make('tr', {}, ...heads)),
        make('tbody', {}, ...this.rows.map(shown)),
      ),
      guesses.length > 0 ? guess : '',
    );
  }

  /** What brings the table back, as it is. */
  keep(): () => void {
    const { rows } = this;
    const [nodes, hidden] = [[...this.element.childNodes], this.element.hidden];
    return () => {
      [this.rows, this.element.hidden] = [rows, hidden];
      this.element.replaceChildren(...nodes);
    };
  }

  private row(column: Column, index: number, channel: string): Row {
    const key = column.text || `#${index + 1}`;
    const label = `${column.text || `column ${index + 1}`}`;
    const choices = [['', '–'], ...Object.entries(MEANINGS)].map(([value, words]) => make('option', { value }, words));
    const select = make('select', { 'aria-label': `${label} is${this.whose}` }, ...choices);
    const unit = make('input', {
      type: 'text',
      placeholder: 'unit',
      'aria-label': `Unit of ${label}${this.whose}`,
      size: 5,
      autocomplete: 'off',
    });
    return { key, guess: { channel, unit: column.unit ?? '' }, select, unit };
  }

  /** Shows what the user said of these columns. */
  fill(words: Words): void {
    for (const { key, guess, select, unit } of this.rows) {
      const told = words[`${this.before}is ${key}`];
      select.value = told === NONE ? '' : (told ?? guess.channel);
      if (select.selectedIndex < 0) select.value = guess.channel;
      unit.value = words[`${this.before}unit ${key}`] ?? guess.unit;
    }
  }

  /** What differs from the titles. */
  get words(): Words {
    const words: Words = {};
    for (const { key, guess, select, unit } of this.rows) {
      if (select.value !== guess.channel) words[`${this.before}is ${key}`] = select.value || NONE;
      if (unit.value.trim() !== guess.unit) words[`${this.before}unit ${key}`] = unit.value.trim();
    }
    return words;
  }

  /** Whether a word of the address is about a column. */
  isAbout(name: string): boolean {
    return name.startsWith(`${this.before}is `) || name.startsWith(`${this.before}unit `);
  }

  /** Which channels the columns are. */
  get channels(): string[] {
    return this.rows.map(({ select }) => select.value).filter(Boolean);
  }

  /** As the command takes them: `F_o=#3 [N]`. */
  get asked(): string[] {
    return this.rows.flatMap(({ select, unit }, index) => {
      const words = unit.value.trim();
      return select.value ? [`${select.value}=#${index + 1}${words ? ` [${words}]` : ''}`] : [];
    });
  }
}
