// Hands and keys on the coil: a click or a flick is a hit, an end that is pulled and let go a pull. While that lasts, an arrow says what it will be.
//
// Next door: what comes of it (`act`), how the arrow looks (`arrow`), who shows it (`hands`).

import { clamp, make } from '../dom';
import { Arrow } from './arrow';
import { FASTEST, figure, isNothing, limited, told, type Act, type Rest } from './act';

/** What is in the hand [pixels, and pixels to a metre]. */
export interface Coil {
  ends: [number, number];
  scale: number;
  rest: Rest;
  /** Of a click or a key [m/s]. */
  speed: number;
  /** Whether end 2 is held, so that it can be pulled. */
  isHeld: boolean;
}

export interface Hands {
  /** Null where there is no spring yet. */
  coil(): Coil | null;
  act(act: Act, event: Event): void;
  /** An end is in the hand, so far from where it was; null: it is back. */
  pulled(act: Act | null): void;
  say(words: string): void;
}

/** A hand that moved by less did not mean to move [pixels]; a finger trembles more than a mouse. */
const STILL = { mouse: 4, pen: 6, touch: 9 } as Record<string, number>;
/** So near to an end it is the end that is taken [pixels]. */
const NEAR = 24;
/** A flick is as fast as the last so many milliseconds of it. */
const LATELY = 80;
/** A clock tells no shorter times than this [ms]. */
const TICK = 4;
/** What an arrow key adds [m/s, m]; with Shift five times as much. */
const STEP = { hit: 0.05, pull: 0.001 };

interface Grip {
  id: number;
  at: [number, number];
  coil: Coil;
  end: 1 | 2 | null;
  track: { x: number; time: number }[];
  isDrag: boolean;
  still: number;
}

export class Gesture {
  /** Lies over the canvas. */
  readonly element = make('div', {
    class: 'strike',
    tabindex: 0,
    role: 'slider',
    'aria-label': 'Your hit: arrows set its speed, Enter hits; 1 or 2 take an end to pull',
  });
  private readonly arrow = new Arrow(this.element);
  private grip: Grip | null = null;
  /** What a key would do; null is a hit as fast as a click. */
  private chosen: Act | null = null;

  constructor(private readonly hands: Hands) {
    const { element } = this;
    element.addEventListener('pointerdown', (event) => this.take(event));
    element.addEventListener('pointermove', (event) => this.move(event));
    element.addEventListener('pointerup', (event) => this.release(event));
    element.addEventListener('pointercancel', () => this.cancel());
    element.addEventListener('lostpointercapture', () => this.cancel());
    element.addEventListener('keydown', (event) => this.key(event));
    element.addEventListener('blur', () => (this.chosen?.kind === 'pull' ? this.choose(null) : this.arrow.hide()));
    // While something is in the hand Escape is about that, wherever the focus is.
    addEventListener('keydown', (event) => event.key === 'Escape' && this.grip && this.escape(event), {
      capture: true,
    });
    this.tell();
  }

  /** Another spring or condition is shown: a key begins with its speed. */
  renew(): void {
    this.cancel();
    this.choose(null);
  }

  /** What a click, Enter or the button does. */
  get usual(): Act {
    return this.chosen ?? { kind: 'hit', speed: this.hands.coil()?.speed ?? 0 };
  }

  private escape(event: KeyboardEvent): void {
    event.preventDefault();
    event.stopImmediatePropagation();
    this.cancel();
    this.hands.say('Left alone: nothing was hit.');
  }

  private take(event: PointerEvent): void {
    const coil = this.hands.coil();
    if (!coil || this.grip || !event.isPrimary || event.button !== 0) return;
    this.element.setPointerCapture(event.pointerId);
    const { offsetX: x, offsetY: y } = event;
    this.grip = {
      id: event.pointerId,
      at: [x, y],
      coil,
      end: this.endAt(coil, x),
      track: [{ x, time: event.timeStamp }],
      isDrag: false,
      still: STILL[event.pointerType] ?? 4,
    };
  }

  /** The end at a place, if it can be pulled. */
  private endAt({ ends, isHeld }: Coil, x: number): 1 | 2 | null {
    if (x < ends[0] + NEAR) return 1;
    return isHeld && x > ends[1] - NEAR ? 2 : null;
  }

  private move(event: PointerEvent): void {
    const { grip } = this;
    if (!grip) return this.hover(event);
    if (event.pointerId !== grip.id) return;
    const [right, down] = [event.offsetX - grip.at[0], event.offsetY - grip.at[1]];
    grip.track.push({ x: event.offsetX, time: event.timeStamp });
    if (!grip.isDrag) {
      if (Math.hypot(right, down) < grip.still) return;
      // Who moves up or down means to scroll, or to select.
      if (Math.abs(down) > Math.abs(right)) return this.cancel();
      grip.isDrag = true;
      if (!grip.end) this.watch(grip);
    }
    if (grip.end) this.show(grip, event.timeStamp);
  }

  private hover(event: PointerEvent): void {
    const coil = this.hands.coil();
    this.element.classList.toggle('end', coil !== null && this.endAt(coil, event.offsetX) !== null);
  }

