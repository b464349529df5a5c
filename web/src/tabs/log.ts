// The tab *Log*: drop a measured log, say which column is what, and read what rings. The file stays in this browser.
//
// Next door: what is said of a log (`log/form`), what comes of it (`log/found`), what computes it (`coilsense-web`, `log`).

import type { Log } from '../answer';
import type { Compute } from '../compute';
import { toToml } from '../document';
import { make } from '../dom';
import { download } from '../download';
import { part } from '../faults';
import { Asking } from '../log/asking';
import type { Column } from '../log/columns';
import { dropPlace } from '../log/drop';
import { empty } from '../log/empty';
import { button } from '../log/found';
import { Form } from '../log/form';
import { Results } from '../log/results';
import { beganTogether, choose, inOrder } from '../log/several';
import { openSpec, trialJob } from '../log/spec';
import { specOf, takeLogs, textOf } from '../log/takers';
import { Underway } from '../log/underway';
import { readInk } from '../plots/looks';
import type { Store } from '../store';
import { dress } from '../style/dress';

/** What a first look at a log tells. */
interface Look {
  description: string;
  columns: Column[];
  preset: string | null;
  remarks: string[];
}

/** Of a larger log the calibration waits for the verdict, so that its columns are not in memory twice [bytes]. */
const LARGE = 16e6;

/** The two parts of what is asked of a log. */
type Part = 'log' | 'calibration';

class LogTab {
  private readonly refusal = make('p', { class: 'refusal', role: 'alert', hidden: true });
  private readonly written = make('p', { class: 'hint', 'aria-live': 'polite' });
  private readonly trial = make('div', { class: 'downloads' });
  private readonly several = make('div', { class: 'downloads several' });
  private readonly secondName = make('p', { class: 'hint', hidden: true });
  private readonly without = make('button', { type: 'button', class: 'plain' }, 'Without it');
  private readonly underway = new Underway(() => this.cancel());
  private readonly results: Results;
  private readonly form: Form;
  private readonly asking: Asking;
  /** Of the second device, whose columns no question about the first may end. */
  private readonly beside: Asking;

  private log: Log | null = null;
  private second: Log | null = null;
  /** What stands above the first log's rows, and of which all were dropped with it. */
  private remarks: string[] = [];
  private secondRemarks: string[] = [];
  private dropped: File[] = [];
  /** What was asked last, and which format it was asked for. */
  private last = '';
  private format = '';
  /** Whether the log's columns are known; until then nothing else is asked about it. */
  private known = false;
  /** What is wrong with the log or a choice, and with what a calibration takes of them: told at its field, else in a line. */
  private wrong = { log: '', calibration: '' };
  /** Brings back what was there before the log that is being read. */
  private before: (() => void) | null = null;
  /** What was chosen for the logs that are there, by what stands in them: of others it is not true. */
  private chosen: Record<string, string> = {};
  /** How often something was dropped: what is looked at first may be overtaken. */
  private drops = 0;

  constructor(
    private readonly panel: HTMLElement,
    private readonly store: Store,
    private readonly compute: Compute,
  ) {
    this.results = new Results({ openSpec: (text) => openSpec(store, text) }, () => empty(() => this.tryIt()));
    this.asking = new Asking(
      compute,
      (busy) => {
        panel.setAttribute('aria-busy', String(busy));
        this.underway.busy(busy);
      },
      (...told) => this.underway.tell(...told),
      () => (this.before = null),
    );
    this.beside = new Asking(compute, () => {});
    this.without.addEventListener('click', () => {
      this.leaveSecond();
      this.identify();
    });
    this.form = new Form(this.secondPlace(), (words) => this.put(words));
    this.results.fade();
    store.subscribe(({ view }, before) => {
      if (view.log !== before.view.log) this.form.fill(view.log);
      if (this.log && view.tab === 'log') this.follow();
    });
    this.form.fill(store.state.view.log);
    this.place();
    takeLogs('log', (files) => void this.take(files, 'first'));
  }

  private place(): void {
    const place = dropPlace(
      'log-file',
      ['Drop a log here', ', or choose one'],
      'A text with columns: time, positions u1 and u2, forces F_i and F_o, inductance L. It does not leave this browser.',
      (files) => void this.take(files, 'first'),
      this.panel,
    );
    const { underway, several, refusal, written, trial, form } = this;
    this.panel.classList.add('logs');
    this.panel.replaceChildren(
      make('div', { class: 'asked' }, place, underway.element, several, refusal, written, trial, form.element),
      this.results.element,
    );
  }

