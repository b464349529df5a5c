// Which line is which, and its value where the mark is.
//
// Next door: the curves (`forces`).

import type { Shown } from '../compute';
import { clamp, fixed, make, rich, word } from '../dom';
import { nearest } from '../spring/scene';
import type { Line } from './lines';
import { sample } from './looks';

export class ReadOut {
  private values: HTMLOutputElement[] = [];
  private lines: readonly Line[] = [];
  private drawn = '';
  private shown: Shown | null = null;
  private time = 0;

  constructor(private readonly host: HTMLElement) {}

  show(shown: Shown, lines: readonly Line[]): void {
    this.shown = shown;
    this.lines = lines;
    const now = JSON.stringify(lines);
    if (now !== this.drawn) this.draw();
    this.drawn = now;
    this.write();
  }

  at(time: number): void {
    this.time = time;
    this.write();
  }

  /** The same in a line. */
  get words(): string {
    const values = this.lines.map(({ name }, at) => `${name} ${this.values[at]?.textContent ?? ''}`);
    return `${fixed(1e3 * this.time, 1)} ms: ${values.join(', ')}`;
  }

  private draw(): void {
    // They change with each frame: what a reader is to hear of them is told elsewhere.
    this.values = this.lines.map(() => make('output', { 'aria-live': 'off' }));
    const key = ({ series, name, meaning }: Line, index: number) =>
      make(
        'span',
        {},
        sample(series),
        make('span', {}, make('b', {}, meaning ? word(name, rich(name)) : name), meaning && ` ${meaning}`),
        this.values[index],
      );
    const limit = make('span', {}, make('i', { class: 'limit' }), 'within your limit');
    this.host.replaceChildren(...this.lines.map(key), limit);
  }

  private write(): void {
    if (!this.shown) return;
    const { facts, series } = this.shown.answer;
    const index = nearest(series['time'] ?? new Float64Array(1), this.time);
    const decimals = clamp(3 - Math.floor(Math.log10(facts.spring.nominalForce)), 0, 3);
    this.lines.forEach((line, at) => {
      const value = series[line.series]?.[index];
      // A preview knows no sensors: they read again with the exact case.
      this.values[at]?.replaceChildren(value === undefined ? '…' : `${fixed(value, decimals)} N`);
    });
  }
}
