// Which length, which way of the ends and which mode are looked at: a slider, a list and what the chart and the table pick.
//
// Next door: what is shown of it (`part`).

import type { ExactFacts } from '../answer';
import { clamp, make } from '../dom';
import type { Curve, Lines } from './lines';

/** Lengths that are no farther apart are one [m]. */
const SAME = 1e-9;

type Moved = 'way' | 'length' | 'number';

export class Choice {
  way = 0;
  number = 1;
  private stops: number[] = [0];
  private own = NaN;
  private condition = '';
  private spring = '';
  private all: Lines | null = null;
  private readonly slider = make('input', { type: 'range', min: 0, max: 0, step: 1, 'aria-label': 'Length' });
  private readonly told = make('output', { class: 'length', 'aria-live': 'off' });
  private readonly ends = make('select', { 'aria-label': 'Ends' });
  readonly element = make('div', { class: 'stops' }, make('label', {}, 'Length ', this.slider), this.told, this.ends);

  constructor(private readonly moved: (moved: Moved) => void) {
    this.slider.addEventListener('input', () => this.tell('length'));
    this.ends.addEventListener('change', () => {
      this.way = this.ends.selectedIndex;
      this.tell('way');
    });
  }

  /** The chosen length [m]. */
  get length(): number {
    return this.stops[Number(this.slider.value)] ?? 0;
  }

  /** Takes over what there is to choose; what was chosen stays, unless it is of another spring. */
  show(lines: Lines, { spring, meanLength, conditions, condition }: ExactFacts): void {
    const wasOwn = this.spring !== spring.name || Math.abs(this.length - this.own) < SAME;
    const length = wasOwn ? meanLength : this.length;
    const apart = lines.lengths.filter((other) => Math.abs(other - meanLength) > SAME);
    this.stops = [...apart, meanLength].sort((a, b) => a - b);
    this.slider.max = String(this.stops.length - 1);
    this.slider.value = String(this.nearest(length));
    this.own = meanLength;
    this.condition = conditions[condition]?.name ?? '';
    this.ends.replaceChildren(...lines.ways.map(({ ends }) => make('option', {}, ends)));
    this.way = Math.min(this.way, lines.ways.length - 1);
    this.ends.selectedIndex = this.way;
    this.ends.hidden = lines.ways.length < 2;
    this.all = lines;
    if (this.spring !== spring.name) this.number = this.firstAxial();
    this.spring = spring.name;
    this.say();
  }

  /** A mode by its number, and where it is said a length [m]. */
  pick(number: number, length?: number): void {
    this.number = Math.max(1, number);
    if (length !== undefined) this.slider.value = String(this.nearest(length));
    this.tell(length === undefined ? 'number' : 'length');
  }

  /** The next length or the one before. */
  step(by: number): void {
    this.slider.value = String(clamp(Number(this.slider.value) + by, 0, this.stops.length - 1));
    this.tell('length');
  }

  /** The lowest axial mode at the chosen length: the surge. */
  private firstAxial(): number {
    const { lengths = [], ways } = this.all ?? {};
    const at = lengths.findLastIndex((length) => length <= this.length + SAME);
    const isThere = ({ kind, values }: Curve) => kind === 'axial' && typeof values[at] === 'number';
    const numbers = (ways?.[this.way]?.curves ?? []).filter(isThere).map(({ number }) => number);
    return numbers.length > 0 ? Math.min(...numbers) : 1;
  }

  private nearest(length: number): number {
    const far = this.stops.map((stop) => Math.abs(stop - length));
    return far.indexOf(Math.min(...far));
  }

  private tell(moved: Moved): void {
    this.say();
    this.moved(moved);
  }

  private say(): void {
    const isOwn = Math.abs(this.length - this.own) < SAME;
    const words = `${(1e3 * this.length).toFixed(1)} mm${isOwn ? `, of ${this.condition}` : ''}`;
    this.told.textContent = words;
    this.slider.setAttribute('aria-valuetext', words);
  }
}
