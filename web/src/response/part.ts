// The two ends over frequency: the curve of their forces, a frequency that is chosen on it, and what the coil does there.
//
// Next door: each of its parts (`choice`, `curve`, `picture`), what it says (`words`), what opens it (`results/folded`).

import type { Answer, CurveFacts, OfResponse, PointFacts } from '../answer';
import type { Compute } from '../compute';
import { make } from '../dom';
import type { Lane, Reply } from '../lane';
import type { Case } from '../results/folded';
import type { Store } from '../store';
import over from '../style/over.css?inline';
import css from '../style/response.css?inline';
import { wear } from '../style/wear';
import { Choice } from './choice';
import { Curve, type Over } from './curve';
import { Picture } from './picture';
import { about, brief, reason, sentence } from './words';

/** Two ways to look at the forces. */
const WAYS: [Over, string][] = [
  ['own', 'the force at the driven end'],
  ['motion', 'k × its motion'],
];

export class Part {
  private readonly lane: Lane;
  private asked = '';
  private shown: Case | null = null;
  private found: Answer<CurveFacts> | null = null;
  /** What is asked of the case, without what of it. */
  private question: Omit<OfResponse & { kind: 'response' }, 'kind'> | null = null;
  private readonly refusal = make('p', { class: 'refusal', role: 'status', hidden: true });
  private readonly curve = new Curve((frequency, isDone) => this.choice.pick(frequency, isDone));
  private readonly choice = new Choice((isDone) => this.choose(isDone));
  private readonly picture = new Picture();
  private readonly over = make('select', {}, ...WAYS.map(([value, label]) => make('option', { value }, label)));
  private readonly words = make('p', { class: 'live' });
  private readonly why = make('p', {});
  private readonly about = make('div', { class: 'about' });
  private readonly body = make(
    'div',
    { class: 'over-curve over-frequency', hidden: true },
    make('div', {}, make('label', { class: 'over' }, 'Over ', this.over), this.curve.element, this.choice.element),
    make('div', {}, this.words, this.why, this.picture.element, this.about),
  );

  constructor(
    host: HTMLElement,
    compute: Compute,
    private readonly store: Store,
  ) {
    wear(over, css);
    this.lane = compute.workshopLane();
    host.append(this.refusal, this.body);
    this.over.addEventListener('change', () => this.draw());
    store.subscribe(({ view: { frequency } }, before) => {
      const isOther = frequency !== before.view.frequency && frequency !== this.choice.frequency;
      if (isOther && this.found) this.fill();
    });
  }

  /** An exact case; while there is none, the last one in grey. */
  show(shown: Case | null): void {
    if (!shown) return this.mark(true);
    const { text, condition, damping, spring } = shown;
    const question = { text, condition, damping, masses: spring.massesPerWinding };
    const asked = JSON.stringify(question);
    this.shown = shown;
    if (asked === this.asked) return this.mark(this.found === null);
    this.mark(true);
    [this.asked, this.question, this.found] = [asked, question, null];
    this.lane.ask({ kind: 'response', ...question }, (reply) => asked === this.asked && this.take(reply));
  }

  /** Whether what is shown is of an earlier state. */
  private mark(isStale: boolean): void {
    this.body.classList.toggle('stale', isStale);
    this.body.setAttribute('aria-busy', String(isStale));
  }

  private take(reply: Reply): void {
    clock('response', reply);
    if (!('answer' in reply)) return this.refuse('error' in reply ? reply.error : '');
    this.refuse('');
    this.found = reply.answer as Answer<CurveFacts>;
    this.fill();
  }

  private refuse(text: string): void {
    this.refusal.textContent = text && `The curve cannot be computed for this spring: ${text}`;
    this.refusal.hidden = text === '';
    this.body.hidden = text !== '';
    if (text) this.mark(false);
  }

  private fill(): void {
    if (!this.found || !this.shown) return;
    this.choice.show(this.found.facts, this.store.state.view.frequency);
    this.about.replaceChildren(...about(this.found, this.shown));
    // Of a force that is prescribed there is no motion to compare with.
    this.over.disabled = !this.found.facts.isMoved;
    if (this.over.disabled) this.over.selectedIndex = 0;
    this.draw();
  }

  private draw(): void {
    if (!this.found) return;
    this.curve.show(this.found, WAYS[this.over.selectedIndex]?.[0] ?? 'own');
    this.askPoint();
  }

  private choose(isDone: boolean): void {
    this.askPoint();
    if (isDone) this.store.setView({ frequency: this.choice.frequency });
  }

  /** Only of a case whose curve is there: until then a question would be in its way. */
  private askPoint(): void {
    if (!this.found || !this.question || !this.shown) return;
    const { asked } = this;
    const { frequency } = this.choice;
    const places = this.shown.spring.masses;
    this.curve.follow(frequency);
    this.lane.ask(
      { kind: 'response-at', frequency, places, ...this.question },
      (reply) => asked === this.asked && this.takePoint(reply),
    );
  }

  private takePoint(reply: Reply): void {
    clock('response at', reply);
    if (!('answer' in reply)) return this.refuse('error' in reply ? reply.error : '');
    if (!this.found || !this.shown) return;
    const point = reply.answer as Answer<PointFacts>;
    const { facts } = point;
    this.curve.mark(facts);
    this.choice.say(brief(facts));
    this.words.replaceChildren(...sentence(facts, this.found.facts).filter(isThere));
    this.why.replaceChildren(...reason(facts).filter(isThere));
    this.picture.show(point, this.shown);
    // For whoever checks the page: all digits.
    this.body.dataset['point'] = JSON.stringify(facts);
    this.mark(false);
  }
}

const isThere = <T>(child: T | null | undefined | false): child is T =>
  child !== null && child !== undefined && child !== false;

/** How long the engine took, for whoever measures the page. */
const clock = (name: string, { milliseconds }: Reply): void => {
  performance.measure(`engine ${name}`, { start: performance.now() - milliseconds, duration: milliseconds });
};
