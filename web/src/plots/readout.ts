// Which line is which, and its value where the mark is.
//
// Next door: the curves (`forces`).

import type { Shown } from '../compute';
import { clamp, fixed, make, rich, word, type Child } from '../dom';
import { nearest } from '../spring/scene';
import type { Line } from './lines';
import { NAMES, sample } from './looks';

/** Curves nearer than this to one another all along, of the nominal force, are one on any screen [1]. */
const TOGETHER = 5e-4;

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
    const isOne = ['F_x', 'F_L'].every((name) => lines.some((line) => line.name === name)) && lieTogether(shown);
    const now = JSON.stringify([lines, isOne]);
    if (now !== this.drawn) this.draw(isOne);
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

  /** `isOne`: the curves by length and by inductance cannot be told apart, and one value stands for both. */
  private draw(isOne: boolean): void {
    // They change with each frame: what a reader is to hear of them is told elsewhere.
    this.values = this.lines.map(() => make('output', { 'aria-live': 'off' }));
    const parts = ({ series, name }: Line): Child[] => [
      sample(series),
      isOne && name === 'F_L' && make('span', { class: 'short' }, '≈'),
      make('span', {}, ...names(name)),
    ];
    const keys = this.lines.map((line, index) => {
      const value = this.values[index];
      if (isOne && line.name === 'F_x') return make('span', {}, ...parts(line));
      // On a phone the sign alone says that they are one.
      return make('span', {}, ...parts(line), isOne && line.name === 'F_L' && long(' both'), value);
    });
    const limit = make('span', {}, make('i', { class: 'limit' }), make('span', {}, long('within your '), 'limit'));
    this.host.replaceChildren(...keys, limit);
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

/** What a phone leaves out. */
const long = (...words: Child[]) => make('span', { class: 'long' }, ...words);

/** Of a force its name, then its symbol; of a sensor its name. */
function names(name: string): Child[] {
  // The longest name; on a phone its symbol has to do.
  if (name === 'F_L') return [word(name, make('b', { class: 'long' }, NAMES[name]), long(' ('), rich(name), long(')'))];
  const known = NAMES[name];
  return [known ? word(name, make('b', {}, known)) : make('b', {}, name), known && long(' (', rich(name), ')')];
}

/** Whether the forces by length and by inductance are one all over the shown times. */
function lieTogether({ answer, times }: Shown): boolean {
  const { F_x: one, F_L: other, time } = answer.series;
  if (!one || !other || !time) return false;
  const most = TOGETHER * answer.facts.spring.nominalForce;
  return time.every(
    (at, index) => at < times[0] || at > times[1] || Math.abs((one[index] ?? 0) - (other[index] ?? NaN)) < most,
  );
}
