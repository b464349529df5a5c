// The kept state: held in the address, its case and verdict at hand or computed once more while the present state rests.
//
// Next door: its curves (`ghost`), the words below the plot (`bar`), the table (`card`), when this is loaded (`open`).

import { Judging, type Found } from '../jobs/judging';
import { fromHash, toHash } from '../address';
import type { Answer, ExactFacts } from '../answer';
import type { Refusal, Shown } from '../compute';
import { say } from '../faults';
import type { Outcome } from '../results/outcome';
import { defaultView, isOther, type State } from '../state';
import css from '../style/compare.css?inline';
import { wear } from '../style/wear';
import { Bar } from './bar';
import { Card } from './card';
import { conditionOf, named, type Case, type Judged } from './case';
import { Ghost } from './ghost';
import { hold } from './held';
import { differences } from './inputs';
import type { Compare } from './open';

/** So many cases and verdicts are held, so that an exchange computes nothing twice. */
const MOST = 4;

/** The newest few by their key. */
class Few<T> {
  private readonly all = new Map<string, T>();
  get = (key: string): T | undefined => this.all.get(key);
  put(key: string, value: T): void {
    this.all.delete(key);
    this.all.set(key, value);
    for (const old of [...this.all.keys()].slice(0, -MOST)) this.all.delete(old);
  }
}

/** A state as an address, with what decides its case and nothing else. */
const written = ({ preset, spec, view: { condition, damping } }: State): string =>
  toHash({ preset, spec, view: { ...defaultView(), condition, damping } }).slice(1);

export class Part {
  private word = '';
  private kept: Case | null = null;
  private readonly states = new Few<State>();
  private readonly cases = new Few<Answer<ExactFacts>>();
  private readonly verdicts = new Few<Outcome>();
  private refusal: Refusal | null;
  /** The kept state's case or verdict is under way: what ends that. */
  private under: AbortController | null = null;
  private readonly bar: Bar;
  private readonly card: Card;
  private readonly ghost: Ghost;

  constructor(private readonly compare: Compare) {
    const { store, compute, parts, forces, spectrum, last } = compare.around;
    wear(css);
    this.refusal = compare.around.refused();
    this.bar = new Bar(parts.forces, {
      swap: () => this.swap(),
      forget: () => this.forget(),
      look: () => this.card.look(),
    });
    this.card = new Card(parts.off);
    this.ghost = new Ghost(forces, spectrum, () => store.state.view);
    store.subscribe((state, before) => this.moved(state, before));
    compute.listen({
      shown: (shown) => this.shown(shown),
      refused: (refusal) => {
        this.refusal = refusal;
        if (refusal) this.draw();
      },
      busy: () => {},
    });
    compare.hearers.push(() => this.judged());
    const shown = last();
    if (shown) this.shown(shown);
    this.judged();
    this.follow();
  }

  /** What is shown is kept from now on. */
  keep(): void {
    if (this.refusal) return this.bar.tell('What cannot be computed cannot be kept.');
    const { store } = this.compare.around;
    const { state } = store;
    const word = written(state);
    this.states.put(word, state);
    store.setView({ kept: word });
    this.bar.tell(`Kept: ${this.kept ? named(this.kept) : ''}. Whatever changes from now on is shown beside it.`);
  }

  private swap(): void {
    const { kept } = this;
    const { store } = this.compare.around;
    const { state } = store;
    if (!kept || kept.failed) return;
    const word = written(state);
    this.states.put(word, state);
    const { condition, damping } = kept.state.view;
    const same = kept.state.preset === state.preset && conditionOf(kept.state) === conditionOf(state);
    const times = same ? state.view.times : null;
    store.put({ ...kept.state, view: { ...state.view, condition, damping, times, kept: word } }, '');
    this.bar.tell(`Exchanged. Now kept: ${named(this.kept ?? kept)}.`);
  }

  private forget(): void {
    this.compare.around.store.setView({ kept: '' }, true);
    this.bar.tell('Nothing is kept any more.');
    this.compare.keep.focus();
  }

  private moved(state: State, before: State): void {
    if (isOther(state, before)) {
      this.card.blank();
      // The slider must not wait for it; it is asked anew at rest.
      this.stop();
    }
    if (state.view.kept !== before.view.kept) this.follow();
  }

  /** What the state says is kept. */
  private follow(): void {
    const { store } = this.compare.around;
    const { kept } = store.state.view;
    this.compare.keep.textContent = kept ? 'Keep this instead' : 'Keep to compare';
    if (kept === this.word) return;
    this.word = kept;
    this.stop();
    this.kept = kept ? { state: this.read(kept), exact: null, failed: '', judged: null } : null;
    this.draw();
    void this.want();
  }

  private read(word: string): State {
    const known = this.states.get(word);
    if (known) return known;
    const { state, unread } = fromHash(word);
    if (unread.length > 0)
      say(
        'kept',
        `What is kept has settings that this page does not know: “${unread.join('”, “')}”. They are ignored.`,
      );
    this.states.put(word, state);
    return state;
  }

