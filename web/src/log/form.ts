// What the user says of a log: its columns, the options, a second device; all but the logs themselves is kept in the address.
//
// Next door: one option (`field`), one table (`columns`), what comes of it (`found`), who asks (`tabs/log`).

import { make } from '../dom';
import { ColumnTable, type Column } from './columns';
import { OptionField } from './field';
import { CLOCK, GROUPS, LABELS } from './options';

type Words = Record<string, string>;

/** An error that begins with the name of an option, and perhaps a line of the text that was given for it. */
const ABOUT = /^([a-z0-9-]+)(?::(\d+))?: (.*)$/s;

export class Form {
  readonly element = make('div', { class: 'fields', hidden: true });
  private readonly fields = [...GROUPS.flatMap(({ options }) => options), CLOCK].map((one) => new OptionField(one));
  private readonly columns = new ColumnTable('', '');
  private readonly others = new ColumnTable('with ', ', second device');
  /** Words about columns of logs that are not here. */
  private kept: Words = {};
  private hasSecond = false;

  /** `second` is where a second device's log is dropped. */
  constructor(
    private readonly second: HTMLElement,
    changed: (words: Words) => void,
  ) {
    const of = (name: string) => this.field(name)?.element ?? '';
    const groups = GROUPS.map(({ title, options }) =>
      make('details', {}, make('summary', {}, title), ...options.map(({ name }) => of(name))),
    );
    this.element.append(
      this.columns.element,
      ...groups,
      make('details', {}, make('summary', {}, 'A second device'), second, this.others.element, of('clock')),
    );
    this.element.addEventListener('change', (event) => {
      if (!(event.target instanceof HTMLInputElement && event.target.type === 'file')) changed(this.words);
    });
    this.fill({});
  }

  private field(name: string): OptionField | undefined {
    return this.fields.find(({ option }) => option.name === name);
  }

  /** A log has come, with these columns. */
  show(columns: Column[], words: Words): void {
    this.columns.show(columns);
    this.element.hidden = false;
    this.fill(words);
  }

  /** Another log has come, whose columns are not known yet. */
  clear(words: Words): void {
    this.columns.show([]);
    this.fill(words);
  }

  /** What brings these tables back, as they are. */
  keep(): () => void {
    const tables = [this.columns.keep(), this.others.keep()];
    const [hidden, hasSecond] = [this.element.hidden, this.hasSecond];
    return () => {
      for (const back of tables) back();
      [this.element.hidden, this.hasSecond] = [hidden, hasSecond];
    };
  }

  /** A second device's log has come, or has gone. */
  showSecond(columns: Column[] | null, words: Words): void {
    this.hasSecond = columns !== null;
    this.others.show(columns ?? []);
    this.others.element.hidden = columns === null;
    const folded = this.second.closest('details');
    if (columns && folded) folded.open = true;
    this.fill(words);
  }

  /** Shows what an address says. */
  fill(words: Words): void {
    for (const field of this.fields) field.word = words[field.option.name] ?? '';
    this.columns.fill(words);
    this.others.fill(words);
    const present = { ...this.columns.words, ...this.others.words };
    this.kept = Object.fromEntries(
      Object.entries(words).filter(
        ([name]) => (this.columns.isAbout(name) || this.others.isAbout(name)) && !(name in present),
      ),
    );
    this.conceal();
  }

  /** Everything that is not as it is by itself. */
  get words(): Words {
    const told = this.fields.map(({ option, word }) => [option.name, word]).filter(([, word]) => word !== '');
    return { ...Object.fromEntries(told), ...this.kept, ...this.columns.words, ...this.others.words };
  }

  private conceal(): void {
    const word = (name: string) => this.field(name)?.word ?? '';
    for (const { option, element } of this.fields)
      element.hidden = option.only !== undefined && !option.only[1].includes(word(option.only[0]));
    const clock = this.field('clock');
    if (clock) clock.element.hidden = !this.hasSecond;
    this.columns.element.hidden = this.columns.isEmpty || word('layout') !== '';
  }

  /** Whether there is an inductance and a position to go with it, and whether there is a force. */
  get holds(): { calibration: boolean; force: boolean } {
    const chosen = this.columns.channels;
    const layout = this.field('layout')?.word;
    if (layout === 'lab-data') return { calibration: true, force: false };
    if (layout === 'mapping') {
      const text = this.field('mapping')?.word ?? '';
      const has = (name: string) => new RegExp(`^\\s*${name}\\s*=`, 'm').test(text);
      return { calibration: has('L') && (has('u1') || has('u2')), force: true };
    }
    const position = chosen.includes('u1') || chosen.includes('u2');
    return {
      calibration: chosen.includes('L') && position,
      force: this.hasSecond || chosen.some((name) => name.startsWith('F_')),
    };
  }

  /** As the engine takes it; `spec` is that of the page's spring. */
  asked(spec: string): string {
    const said: Record<string, unknown> = {};
    for (const { option, word, element } of this.fields)
      if (word !== '' && !element.hidden) said[option.name] = option.tick ? true : word;
    const { layout, spring, ...rest } = said;
    return JSON.stringify({
      ...rest,
      labels: LABELS,
      ...(layout === 'lab-data' ? { preset: layout } : {}),
      ...(layout ? {} : { column: this.columns.asked }),
      ...(this.hasSecond ? { 'with-column': this.others.asked } : {}),
      ...(spring === 'tab' ? { spec } : {}),
    });
  }

  /** Marks the fields that errors are about; those errors that are about none. */
  refuse(errors: string[]): string[] {
    const about = errors.map((error) => {
      const [, name = '', line, reason = ''] = ABOUT.exec(error) ?? [];
      return { error, name: name === 'preset' ? 'layout' : name, reason: line ? `line ${line}: ${reason}` : reason };
    });
    for (const field of this.fields) {
      const mine = about.find(({ name }) => name === field.option.name);
      field.refuse(mine ? mine.reason : null);
    }
    return about.filter(({ name }) => !this.field(name)).map(({ error }) => error);
  }
}