  private secondPlace(): HTMLElement {
    const place = dropPlace(
      'log-second',
      ['Drop its log here', ', or choose one'],
      'Its channels are added on the first log’s times.',
      (files) => void this.take(files, 'second'),
    );
    return make('div', {}, place, this.secondName);
  }

  private put(words: Record<string, string>): void {
    this.store.setView({ log: words }, true);
  }

  /** The choices or the spring have changed. */
  private follow(): void {
    if (this.layout() !== this.format || (!this.known && this.asked() !== this.last)) this.columns();
    else if (this.asked() !== this.last) this.identify();
  }

  private say(part: Part, error: string, isOfNow = false): void {
    this.wrong[part] = error;
    const rest = this.form.refuse(Object.values(this.wrong).filter(Boolean));
    this.refusal.hidden = !rest.includes(this.wrong.log);
    this.refusal.textContent = this.refusal.hidden ? '' : this.wrong.log;
    if (part === 'calibration' && rest.includes(error)) this.results.refuseCalibration(error);
    if (part === 'log' && error && !isOfNow) this.results.fade();
  }

  private readonly sayOfLog = (error: string): void => this.say('log', error);

  private async take(files: File[], device: 'first' | 'second'): Promise<void> {
    const mine = ++this.drops;
    const spec = await specOf(files);
    if (mine !== this.drops) return;
    if (spec) return (await part('What takes files', () => import('../dropped'))).take(files, this.store, this.compute);
    const mapping = files.find(({ name }) => name.endsWith('.toml'));
    const text = mapping ? (await textOf(mapping)).trim() : '';
    if (mine !== this.drops) return;
    const logs = inOrder(files.filter((file) => file !== mapping));
    if (logs.length > 0) this.remember();
    if (mapping) this.put({ ...this.store.state.view.log, layout: 'mapping', mapping: text });
    const [one, other] = device === 'first' ? logs : [undefined, logs[0]];
    if (one && other) this.leaveSecond();
    if (one) this.takeFirst(one, logs);
    if (other) this.takeSecond(other);
  }

  /** Keeps what stands there, until what comes has been read. */
  private remember(): void {
    // Of what is still being read nothing is kept.
    if (this.before) return;
    const { log, second, remarks, secondRemarks, dropped, chosen, last, format, known } = this;
    const wrong = { ...this.wrong };
    const words = this.store.state.view.log;
    const back = [this.results.keep(), this.form.keep()];
    const texts = [this.refusal, this.written, this.trial, this.several, this.secondName].map(
      (part) => [part, [...part.childNodes], part.hidden] as const,
    );
    this.before = () => {
      Object.assign(this, { log, second, remarks, secondRemarks, dropped, chosen, last, format, known, wrong });
      for (const restore of back) restore();
      for (const [part, nodes, hidden] of texts) {
        part.replaceChildren(...nodes);
        part.hidden = hidden;
      }
      if (this.store.state.view.log !== words) this.put(words);
      this.form.fill(words);
      this.form.refuse(Object.values(wrong).filter(Boolean));
    };
  }

  /** Ends what is under way, and leaves the page as it was before. */
  private cancel(): void {
    const { before } = this;
    this.drops += 1;
    this.asking.cancel();
    this.beside.cancel();
    this.before = null;
    this.underway.end('Cancelled.');
    this.panel.querySelector<HTMLElement>('#log-file')?.focus();
    if (before) before();
    else this.results.fade();
  }

  private takeFirst(file: File, all: File[]): void {
    this.remember();
    this.log = null;
    const of = Object.entries(this.store.state.view.log).filter(([name, word]) => this.chosen[name] !== word);
    this.choose(Object.fromEntries(of), {});
    const isFolder = file.name.endsWith('/');
    if (!isFolder) this.log = { name: file.name, file };
    this.dropped = all;
    this.results.clear(`Reading ${file.name} …`);
    this.form.clear(this.store.state.view.log);
    for (const part of [this.written, this.trial, this.several]) part.replaceChildren();
    if (!isFolder) return this.columns();
    this.asking.cancel();
    this.before = null;
    this.sayOfLog(`${file.name} is a folder: drop the files that are in it.`);
  }

  /** Another of the runs that were dropped: its coil may be another one, so that its length is asked for anew. */
  private showOther(file: File): void {
    const name = 'length-at-zero';
    this.chosen = { ...this.chosen, [name]: this.store.state.view.log[name] ?? '' };
    this.takeFirst(file, this.dropped);
  }

  /** Sets words that follow from the logs themselves. */
  private choose(words: Record<string, string>, chosen: Record<string, string>): void {
    this.chosen = chosen;
    this.store.setView({ log: { ...words, ...chosen } });
  }

