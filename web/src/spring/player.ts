// Time: runs slowly through what is shown, or is where the user puts it; the spring, its forces and the plots' mark follow.
//
// Next door: how the spring is drawn (`draw`), what holds for all times (`scene`), which windings lie on each other (`closed`).

import { clamp, digits, fixed, make, rich } from '../dom';
import type { Closed } from './closed';
import { drawSpring, emptied } from './draw';
import { STEADY, VARYING } from './walls';
import {
  firstContact,
  label,
  nearest,
  positionsAt,
  SPEEDS,
  survey,
  usualSpeed,
  type Coil,
  type Scene,
  type Seen,
} from './scene';

/** A phone has no room for it. */
const than = () => make('span', { class: 'long' }, ' than the mean');
/** Frames per second are counted over so many seconds. */
const COUNTED = 2;
/** Numbers that change faster than this cannot be read [ms]. */
const PAUSE = 120;

export class Player {
  private shown: Seen | null = null;
  private time = 0;
  private playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  private running = false;
  private held = false;
  private inSight = false;
  private before = 0;
  /** When the numbers last changed. */
  private told = 0;
  private scene: Scene = { left: 0, right: 1, peak: 0, gain: 1, mean: 0, departure: 0 };
  private readonly counted: number[] = [];
  private readonly ends: HTMLElement[];
  private readonly difference = make('span', { class: 'difference' });
  private readonly play = make('button', { type: 'button', class: 'play' });
  private readonly scrub = make('input', { type: 'range', min: 0, max: 1000, step: 1, 'aria-label': 'Time' });
  private readonly clock = make('output', { class: 'clock', 'aria-live': 'off' });
  private readonly gain = make('span', { class: 'gain' });
  private readonly low = make('span');
  private readonly high = make('span');
  private readonly touch = make('span', { class: 'touch', hidden: true });
  /** What lies on what at the mark, in words. */
  private readonly together = make('span', { class: 'together', hidden: true });
  private readonly contact = make(
    'button',
    { type: 'button', class: 'plain', hidden: true, onclick: () => this.onContact?.(this.firstContact ?? 0) },
    'Go to first contact',
  );
  /** Which windings lie on each other; it comes with the first that were asked to meet. */
  private closedAt: typeof import('./closed').closedAt | null = null;
  /** A time [s] to go on from once it is among those shown. */
  private awaited: number | null = null;
  private readonly speed: HTMLSelectElement;

  constructor(
    /** Seconds of the spring per second of the viewer, as the user chose it; 0 where nobody did. */
    private readonly chosen: { slow: number },
    host: HTMLElement,
    private readonly canvas: HTMLCanvasElement,
    private readonly onTime: (time: number, told: boolean) => void,
    /** What is done to see a first contact [s]; without it nobody is offered to. */
    private readonly onContact: ((time: number) => void) | null = null,
    /** Loads what tells which windings are closed. */
    private readonly closed: () => Promise<typeof import('./closed')> = () => import('./closed'),
  ) {
    this.ends = [make('span', { class: 'end first' }), make('span', { class: 'end second' })];
    const words = (slow: number) => (slow === 1 ? 'real time' : `${Math.round(1 / slow)}× slower`);
    this.speed = make(
      'select',
      { 'aria-label': 'Speed' },
      ...SPEEDS.map((slow) => make('option', { value: slow }, words(slow))),
    );
    this.speed.addEventListener('change', () => (chosen.slow = Number(this.speed.value)));
    this.play.addEventListener('click', () => this.setPlaying(!this.playing));
    this.scrub.addEventListener('input', () => this.goTo(this.fromScrub()));
    const scale = make('span', {
      class: 'scale',
      role: 'img',
      'aria-label': 'from closer than the mean pitch to wider',
    });
    host.replaceChildren(
      make('div', { class: 'ends' }, this.ends[0] ?? null, this.difference, this.ends[1] ?? null),
      canvas,
      make('div', { class: 'player' }, this.play, this.scrub, this.clock, this.speed),
      make(
        'p',
        { class: 'legend awaited' },
        make('span', {}, 'Windings: ', this.low, ' closer ', scale, ' ', this.high, ' wider', than()),
        this.touch,
        this.together,
        this.gain,
      ),
    );
    if (onContact) host.querySelector('.legend')?.append(this.contact);
    new ResizeObserver(() => this.draw()).observe(canvas);
    new IntersectionObserver((entries) => {
      this.inSight = entries[entries.length - 1]?.isIntersecting ?? false;
      this.run();
    }).observe(canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () =>
      requestAnimationFrame(() => this.draw()),
    );
    this.setPlaying(this.playing);
  }