  private key(state: State): string {
    const { text, condition, damping } = this.compare.around.compute.question(state);
    return JSON.stringify([text, condition, damping]);
  }

  private text(state: State): string {
    return this.compare.around.compute.question(state).text;
  }

  private shown({ exact, exactText }: Shown): void {
    if (!exact) return;
    const { condition, damping } = exact.facts;
    this.cases.put(JSON.stringify([exactText, condition, damping]), exact);
    this.draw();
    void this.want();
  }

  private judged(): void {
    const { outcome, failed } = this.compare.judgement;
    // While the state moves it is told at every step; what stands there is marked already.
    if (!outcome && !failed) return;
    const text = this.compare.around.last()?.exactText;
    if (outcome && text !== undefined) this.verdicts.put(text, outcome);
    this.draw();
    void this.want();
  }

  /** The present state; pending unless what is shown is exact and its own. */
  private get now(): Case {
    const { store, last } = this.compare.around;
    const { state } = store;
    const shown = last();
    const isOwn = shown?.exact && this.key(state) === this.keyOf(shown);
    const { outcome, failed } = this.compare.judgement;
    const isJudged = outcome && shown?.exactText === this.text(state);
    const judged: Judged = isJudged ? { outcome } : failed ? { reason: '' } : null;
    return { state, exact: isOwn ? shown.exact : null, failed: this.refusal?.text ?? '', judged };
  }

  private keyOf({ exact, exactText }: Shown): string {
    return JSON.stringify([exactText, exact?.facts.condition, exact?.facts.damping]);
  }

  /** Fills in what is at hand, and shows it. */
  private draw(): void {
    const { kept } = this;
    if (!kept) {
      this.bar.hide();
      this.card.hide();
      this.behind(null);
      return;
    }
    kept.exact ??= this.cases.get(this.key(kept.state)) ?? null;
    const verdict = this.verdicts.get(this.text(kept.state));
    if (verdict) kept.judged = { outcome: verdict };
    this.behind(kept);
    const why = kept.failed && `It cannot be computed: ${kept.failed}`;
    this.bar.show(
      named(kept) + this.first(kept),
      why || (kept.exact ? '' : 'Its curves are being computed …'),
      !kept.failed,
    );
    this.card.show(kept, this.now);
  }

  /** What tells it from the present state, where the names of both are the same. */
  private first(kept: Case): string {
    const [one, ...more] = differences(kept.state, this.compare.around.store.state);
    if (!one || kept.state.preset !== this.compare.around.store.state.preset) return '';
    return `, ${one.label} ${one.kept}${more.length > 0 ? ' …' : ''}`;
  }

  private drawn: Answer<ExactFacts> | null = null;

  private behind(kept: Case | null): void {
    const answer = kept?.exact ?? null;
    if (answer === this.drawn) return;
    this.drawn = answer;
    hold(kept && answer ? { answer, words: named(kept) } : null);
    this.ghost.changed();
    const { last, spectrum, store } = this.compare.around;
    const shown = last();
    if (shown) spectrum.show(shown.answer, store.state.view.hidden);
  }

  /** Asks for what of the kept state is not at hand: its case while the present one rests, its verdict once that is judged. */
  private async want(): Promise<void> {
    const { kept } = this;
    const { now } = this;
    if (!kept || this.under || kept.failed) return;
    if (!kept.exact && (now.exact || now.failed)) await this.ask(kept);
    else if (kept.exact && !kept.judged && now.judged) await this.judge(kept);
  }

  /** In a worker of its own, which ends as soon as the state moves. */
  private async ask(kept: Case): Promise<void> {
    const { compute } = this.compare.around;
    const { signal } = (this.under = new AbortController());
    await compute.load(kept.state.preset);
    const { places: _, ...question } = compute.question(kept.state);
    if (signal.aborted) return;
    const reply = await compute.alone({ kind: 'exact', ...question }, signal);
    if (signal.aborted) return;
    this.under = null;
    if ('answer' in reply) this.cases.put(this.key(kept.state), reply.answer as Answer<ExactFacts>);
    if ('error' in reply) kept.failed = reply.error.replace(/^spec:\d+: /, '').split('\n')[0] ?? '';
    this.draw();
    void this.want();
  }

  private async judge(kept: Case): Promise<void> {
    const { compute } = this.compare.around;
    const { signal } = (this.under = new AbortController());
    const text = this.text(kept.state);
    const judging = new Judging(() => compute.known());
    signal.addEventListener('abort', () => judging.end());
    const found = await new Promise<Found>((done) => judging.ask({ text, told: () => {}, done }));
    judging.end();
    if (signal.aborted) return;
    this.under = null;
    if ('facts' in found) this.verdicts.put(text, (found.facts as { json: Outcome }).json);
    else kept.judged = { reason: found.error };
    this.draw();
  }

  private stop(): void {
    this.under?.abort();
    this.under = null;
  }
}
