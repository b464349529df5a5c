// How far forces are off over the speed at which a recorded motion is played: the same turns of a cam, or the same road, slower and faster.
//
// Next door: which speeds (`points`), the curve (`curve`), its words (`words`), what opens it (`results/folded`).

import type { Answer, Facts } from '../answer';
import type { Compute } from '../compute';
import { toToml, withValue, type Spec } from '../document';
import { make } from '../dom';
import type { Lane, Reply } from '../lane';
import { KEY, played } from '../playback';
import type { Case } from '../results/folded';
import type { Store } from '../store';
import over from '../style/over.css?inline';
import css from '../style/speeds.css?inline';
import { wear } from '../style/wear';
import { Curve } from './curve';
import { closer, count, inOrder, type At } from './points';
import { doubts, forcesOf, sentence, speedOf } from './words';

export class Part {
  private readonly curve = new Curve((speed) => this.pick(speed));
  private readonly words = make('p', { class: 'live', role: 'status' });
  private readonly about = make('div', { class: 'about' });
  private readonly refusal = make('p', { class: 'refusal', role: 'status', hidden: true });
  private readonly body = make(
    'div',
    { class: 'over-curve over-speed', 'aria-busy': 'true' },
    this.words,
    this.curve.element,
    this.about,
  );
  private lane: Lane | null = null;
  /** The case but for its speed. */
  private asked = '';
  private spec: Spec | null = null;
  private facts: Case | null = null;
  private points: At[] = [];
  private wanted: number[] = [];
  private of = 0;

  constructor(
    host: HTMLElement,
    private readonly compute: Compute,
    private readonly store: Store,
  ) {
    wear(over, css);
    const hint =
      'The same motion played slower and faster; click a speed to see it. As a table, of the worst damping: ';
    host.append(this.refusal, make('p', { class: 'hint' }, hint, this.command), this.body);
    store.subscribe((state) => this.facts && this.curve.at(played(state.spec, state.view.condition)));
  }

  private readonly command = make('code', {}, '');

  /** An exact case; while there is none, the last curve in grey. */
  show(shown: Case | null): void {
    if (!shown) return this.mark(true);
    const { spec, view } = this.store.state;
    const place = `condition.${view.condition}.${KEY}`;
    const plain = withValue(spec, place, undefined);
    const asked = JSON.stringify([toToml(plain).text, view.condition, view.damping]);
    this.curve.at(played(spec, view.condition));
    if (asked === this.asked) return this.mark(false);
    const at = played(spec, view.condition);
    // Facts of a speed hold for the recorded one but for their times.
    const times = shown.conditions.map((one, number) =>
      number === view.condition
        ? { ...one, window: [one.window[0] * at, one.window[1] * at] as [number, number] }
        : one,
    );
    [this.asked, this.spec, this.facts] = [asked, plain, { ...shown, conditions: times }];
    const [force] = forcesOf(this.facts);
    const number = 1 + view.condition;
    this.command.textContent = `coilsense sweep spec.toml --over condition.${number}.${KEY}=40..160%:121 --columns '${force}.rmsd[${number}]' --out out/speeds`;
    [this.points, this.of] = [[], count(this.facts)];
    this.stop();
    this.refuse('');
    this.wanted = inOrder(this.of);
    this.lane = this.compute.laneOf({ text: shown.text });
    this.mark(false);
    this.next();
  }

  private mark(isStale: boolean): void {
    this.body.classList.toggle('stale', isStale);
    this.body.setAttribute('aria-busy', String(isStale || this.lane !== null));
  }

  /** The next speed, or those beside the peaks, or the end. */
  private next(): void {
    if (!this.facts || !this.spec) return;
    const [force = ''] = forcesOf(this.facts);
    if (this.wanted.length === 0) {
      this.wanted = closer(this.points, force, count(this.facts));
      this.of = this.points.length + this.wanted.length;
    }
    const speed = this.wanted.shift();
    if (speed === undefined) {
      this.stop();
      return this.draw();
    }
    const { condition, damping } = this.facts;
    const value = `${Number((100 * speed).toPrecision(12))} %`;
    const { text } = toToml(bare(withValue(this.spec, `condition.${condition}.${KEY}`, value)));
    const { asked } = this;
    const question = { kind: 'exact' as const, text, condition, damping };
    this.lane?.ask(question, (reply) => asked === this.asked && this.take(speed, reply));
  }

  private take(speed: number, reply: Reply): void {
    if (!('answer' in reply)) return this.refuse('error' in reply ? reply.error : '');
    const { facts } = reply.answer as Answer<Facts>;
    const off = Object.fromEntries(
      Object.entries(facts.forces).map(([force, { rmsd }]) => [force, rmsd / facts.spring.nominalForce]),
    );
    const touch = facts.contact ? facts.contact.touches > 0 : facts.clash.firstContact !== null;
    this.points = [...this.points, { speed, off, touch }].sort((a, b) => a.speed - b.speed);
    // A picture of every point would cost more than the points.
    if (this.points.length < 9 || this.points.length % 8 === 0) this.draw();
    this.next();
  }

  private draw(): void {
    const { facts } = this;
    if (!facts || this.points.length < 2) return;
    const goal = facts.goal === null ? null : facts.goal / facts.spring.nominalForce;
    this.curve.show(this.points, forcesOf(facts), goal, facts.truth);
    this.curve.at(played(this.store.state.spec, facts.condition));
    this.words.replaceChildren(...sentence(this.points, facts));
    const told = doubts(this.points, facts, this.lane ? Math.max(this.of, this.points.length + 1) : this.points.length);
    this.about.replaceChildren(...told.map((text) => make('p', {}, text)));
    // For whoever checks the page: all digits.
    this.body.dataset['points'] = JSON.stringify(this.points);
    this.mark(this.body.classList.contains('stale'));
  }

  private refuse(text: string): void {
    this.refusal.textContent = text && `The curve cannot be computed for this motion: ${text}`;
    this.refusal.hidden = text === '';
    this.body.hidden = text !== '';
    if (text) this.stop();
  }

  /** Nothing more is asked. */
  private stop(): void {
    this.wanted = [];
    this.lane?.end();
    this.lane = null;
  }

  private pick(speed: number): void {
    const { spec, view } = this.store.state;
    const value = speedOf(speed).replace('\u00a0', ' ');
    this.store.setSpec(
      withValue(spec, `condition.${view.condition}.${KEY}`, value),
      `click condition.${view.condition}.${KEY}`,
    );
  }
}

/** The same case with one sensor, whose readings nobody asks for. */
function bare(spec: Spec): Spec {
  const { rig: _, control: __, ...rest } = spec;
  return { ...rest, sensor: [{ kind: 'load-cell' }] };
}
