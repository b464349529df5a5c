// The spring under hands and keys: what they do goes to the engine as a condition, and runs from t = 0 as soon as its first picture is there.
//
// Next door: hands and keys (`gesture`), the condition (`act`), the strip beside the spring (`strip`), its sound (`listen`).

import css from '../style/hit.css?inline';
import { wear } from '../style/wear';
import type { Refusal, Shown } from '../compute';
import { section, sections } from '../document';
import { make, word } from '../dom';
import { drawSpring, emptied, ruled } from '../spring/draw';
import { positionsAt } from '../spring/scene';
import { isOther } from '../state';
import { applied, isNothing, onset, speedOf, told, type Act, type Onset, type Rest } from './act';
import { Gesture, type Coil } from './gesture';
import { Listen } from './listen';
import type { Bench } from './open';
import { Strip } from './strip';

const calm = matchMedia('(prefers-reduced-motion: reduce)');

export class Part {
  private readonly gesture: Gesture;
  private readonly strip: Strip;
  private readonly listen: Listen;
  private refusal: Refusal | null = null;
  /** When the hit was whose first picture is awaited, on the clock of events [ms]. */
  private awaited: number | null = null;

  constructor(
    private readonly bench: Bench,
    private readonly words: HTMLElement,
  ) {
    wear(css);
    const { store, compute, canvas, player } = bench;
    this.gesture = new Gesture({
      coil: () => this.coil(),
      act: (act, event) => this.act(act, event),
      pulled: (act) => this.pulled(act),
      say: (words) => this.say(words),
    });
    const over = make('div', { class: 'over' });
    canvas.replaceWith(over);
    over.append(canvas, this.gesture.element);
    this.strip = new Strip((time) => player.goTo(time));
    this.listen = new Listen();
    bench.strip.replaceChildren(
      make('div', { class: 'head' }, make('h2', {}, 'The wave'), word('ringing'), this.listen.element),
      ...this.strip.parts,
      this.listen.words,
    );
    store.subscribe((state, before) => {
      if (!isOther(state, before)) return;
      this.gesture.renew();
      this.listen.show(null);
    });
    compute.listen({
      shown: (shown) => this.show(shown),
      refused: (refusal) => this.refused(refusal),
      busy: () => {},
    });
    const last = bench.last();
    if (last) this.show(last);
    this.gesture.renew();
  }

  at(time: number): void {
    this.strip.at(time);
  }

  /** The button: as hard as a click on the coil. */
  hit(event: Event): void {
    if (!isNothing(this.gesture.usual)) this.act(this.gesture.usual, event);
  }

  private say(words: string): void {
    this.words.textContent = words;
  }

  private coil(): Coil | null {
    const { player, canvas, store } = this.bench;
    const shown = this.bench.last();
    if (!shown || shown.frames.times.length === 0) return null;
    const { frames } = shown;
    const seen = player.seen;
    const { margin, scale } = ruled(seen, canvas.clientWidth);
    const positions = positionsAt(frames, seen.time);
    const place = (at: number) => margin + ((positions[at] ?? 0) - seen.left) * scale;
    const { spec, view } = store.state;
    return {
      ends: [place(0), place(frames.columns - 1)],
      scale,
      rest: rest(shown),
      speed: speedOf(sections(spec, 'condition')[view.condition]),
      isHeld: (section(spec, 'mount')['end2'] ?? 'held') === 'held',
    };
  }

  private act(act: Act, event: Event): void {
    const { store, compute, player } = this.bench;
    const shown = this.bench.last();
    const { spec, view } = store.state;
    // What is wrong with the hit itself another one may put right.
    const isOwn = this.refusal?.place.startsWith(`condition.${view.condition}.`) ?? true;
    if (!shown || !isOwn) {
      player.goOn();
      return this.say('Not hit: the spring cannot be computed as it is typed.');
    }
    const next = applied(act, spec, view.condition, rest(shown));
    const isSame = next.condition === view.condition && JSON.stringify(next.spec) === JSON.stringify(spec);
    this.awaited = event.timeStamp;
    this.say(`Your ${act.kind}: ${told(act)}.`);
    // The same once more changes nothing that could be undone: it runs again.
    if (isSame && shown.exact && view.times === null) {
      this.begin(shown);
      return void measure(event.timeStamp);
    }
    player.hold();
    compute.mark(event);
    store.setSpec(next.spec, '', { condition: next.condition, times: null });
  }

  private show(shown: Shown): void {
    const { awaited } = this;
    if (awaited !== null && shown.since < awaited) return;
    if (awaited !== null) this.begin(shown);
    this.strip.show(shown, this.bench.player.seen.peak, this.onset(shown));
    this.strip.at(this.bench.player.seen.time);
    if (shown.exact) this.listen.show(shown.exact);
    if (awaited !== null) measure(awaited);
  }

  /** From t = 0; where motion is not wanted still, with the wave half way along. */
  private begin(shown: Shown): void {
    this.awaited = null;
    const half = (this.onset(shown)?.time ?? 0) + 0.5 * shown.answer.facts.spring.transitTime;
    this.bench.player.begin(calm.matches ? half : 0, !calm.matches);
  }

  private refused(refusal: Refusal | null): void {
    this.refusal = refusal;
    if (!refusal || this.awaited === null) return;
    this.awaited = null;
    this.bench.player.goOn();
    this.say('The hit cannot be computed: the spring is shown as it was before.');
  }

  /** When a wave sets out and from which end, where one does. */
  private onset({ answer }: Shown): Onset | null {
    const { condition = 0 } = answer.facts;
    return onset(sections(this.bench.store.state.spec, 'condition')[condition]);
  }

  /** An end in the hand: the windings are spread evenly, as before they are let go. */
  private pulled(act: Act | null): void {
    const { player, canvas } = this.bench;
    const shown = this.bench.last();
    if (!shown || act?.kind !== 'pull') return player.goOn();
    player.hold();
    const { frames, answer } = shown;
    const { spring, staticForce, meanLength } = answer.facts;
    const seen = player.seen;
    const now = positionsAt(frames, seen.time);
    const count = frames.columns - 2;
    const first = (now[0] ?? 0) + (act.end === 1 ? act.by : 0);
    const last = (now[count + 1] ?? 0) + (act.end === 2 ? act.by : 0);
    const positions = Float32Array.from(now, (_, node) => {
      if (node === 0) return first;
      return node > count ? last : first + ((node - 0.5) / count) * (last - first);
    });
    const force = staticForce + spring.stiffness * (last - first - meanLength);
    drawSpring(emptied(canvas), { ...seen, departure: 0, positions, spring, forces: [force, force], closed: null });
  }
}

/** From a hit to the frame that shows it first, with all that is drawn in that frame. */
const measure = (start: number): number =>
  requestAnimationFrame(() => performance.measure('hit to first frame', { start, end: performance.now() }));

/** The spring once it is still: after a step or a ramp it has another length than before. */
function rest({ answer, frames }: Shown): Rest {
  const { spring, meanLength, conditions, condition } = answer.facts;
  const { positions, columns } = frames;
  const moved = ['step', 'ramp'].includes(conditions[condition]?.kind ?? '');
  const after = (positions[positions.length - 1] ?? 0) - (positions[positions.length - columns] ?? 0);
  return {
    length: moved && positions.length > 0 ? after : meanLength,
    shortest: spring.minLength,
    longest: spring.maxLength,
    oneWay: spring.transitTime,
  };
}
