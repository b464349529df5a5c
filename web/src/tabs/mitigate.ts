// The tab *Mitigate*: every filter and estimator on the conditions of the page's spec, or on a log; error against lag, one of them over time,
// and its settings.
//
// Next door: what is asked (`mitigate/form`), what comes of it (`mitigate/found`), how they are judged (`coilsense-web`, `mitigate`).

import type { Answer, Job } from '../answer';
import type { Compute } from '../compute';
import { toToml } from '../document';
import { fixed, make } from '../dom';
import { Patience } from '../inputs/patience';
import { COLUMNS } from '../log/options';
import { Choices } from '../mitigate/choices';
import { Drop } from '../mitigate/drop';
import { empty } from '../mitigate/empty';
import { Form } from '../mitigate/form';
import { Found } from '../mitigate/found';
import { Progress } from '../mitigate/progress';
import type { Facts, Judged, Ranking } from '../mitigate/ranking';
import { readInk } from '../plots/looks';
import type { Store } from '../store';
import { dress } from '../style/dress';

/** Fields are looked at once they rest for so long [ms]. */
const REST = 250;

class Mitigate {
  private readonly choices: Choices;
  private readonly refusal = make('p', { class: 'refusal', role: 'alert', hidden: true });
  private readonly place = make('div', { class: 'found' }, empty());
  private readonly earlier = make('div', { class: 'refusal earlier', role: 'status', hidden: true });
  private readonly progress = new Progress(
    () => void this.judge(),
    () => this.cancel(),
  );
  private readonly drop = new Drop(
    (job, done) => void this.ask(job, done),
    () => this.changed(),
  );
  private readonly form: Form;
  private readonly patience = new Patience<readonly string[]>((reasons) => this.refuse(reasons ?? []));
  private found: Found | null = null;
  /** What the numbers are of. */
  private judged = '';
  private number = 0;
  /** How often Judge has said something: a check of the fields that was begun before does not take it back. */
  private said = 0;
  private stop: (() => void) | null = null;
  private timer = 0;

  constructor(
    panel: HTMLElement,
    private readonly store: Store,
    private readonly compute: Compute,
  ) {
    this.choices = new Choices(store);
    this.form = new Form(this.choices, this.drop.element, (event) => this.patience.heard(event));
    const again = make('button', { type: 'button', class: 'plain', onclick: () => void this.judge() }, 'Judge again');
    this.earlier.append('These numbers are of an earlier state of the spring or of the choices. ', again);
    this.form.element.append(this.progress.element);
    panel.classList.add('logs');
    panel.replaceChildren(
      make('div', { class: 'asked' }, this.form.element, this.refusal),
      make('div', { class: 'told' }, this.earlier, this.place),
    );
    store.subscribe(() => this.changed());
    this.changed();
    // A link to a candidate is a link to what was judged; a log does not travel with it.
    if (this.choices.get('candidate') && this.choices.get('on') !== 'log') void this.judge();
  }

  private get text(): string {
    return toToml(this.store.state.spec).text;
  }

  private get asked(): string {
    const onLog = this.choices.get('on') === 'log';
    return this.form.asked(onLog ? { column: this.drop.columns, labels: { column: COLUMNS } } : {});
  }

  /** All that numbers hang on. */
  private get key(): string {
    const log = this.choices.get('on') === 'log' ? this.drop.count : 0;
    return JSON.stringify([this.text, this.asked, log]);
  }

  private changed(): void {
    if (this.store.state.view.tab !== 'mitigate') return;
    this.form.show();
    this.drop.element.hidden = this.choices.get('on') !== 'log';
    this.found?.follow();
    this.earlier.hidden = !this.found || this.judged === this.key;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.check(), REST);
  }

  /** What the fields are where nothing is said, and what is wrong with what is. */
  private async check(): Promise<void> {
    const number = ++this.number;
    const { said } = this;
    const { reply } = this.compute.job({ kind: 'mitigate-usual', text: this.text, asked: this.asked }, () => {});
    const coming = await reply;
    if (number !== this.number) return;
    const refuse = (reasons: readonly string[]) =>
      said === this.said && this.patience.tell(reasons.length > 0 ? reasons : null);
    if ('error' in coming) return void refuse([coming.error]);
    if (!('answer' in coming)) return;
    const { usual, wrong } = coming.answer.facts as { usual: Record<string, string>; wrong: string[] };
    this.form.usual(usual);
    refuse(this.choices.get('on') === 'stated' ? [] : wrong);
  }

  private refuse(reasons: readonly string[]): void {
    const rest = this.form.refuse(reasons);
    this.refusal.hidden = rest.length === 0;
    this.refusal.textContent = rest.join(' ');
  }

  private cancel(): void {
    this.stop?.();
    this.progress.rest('Cancelled.');
  }

  private async judge(): Promise<void> {
    if (this.progress.isRunning) return;
    clearTimeout(this.timer);
    void this.check();
    this.said++;
    const { text, asked, key } = this;
    const { log } = this.drop;
    const onLog = this.choices.get('on') === 'log';
    if (onLog && !log) return this.refuse(['Drop a log first, or judge on the conditions of the tab Spring.']);
    const job: Job = onLog && log ? { kind: 'mitigate-log', text, asked, log } : { kind: 'mitigate', text, asked };
    const begun = performance.now();
    this.progress.begin();
    await this.ask(
      job,
      (answer) => {
        this.progress.rest(`Judged in ${fixed((performance.now() - begun) / 1e3, 1)} s, in this browser.`);
        this.show(answer as Answer<Facts>, key);
      },
      () => this.progress.rest(''),
    );
  }

  private show(answer: Answer<Facts>, key: string): void {
    this.judged = key;
    const judged: Judged = { ranking: JSON.parse(answer.facts.json) as Ranking, answer };
    this.found = new Found(this.place, judged, this.choices);
    this.earlier.hidden = this.judged === this.key;
  }

  /** A job that may be cancelled; nothing comes of it then. */
  private async ask(job: Job, done: (answer: Answer<unknown>) => void, wrong = () => {}): Promise<void> {
    const { reply, cancel } = this.compute.job(job, (done, of, file) => this.progress.tell(done, of, file));
    if (job.kind !== 'columns') this.stop = cancel;
    const coming = await reply;
    this.said++;
    this.refuse('error' in coming ? [coming.error] : []);
    if ('error' in coming) wrong();
    else if ('answer' in coming) done(coming.answer as Answer<unknown>);
  }
}

export function open(panel: HTMLElement, store: Store, compute: Compute): void {
  readInk();
  dress();
  new Mitigate(panel, store, compute);
}