  /** A hand that rests grows slow without a word from it. */
  private watch(grip: Grip): void {
    if (this.grip !== grip) return;
    this.show(grip, performance.now());
    requestAnimationFrame(() => this.watch(grip));
  }

  private show(grip: Grip, time: number): void {
    const act = this.meant(grip, time);
    const [from, height] = [grip.at[0], this.element.clientHeight];
    if (act.kind === 'pull') this.hands.pulled(act);
    const last = grip.track[grip.track.length - 1]?.x ?? from;
    const tip = act.kind === 'pull' ? from + act.by * grip.coil.scale : last;
    this.arrow.show(from, tip, height, figure(act));
  }

  /** What comes of it if the hand lets go at a time [ms]. */
  private meant({ at, coil, end, track }: Grip, time: number): Act {
    const last = track[track.length - 1]?.x ?? at[0];
    if (end) return limited({ kind: 'pull', end, by: (last - at[0]) / coil.scale }, coil.rest);
    const since = Math.max(time - LATELY, track[0]?.time ?? time);
    const moved = (last - placeAt(track, since)) / coil.scale;
    return limited({ kind: 'hit', speed: (1e3 * moved) / Math.max(TICK, time - since) }, coil.rest);
  }

  private release(event: PointerEvent): void {
    const { grip } = this;
    if (!grip || event.pointerId !== grip.id) return;
    const act = grip.isDrag ? this.meant(grip, event.timeStamp) : this.usual;
    this.cancel(isNothing(act));
    if (!isNothing(act)) return this.hands.act(act, event);
    this.hands.say(
      act.kind === 'hit'
        ? 'No hit: the hand was still when it let go. Take an end to pull.'
        : 'No pull: the end is where it was.',
    );
  }

  /** The hand is off; `back`: what it held goes back. */
  private cancel(back = true): void {
    const { grip } = this;
    if (!grip) return;
    this.grip = null;
    if (this.element.hasPointerCapture(grip.id)) this.element.releasePointerCapture(grip.id);
    this.arrow.hide();
    if (back && grip.isDrag && grip.end) this.hands.pulled(null);
  }

  private key(event: KeyboardEvent): void {
    const coil = this.hands.coil();
    if (!coil || this.grip || event.ctrlKey || event.metaKey || event.altKey) return;
    const sign = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    const end = ({ '1': 1, '2': 2 } as const)[event.key];
    if (sign) this.choose(this.stepped(coil, sign * (event.shiftKey ? 5 : 1)));
    else if (end && (end === 1 || coil.isHeld)) this.choose({ kind: 'pull', end, by: 0 });
    else if (end) this.hands.say('End 2 is not held: it cannot be pulled here. Pull end 1.');
    else if (event.key === 'Escape' && this.chosen) this.choose(null);
    else if (event.key === 'Enter') this.enter(event);
    else return;
    event.preventDefault();
  }

  private stepped(coil: Coil, steps: number): Act {
    const act = this.usual;
    const next: Act =
      act.kind === 'hit' ? { ...act, speed: act.speed + steps * STEP.hit } : { ...act, by: act.by + steps * STEP.pull };
    return limited(next, coil.rest);
  }

  private enter(event: KeyboardEvent): void {
    if (event.repeat) return;
    const act = this.usual;
    if (isNothing(act)) return this.hands.say('Nothing happens at zero: the arrows set how much.');
    const wasPulled = act.kind === 'pull';
    if (wasPulled) this.chosen = null;
    this.arrow.hide();
    this.hands.act(act, event);
    this.tell();
  }

  private choose(act: Act | null): void {
    const before = this.chosen;
    this.chosen = act;
    if (act?.kind === 'pull') this.hands.pulled(act);
    else if (before?.kind === 'pull') this.hands.pulled(null);
    this.tell();
    const coil = this.hands.coil();
    if (!act || !coil) return this.arrow.hide();
    const { clientWidth: width, clientHeight: height } = this.element;
    const from = act.kind === 'hit' ? width / 2 : coil.ends[act.end - 1]!;
    // Longer for what is faster, with room for the slow.
    const reach = act.kind === 'hit' ? Math.tanh(act.speed) * 0.35 * width : act.by * coil.scale;
    this.arrow.show(from, clamp(from + reach, 6, width - 6), height, figure(act));
  }

  private tell(): void {
    const act = this.usual;
    const { shortest = 0, longest = 0 } = this.hands.coil()?.rest ?? {};
    const most = act.kind === 'hit' ? FASTEST : 1e3 * (longest - shortest);
    this.element.setAttribute('aria-valuemin', String(-most));
    this.element.setAttribute('aria-valuemax', String(most));
    this.element.setAttribute('aria-valuenow', String(act.kind === 'hit' ? act.speed : 1e3 * act.by));
    this.element.setAttribute('aria-valuetext', told(act));
  }
}

/** Where the hand was at a time, which is not before the track. */
function placeAt(track: Grip['track'], time: number): number {
  const next = track.findIndex((one) => one.time > time);
  const [from, to] = [track[(next < 0 ? track.length : next) - 1], track[next]];
  if (!from || !to) return (from ?? to)?.x ?? 0;
  return from.x + ((time - from.time) / (to.time - from.time)) * (to.x - from.x);
}
