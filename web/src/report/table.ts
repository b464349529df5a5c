// Every signal of a case: which line it is, whether it is drawn, its value and error at a moment, its largest error in what is shown.
//
// Next door: the lines (`charts`), which moment (`viewer`).

import { fixed, make, rich } from '../dom';
import { sample } from '../plots/looks';
import type { Times } from '../plots/timeline';
import { nearest } from '../spring/scene';
import { extent, type Case, type Signal } from './data';

interface Row {
  signal: Signal;
  value: HTMLElement;
  error: HTMLElement;
  percent: HTMLElement;
  worst: HTMLElement;
}

export class SignalTable {
  private readonly clock = make('th', { scope: 'col' });
  private readonly rows: Row[];

  /** `hidden` names what is not drawn; `toggled` hears of a signal that is to be drawn or hidden. */
  constructor(
    host: HTMLElement,
    private readonly shown: Case,
    private readonly nominal: number,
    hidden: ReadonlySet<string>,
    toggled: (name: string) => boolean,
  ) {
    this.rows = shown.signals.map((signal) => {
      const [value, error, percent, worst] = [make('td'), make('td'), make('td'), make('td')];
      return { signal, value, error, percent, worst };
    });
    const heads = ['Error [N]', '[% of F_nom]', 'Worst in view [N]'].map((title) =>
      make('th', { scope: 'col' }, rich(title)),
    );
    const head = make('tr', {}, make('th', { class: 'row', scope: 'col' }, 'Signal'), this.clock, ...heads);
    const line = ({ signal, value, error, percent, worst }: Row) => {
      const { name } = signal;
      const button = make('button', {
        type: 'button',
        class: 'line',
        title: 'Show or hide',
        'aria-pressed': String(!hidden.has(name)),
      });
      button.append(sample(signal.look), make('span', {}, rich(name)));
      button.addEventListener('click', () => button.setAttribute('aria-pressed', String(toggled(name))));
      return make('tr', {}, make('th', { class: 'row', scope: 'row' }, button), value, error, percent, worst);
    };
    host.replaceChildren(
      make('table', { class: 'signals' }, make('thead', {}, head), make('tbody', {}, ...this.rows.map(line))),
    );
  }

  /** Values at a time [s]. */
  at(time: number): void {
    const index = nearest(this.shown.times, time);
    this.clock.textContent = `at ${fixed(1e3 * (this.shown.times[index] ?? 0), 1)} ms`;
    for (const { signal, value, error, percent } of this.rows) {
      value.textContent = `${fixed(signal.values[index] ?? NaN, signal.decimals)} ${signal.unit}`;
      if (!signal.error) continue;
      const off = signal.error[index] ?? NaN;
      error.textContent = signed(off, this.shown.decimals);
      percent.textContent = signed((100 * off) / this.nominal, 2);
    }
  }

  /** Largest errors between two times [s]; those beyond the goal are marked. */
  within([from, to]: Times): void {
    const goal = this.shown.packed.goal_n ?? Infinity;
    const [first, last] = [nearest(this.shown.times, from), nearest(this.shown.times, to)];
    for (const { signal, worst } of this.rows) {
      const found = signal.error && extent(signal.error, first, last);
      if (!found) continue;
      const most = Math.max(-found[0], found[1]);
      worst.classList.toggle('off', most > goal);
      const beyond = most > goal && make('span', { class: 'range' }, 'beyond ±goal ');
      worst.replaceChildren(...(beyond ? [beyond] : []), fixed(most, this.shown.decimals));
    }
  }
}

/** With its sign, but zero. */
function signed(value: number, decimals: number): string {
  const text = fixed(value, decimals);
  return value > 0 && Number(text) !== 0 ? `+${text}` : text;
}
