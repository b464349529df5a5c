// A log to judge on: dropped or chosen, and which of its columns are force and positions. It stays in this browser.
//
// Next door: what else is asked (`form`), the place itself (`log/drop`), the tab for logs alone (`tabs/log`).

import type { Answer, Job } from '../answer';
import { make, rich } from '../dom';
import type { Column } from '../log/columns';
import { dropPlace } from '../log/drop';

const NEEDED = [
  ['time', 'time'],
  ['F_i', 'F_i, at end 1'],
  ['u1', 'u1, of end 1'],
  ['u2', 'u2, of end 2'],
  ['F_o', 'F_o, at end 2'],
] as const;

export interface Log {
  name: string;
  bytes: Uint8Array;
}

export class Drop {
  readonly element = make('div', { hidden: true });
  log: Log | null = null;
  /** How many logs there were: another one may have the same name. */
  count = 0;
  private rows: { channel: string; column: HTMLSelectElement; unit: HTMLInputElement; as: string }[] = [];
  private readonly table = make('div', {});
  private readonly written = make('p', { class: 'hint', 'aria-live': 'polite' });

  constructor(
    private readonly ask: (job: Job, done: (answer: Answer<unknown>) => void) => void,
    private readonly changed: () => void,
  ) {
    const place = dropPlace(
      'mitigate-file',
      ['Drop a log here', ', or choose one'],
      'A text with columns F_i, u1, u2, and F_o to judge estimators.',
      ([file]) => void this.take(file),
      this.element,
    );
    this.element.append(place, this.written, this.table);
    this.element.addEventListener('change', changed);
  }

  /** Columns that are not found by their names, as the engine takes them. */
  get columns(): string[] {
    return this.rows.flatMap(({ channel, column, unit, as }) => {
      const said = column.value === '' ? '' : `#${column.value}${unit.value.trim() ? ` [${unit.value.trim()}]` : ''}`;
      return said === as || said === '' ? [] : [`${channel}=${said}`];
    });
  }

  private async take(file: File | undefined): Promise<void> {
    if (!file) return;
    this.log = { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) };
    this.count += 1;
    this.rows = [];
    this.table.replaceChildren();
    this.written.textContent = '';
    this.changed();
    this.ask({ kind: 'columns', log: this.log, asked: '{}' }, ({ facts }) => {
      const { description, columns } = facts as { description: string; columns: Column[] };
      this.written.textContent = `${file.name}: ${description}`;
      this.show(columns);
    });
  }

  private show(columns: Column[]): void {
    const titles = columns.map(({ text }, index) =>
      make('option', { value: index + 1 }, text || `column ${index + 1}`),
    );
    const none = make('option', { value: '' }, '–');
    this.rows = NEEDED.map(([channel, meaning]) => {
      const at = columns.findIndex(({ name }) => name === channel);
      const column = make('select', { 'aria-label': `Column of ${meaning}` });
      column.append(...[none, ...titles].map((option) => option.cloneNode(true)));
      column.value = at < 0 ? '' : String(at + 1);
      const unit = make('input', {
        type: 'text',
        value: columns[at]?.unit ?? '',
        placeholder: 'unit',
        'aria-label': `Unit of ${meaning}`,
        size: 5,
        autocomplete: 'off',
      });
      const as = at < 0 ? '' : `#${at + 1}${unit.value ? ` [${unit.value}]` : ''}`;
      column.addEventListener('change', () => (unit.value = columns[Number(column.value) - 1]?.unit ?? ''));
      return { channel, column, unit, as };
    });
    const body = this.rows.map(({ channel, column, unit }) =>
      make('tr', {}, make('th', { scope: 'row' }, rich(channel)), make('td', {}, column), make('td', {}, unit)),
    );
    const heads = ['Signal', 'Column', 'Unit'].map((word) => make('th', { scope: 'col' }, word));
    this.table.replaceChildren(
      make('table', { class: 'columns' }, make('thead', {}, make('tr', {}, ...heads)), make('tbody', {}, ...body)),
    );
  }
}
