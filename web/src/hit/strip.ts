// The strip: position along the spring to the right, time downwards, the strain of each gap as a colour; a line goes down with the player.
// What is shown is turned like pages, each of a few ways of the wave, so that one look follows it to the far end and back.
//
// Next door: how it is painted (`paint`), who shows it (`hands`).

import type { Shown } from '../compute';
import { clamp, digits, fixed, make } from '../dom';
import { emptied, strains } from '../spring/draw';
import { nearest } from '../spring/scene';
import type { Onset } from './act';
import { pageAt } from './pages';
import { paint, type Area } from './paint';

export class Strip {
  private readonly canvas = make('canvas', { role: 'img' });
  private readonly line = make('div', { class: 'now', 'aria-hidden': 'true', hidden: true });
  private readonly cross = make('div', { class: 'cross', 'aria-hidden': 'true', hidden: true });
  private readonly host = make(
    'div',
    {
      class: 'strip',
      tabindex: 0,
      role: 'group',
      'aria-label': 'The wave over position and time; arrows move a cross, Enter goes to its time',
    },
    this.canvas,
    this.line,
    this.cross,
  );
  private readonly foot = make('p', { class: 'foot' });
  private readonly value = make('p', { class: 'foot', role: 'status', 'aria-live': 'off' });
  /** For a card: the picture takes what room there is. */
  readonly parts = [this.host, this.foot, this.value];
  private shown: Shown | null = null;
  private peak = 0;
  private onset: Onset | null = null;
  private page: [number, number] = [0, 1];
  private area: Area | null = null;
  private time = 0;
  /** What is pointed at: a share of the length, a share of the page. */
  private pointed: [number, number] = [0.5, 0.5];
  private isPointing = false;
  private inSight = false;
  private waits = false;

  constructor(private readonly goTo: (time: number) => void) {
    this.rest();
    this.host.addEventListener('pointermove', (event) => this.point(event));
    this.host.addEventListener('pointerleave', () => this.rest());
    this.host.addEventListener('blur', () => this.rest());
    this.host.addEventListener('click', (event) => {
      this.point(event);
      this.go();
    });
    this.host.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => {
      // Out of sight nothing is painted, and the line would stay as wide as before.
      this.area = null;
      this.mark();
      this.draw();
    }).observe(this.canvas);
    new IntersectionObserver((entries) => {
      this.inSight = entries[entries.length - 1]?.isIntersecting ?? false;
      this.draw();
    }).observe(this.canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
  }

  show(shown: Shown, peak: number, onset: Onset | null): void {
    [this.shown, this.peak, this.onset] = [shown, peak, onset];
    const { transitTime, name } = shown.answer.facts.spring;
    const way = `${digits(1e3 * transitTime)} ms`;
    this.foot.textContent = `One way, end to end: ${way}${onset ? '; dashed: to and fro' : ''}.`;
    this.canvas.setAttribute(
      'aria-label',
      `How closely the windings of ${name} lie, from end 1 at the left to end 2, over time downwards: the wave takes ${way} from end to end.`,
    );
    this.turn();
    this.draw();
  }

  /** The time of the player [s]. */
  at(time: number): void {
    this.time = time;
    const [from, to] = this.page;
    if ((time < from || time > to) && this.turn()) this.draw();
    this.mark();
  }

  /** To the page of the player's time; whether it is another. */
  private turn(): boolean {
    if (!this.shown) return false;
    const page = pageAt(this.time, this.shown.times, this.shown.answer.facts.spring.transitTime);
    const isOther = page[0] !== this.page[0] || page[1] !== this.page[1];
    this.page = page;
    return isOther;
  }

  /** In the next frame, once. */
  private draw(): void {
    // Once in any case: a picture of the whole page has it, too. What moves while nobody sees it is not painted.
    if (this.waits || (!this.inSight && this.area) || !this.shown) return;
    this.waits = true;
    requestAnimationFrame(() => {
      this.waits = false;
      if (!this.shown) return;
      const begun = performance.now();
      this.area = paint(emptied(this.canvas), this.shown, this.page, this.peak, this.onset);
      performance.measure('strip', { start: begun, end: performance.now() });
      this.mark();
      // What a key moved while there was no picture, and the cross in one of another size.
      if (this.isPointing) this.tell();
    });
  }

  private mark(): void {
    const { area, page } = this;
    const part = (this.time - page[0]) / (page[1] - page[0]);
    this.line.hidden = !area || part < 0 || part > 1;
    if (!area || this.line.hidden) return;
    this.line.style.left = `${area.left}px`;
    this.line.style.width = `${area.width}px`;
    this.line.style.transform = `translateY(${area.top + part * area.height}px)`;
  }

  private point(event: PointerEvent | MouseEvent): void {
    const { area } = this;
    if (!area) return;
    const box = this.host.getBoundingClientRect();
    const along = clamp((event.clientX - box.left - area.left) / area.width, 0, 1);
    const down = clamp((event.clientY - box.top - area.top) / area.height, 0, 1);
    [this.pointed, this.isPointing] = [[along, down], true];
    this.value.setAttribute('aria-live', 'off');
    this.tell();
  }

  /** What is pointed at, with its place, time and value. */
  private tell(): void {
    const { area, shown } = this;
    if (!area || !shown) return;
    const [along, down] = this.pointed;
    const { frames, answer } = shown;
    const time = this.page[0] + down * (this.page[1] - this.page[0]);
    const first = nearest(frames.times, time) * frames.columns;
    const strain = strains(frames.positions.subarray(first, first + frames.columns));
    const value = strain[Math.round(along * (strain.length - 1))] ?? 0;
    const place = `${fixed(1e3 * along * answer.facts.meanLength, 0)} mm`;
    const words = Math.abs(value) < 5e-6 ? 'as wide as the mean' : value < 0 ? 'closer' : 'wider';
    const much = Math.abs(value) < 5e-6 ? '' : `${digits(100 * Math.abs(value), 2)} % `;
    const told = `At ${place} and ${fixed(1e3 * time, 1)} ms: ${much}${words}.`;
    // The same words once more would be read out again.
    if (this.value.textContent !== told) this.value.textContent = told;
    this.cross.hidden = false;
    this.cross.style.transform = `translate(${area.left + along * area.width}px, ${area.top + down * area.height}px)`;
  }

  private rest(): void {
    this.isPointing = false;
    this.cross.hidden = true;
    this.value.textContent = 'Colours as of the coil.';
  }

  private go(): void {
    this.goTo(this.page[0] + this.pointed[1] * (this.page[1] - this.page[0]));
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = event.shiftKey ? 0.1 : 0.02;
    const [along, down] = this.pointed;
    const moved: Record<string, [number, number]> = {
      ArrowLeft: [along - step, down],
      ArrowRight: [along + step, down],
      ArrowUp: [along, down - step],
      ArrowDown: [along, down + step],
    };
    const to = moved[event.key];
    if (!to && event.key !== 'Enter') return;
    event.preventDefault();
    if (!to) return this.go();
    [this.pointed, this.isPointing] = [[clamp(to[0], 0, 1), clamp(to[1], 0, 1)], true];
    this.value.setAttribute('aria-live', 'polite');
    this.tell();
  }
}