  show(shown: Seen): void {
    const sameFrames = shown.frames === this.shown?.frames;
    this.shown = shown;
    if (shown.answer.series['closed from'] && !this.closedAt) void this.learnClosed();
    this.speed.value = String(this.slow(shown));
    if (!sameFrames) this.look(shown);
    this.contact.hidden = this.firstContact === null;
    const awaited = this.awaited ?? NaN;
    if (awaited >= shown.times[0] && awaited <= shown.times[1]) {
      this.awaited = null;
      this.time = awaited;
      this.onTime(this.time, true);
    }
    if (this.time < shown.times[0] || this.time > shown.times[1]) {
      this.time = shown.times[0];
      this.onTime(this.time, true);
    }
    this.draw();
    this.run();
  }

  private async learnClosed(): Promise<void> {
    this.closedAt = (await this.closed()).closedAt;
    this.draw();
  }

  /** A time [s] that the user chose; the motion stops there. */
  goTo(time: number): void {
    this.begin(time, false);
  }

  /** Stands as it is, whatever is shown meanwhile, until it begins somewhere or goes on. */
  hold(): void {
    this.held = true;
  }

  goOn(): void {
    this.held = false;
    this.draw();
    this.run();
  }

  /** From a time [s] of what is shown now: in motion, or still. */
  begin(time: number, playing: boolean): void {
    this.awaited = null;
    this.time = time;
    this.setPlaying(playing);
    this.draw();
    this.onTime(time, true);
  }

  /** Plays on from a time [s] as soon as it is among those shown. */
  playFrom(time: number): void {
    this.goTo(time);
    this.awaited = time;
    this.setPlaying(true);
  }

  private get firstContact(): number | null {
    return this.shown ? firstContact(this.shown.answer.facts) : null;
  }

  setPlaying(playing: boolean): void {
    this.held = false;
    this.playing = playing;
    this.play.textContent = playing ? 'Pause' : 'Play';
    this.play.setAttribute('aria-pressed', String(playing));
    this.run();
  }

  /** Frames per second, of the last two seconds of motion. */
  get framesPerSecond(): number {
    const [first, last] = [this.counted[0], this.counted[this.counted.length - 1]];
    return first !== undefined && last !== undefined && last > first
      ? (1e3 * (this.counted.length - 1)) / (last - first)
      : 0;
  }

  /** Seconds of the spring per second of the viewer. */
  private slow({ times }: Seen): number {
    return this.chosen.slow > 0 ? this.chosen.slow : usualSpeed(times);
  }

  private fromScrub(): number {
    const [from, to] = this.shown?.times ?? [0, 1];
    return from + (Number(this.scrub.value) / 1000) * (to - from);
  }

  /** What holds for all of the shown times, and the words about it. */
  private look(shown: Seen): void {
    this.scene = survey(shown);
    const { peak, gain } = this.scene;
    this.canvas.parentElement?.querySelector('.legend')?.classList.remove('awaited');
    const percent = `${digits(100 * peak, 2)} %`;
    this.low.textContent = `−${percent}`;
    this.high.textContent = `+${percent}`;
    this.enlarge(gain);
    const { facts } = shown.answer;
    this.touch.hidden = firstContact(facts) === null;
    this.touch.textContent = facts.contact ? 'windings lie on each other' : 'windings touch';
    this.canvas.setAttribute('aria-label', label(facts, peak));
  }

  /** What holds for all of the shown times, and the time that is drawn [s]. */
  get seen(): Readonly<Scene> & { time: number } {
    return { ...this.scene, time: this.time };
  }

