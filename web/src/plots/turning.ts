// What goes round in a picture, once in so long, while it is in sight and somebody wants it to; still where motion is not wanted.
//
// Next door: the wire in one mode (`modes/wire`), the coil under a sine (`response/picture`).

import { clamp, make } from '../dom';

const ROUND = 2 * Math.PI;
/** What a picture at rest is not moved on by when it goes on [ms]. */
const LONGEST_STEP = 100;

export interface Drawn {
  /** What is in sight or not. */
  canvas: HTMLElement;
  /** What changes its size with the picture. */
  sized: HTMLElement;
  /** One turn takes so long on the screen [s]. */
  turn: number;
  draw: (angle: number) => void;
  /** Whether there is anything to draw. */
  isThere: () => boolean;
}

export class Turning {
  /** [rad] */
  angle = 0;
  playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  private running = false;
  private inSight = false;
  private before = 0;
  readonly play = make('button', { type: 'button', class: 'play' });

  constructor(private readonly drawn: Drawn) {
    this.play.addEventListener('click', () => this.setPlaying(!this.playing));
    new ResizeObserver(() => this.draw()).observe(drawn.sized);
    new IntersectionObserver((entries) => {
      this.inSight = entries[entries.length - 1]?.isIntersecting ?? false;
      this.run();
    }).observe(drawn.canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () =>
      requestAnimationFrame(() => this.draw()),
    );
    this.setPlaying(this.playing);
  }

  /** There is another picture. */
  show(): void {
    this.draw();
    this.run();
  }

  /** The picture once more, where no next one comes by itself. */
  again(): void {
    if (!this.running) this.draw();
  }

  private draw(): void {
    this.drawn.draw(this.angle);
  }

  private setPlaying(playing: boolean): void {
    this.playing = playing;
    this.play.textContent = playing ? 'Hold still' : 'Move';
    this.play.setAttribute('aria-pressed', String(playing));
    this.run();
  }

  private run(): void {
    if (this.running || !this.playing || !this.inSight || !this.drawn.isThere()) return;
    this.running = true;
    this.before = performance.now();
    requestAnimationFrame((now) => this.step(now));
  }

  private step(now: number): void {
    this.running = this.playing && this.inSight && this.drawn.isThere();
    if (!this.running) return;
    const { turn } = this.drawn;
    this.angle = (this.angle + (ROUND * clamp(now - this.before, 0, LONGEST_STEP)) / 1e3 / turn) % ROUND;
    this.before = now;
    this.draw();
    requestAnimationFrame((next) => this.step(next));
  }
}
