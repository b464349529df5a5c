// Which line is which, and its value where the mark is.
//
// Next door: the curves (`forces`).

import type { Shown } from '../compute';
import { clamp, fixed, make, rich } from '../dom';
import { nearest } from '../spring/scene';
import { FORCE_NAMES, MEANING, sample } from './looks';

/** Numbers that change faster than this cannot be read [ms]. */
const PAUSE = 120;

export class ReadOut {
  private readonly values = FORCE_NAMES.map(() => make('output'));
  private shown: Shown | null = null;
  private time = 0;
  private last = 0;

  constructor(host: HTMLElement) {
    const key = (name: string, index: number) =>
      make(
        'span',
        {},
        sample(name),
        make('span', {}, make('b', {}, rich(name)), ` ${MEANING[name]} `, this.values[index]),
      );
    host.replaceChildren(...FORCE_NAMES.map(key), make('span', {}, make('i', { class: 'limit' }), 'within your limit'));
  }

  show(shown: Shown): void {
    this.shown = shown;
    this.write();
  }

  at(time: number, inMotion: boolean): void {
    this.time = time;
    const now = performance.now();
    if (inMotion && now - this.last < PAUSE) return;
    this.last = now;
    this.write();
  }

  private write(): void {
    if (!this.shown) return;
    const { facts, series } = this.shown.answer;
    const index = nearest(series['time'] ?? new Float64Array(1), this.time);
    const decimals = clamp(3 - Math.floor(Math.log10(facts.spring.nominalForce)), 0, 3);
    FORCE_NAMES.forEach((name, at) =>
      this.values[at]?.replaceChildren(`${fixed(series[name]?.[index] ?? NaN, decimals)} N`),
    );
  }
}