  /** By how much displacements are drawn larger. */
  get enlarged(): number {
    return this.scene.gain;
  }

  enlarge(gain: number): void {
    this.scene.gain = gain;
    const { mean, departure } = this.scene;
    // Of two newtons more in an arrow and two of its mean, the former are so much longer.
    const arrows = departure > 0 && mean !== 0 ? (VARYING * Math.abs(mean)) / (STEADY * departure) : 1;
    const times = arrows > 1.05 || arrows < 0.95 ? `; changes of the arrows × ${digits(arrows, 2)}` : '';
    this.gain.textContent = `${gain === 1 ? 'Drawn true to scale' : `Displacements × ${gain}`}${times}.`;
  }

  draw(told = true): void {
    const { shown } = this;
    if (!shown || this.held) return;
    const { frames, answer } = shown;
    const { spring } = answer.facts;
    const closed = this.closedAt?.(answer.series, this.time, spring.masses, shown.times) ?? null;
    const at = nearest(answer.series['time'] ?? frames.times, this.time);
    const forces: [number, number] = [answer.series['F_i']?.[at] ?? 0, answer.series['F_o']?.[at] ?? 0];
    if (frames.times.length > 0)
      drawSpring(emptied(this.canvas), {
        positions: positionsAt(frames, this.time),
        spring,
        forces,
        closed,
        ...this.scene,
      });
    if (told) this.tell(forces, spring);
    if (told) this.tellClosed(closed);
    const [from, to] = shown.times;
    this.scrub.value = String((1000 * (this.time - from)) / (to - from));
    this.scrub.setAttribute('aria-valuetext', `${fixed(1e3 * this.time, 1)} milliseconds`);
    this.clock.textContent = `${fixed(1e3 * this.time, 1)} ms`;
  }

  private tell(forces: [number, number], spring: Coil): void {
    const decimals = clamp(2 - Math.floor(Math.log10(spring.nominalForce)) + 1, 0, 3);
    ['F_i', 'F_o'].forEach((name, end) =>
      this.ends[end]?.replaceChildren(
        make('b', {}, `End ${end + 1} `),
        make('small', {}, '(', rich(name), ')'),
        ` ${fixed(forces[end] ?? 0, decimals)} N`,
      ),
    );
    const apart = forces[1] - forces[0];
    this.difference.replaceChildren(
      `now ${fixed(Math.abs(apart), decimals)} N apart`,
      make('small', {}, ` ${fixed((100 * Math.abs(apart)) / spring.nominalForce, 1)} % of F`, make('sub', {}, 'nom')),
    );
  }

  private tellClosed(closed: Closed | null): void {
    this.together.hidden = closed === null;
    if (!closed) return;
    const off = closed.off.map((end) => `end ${end} off its seat`);
    const met = closed.words.length > 0 ? [`closed: ${closed.words.join(', ')}`] : ['no windings closed'];
    this.together.textContent = `At the mark: ${[...met, ...off].join('; ')}.`;
  }

  private run(): void {
    if (this.running || this.held || !this.playing || !this.inSight || !this.shown) return;
    this.running = true;
    this.counted.length = 0;
    this.before = performance.now();
    requestAnimationFrame((now) => this.step(now));
  }

  /** Goes round within what is shown. */
  private step(now: number): void {
    this.running = this.playing && !this.held && this.inSight && this.shown !== null;
    if (!this.running || !this.shown) return;
    this.counted.push(now);
    while (this.counted.length > 2 && now - (this.counted[0] ?? now) > 1e3 * COUNTED) this.counted.shift();
    const [from, to] = this.shown.times;
    const time = this.time + (clamp(now - this.before, 0, 100) / 1e3) * this.slow(this.shown);
    this.before = now;
    this.time = time > to || time < from ? from : time;
    // All numbers change at once, so that those above the spring and those below the plot are of one moment.
    const told = now - this.told >= PAUSE;
    if (told) this.told = now;
    this.draw(told);
    this.onTime(this.time, told);
    requestAnimationFrame((next) => this.step(next));
  }
}