  private takeSecond(file: File): void {
    this.beside.cancel();
    // What came before is no device of this run, and its clock none of this one.
    this.leaveSecond();
    const log = { name: file.name, file };
    const refuse = (error: string) => {
      this.before = null;
      this.sayOfLog(error);
    };
    this.beside.ask({ kind: 'columns', log, asked: '{}' }, refuse, ({ facts }) => {
      const { columns, description, remarks } = facts as Look;
      [this.second, this.secondRemarks] = [log, remarks];
      const words = this.store.state.view.log;
      this.form.showSecond(columns, words);
      this.secondName.replaceChildren(`${file.name}: ${description} `, this.without);
      this.secondName.hidden = false;
      if (!this.log) this.before = null;
      this.join();
      this.identify();
    });
  }

  /** Two logs of one run that began together have one clock. */
  private join(): void {
    const words = this.store.state.view.log;
    if (!this.second || !this.known || words['clock'] || !beganTogether(this.remarks, this.secondRemarks)) return;
    this.choose(words, { ...this.chosen, clock: '0 s' });
  }

  private leaveSecond(): void {
    this.second = null;
    this.secondName.hidden = true;
    this.form.showSecond(null, this.store.state.view.log);
    const { clock, ...others } = this.chosen;
    const { clock: told, ...words } = this.store.state.view.log;
    if (clock && clock === told) this.choose(words, others);
  }

  /** Which parts of the choices say how the text is written. */
  private layout(): string {
    const { layout, mapping, delimiter, decimal } = this.store.state.view.log;
    return JSON.stringify([layout, mapping, delimiter, decimal]);
  }

  private asked(): string {
    return this.form.asked(toToml(this.store.state.spec).text);
  }

  private columns(): void {
    const { log } = this;
    if (!log) return;
    [this.format, this.last, this.known] = [this.layout(), this.asked(), false];
    this.asking.cancel();
    this.asking.ask({ kind: 'columns', log, asked: this.asked() }, this.sayOfLog, ({ facts }) => {
      const { description, columns, preset, remarks } = facts as Look;
      [this.known, this.remarks] = [true, remarks];
      this.say('log', '');
      this.written.textContent = `${log.name}: ${description}`;
      this.form.show(columns, this.store.state.view.log);
      if (preset && !this.store.state.view.log['layout']) return this.takePreset(preset);
      this.join();
      this.identify();
    });
  }

  /** A layout that is known: its columns need no table, and each of such files is a run of its own. */
  private takePreset(preset: string): void {
    this.beside.cancel();
    this.leaveSecond();
    this.choose(this.store.state.view.log, { ...this.chosen, layout: preset });
  }

  private identify(): void {
    const { log, form, results } = this;
    if (!log || !this.known) return;
    this.last = this.asked();
    this.asking.cancel();
    const { holds } = form;
    this.wrong.calibration = '';
    this.several.replaceChildren();
    if (this.store.state.view.log['layout'] === 'lab-data')
      this.several.append(...choose(this.dropped, log.file as File, (file) => this.showOther(file)));
    const calibrate = () => this.calibrate(log, holds.calibration);
    const waits = log.file.size > LARGE && holds.force;
    if (holds.force || !holds.calibration)
      this.asking.ask(
        { kind: 'identify', log, second: this.second, asked: this.last },
        (error) => {
          this.sayOfLog(error);
          if (waits) calibrate();
        },
        (answer) => {
          this.say('log', results.showLog(log.name, answer), true);
          if (waits) calibrate();
        },
      );
    else {
      this.say('log', '');
      results.onlyCalibration();
    }
    if (!waits) calibrate();
  }

  private calibrate(log: Log, holds: boolean): void {
    if (!holds) return this.results.showCalibration(log.name, null);
    this.asking.ask(
      { kind: 'calibrate', log, asked: this.last },
      (error) => this.say('calibration', error),
      (answer) => {
        this.say('calibration', '');
        this.results.showCalibration(log.name, answer);
      },
    );
  }

  private tryIt(): void {
    this.asking.ask(trialJob(this.store), this.sayOfLog, ({ facts }) => {
      const { name, text } = facts as { name: string; text: string };
      const file = new File([text], name);
      this.takeFirst(file, [file]);
      const save = () => download(name, text, 'text/csv');
      this.trial.replaceChildren(button('Save the simulated log (CSV)', save));
    });
  }
}

export function open(panel: HTMLElement, store: Store, compute: Compute): void {
  readInk();
  dress();
  new LogTab(panel, store, compute);
}
