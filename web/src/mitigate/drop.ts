// A log to judge on: dropped or chosen, and which of its columns are force and positions. It stays in this browser.
//
// Next door: what else is asked (`form`), the place itself (`log/drop`), the tab for logs alone (`tabs/log`).

import type { Answer, Job, Log } from '../answer';
import { make } from '../dom';
import { ColumnTable, type Column } from '../log/columns';
import { dropPlace } from '../log/drop';
import { takeLogs } from '../log/takers';

export class Drop {
  readonly element = make('div', { hidden: true });
  log: Log | null = null;
  /** How many logs there were: another one may have the same name. */
  count = 0;
  private readonly table = new ColumnTable('', ', to judge on');
  /** What the titles say by themselves. */
  private titled: string[] = [];
  private readonly written = make('p', { class: 'hint', 'aria-live': 'polite' });

  constructor(
    private readonly ask: (job: Job, done: (answer: Answer<unknown>) => void) => void,
    private readonly changed: () => void,
  ) {
    const place = dropPlace(
      'mitigate-file',
      ['Drop a log here', ', or choose one'],
      'A text with columns F_i, u1, u2, and F_o to judge estimators.',
      ([file]) => this.take(file),
      this.element,
    );
    this.element.append(place, this.written, this.table.element);
    this.element.addEventListener('change', changed);
    takeLogs('mitigate', ([file]) => this.take(file));
  }

  /** Columns that are not found by their names, as the engine takes them. */
  get columns(): string[] {
    return this.table.asked.filter((one) => !this.titled.includes(one));
  }

  private take(file: File | undefined): void {
    if (!file) return;
    this.log = { name: file.name, file };
    this.count += 1;
    this.show([]);
    this.written.textContent = '';
    this.changed();
    this.ask({ kind: 'columns', log: this.log, asked: '{}' }, ({ facts }) => {
      const { description, columns } = facts as { description: string; columns: Column[] };
      this.written.textContent = `${file.name}: ${description}`;
      this.show(columns);
    });
  }

  private show(columns: Column[]): void {
    this.table.show(columns);
    this.table.fill({});
    this.titled = this.table.asked;
  }
}
