// Which times are shown, by buttons that say them; the one that is shown stands out.
//
// Next door: the plot that is zoomed (`forces`).

import type { Shown } from '../compute';
import { digits, fixed, make } from '../dom';
import type { Store } from '../store';
import type { ForcePlot } from './forces';

type Times = [number, number];

/** `0–111 ms`, or `0.75–1 s` where it is long. */
const span = ([from, to]: Times): string =>
  to < 0.5 ? `${fixed(1e3 * from, 0)}–${fixed(1e3 * to, 0)}\u00a0ms` : `${digits(from)}–${digits(to)}\u00a0s`;

export class Views {
  private shown: Shown | null = null;
  /** The first surge periods of the condition, once they were shown. */
  private first: { of: string; times: Times } | null = null;
  private readonly buttons: HTMLButtonElement[];

  constructor(
    private readonly store: Store,
    host: HTMLElement,
    forces: ForcePlot,
  ) {
    const button = (label: string, title: string, act: () => void) =>
      make('button', { type: 'button', class: 'plain', title, onclick: act }, label);
    this.buttons = [
      button('First ringing', 'The first surge periods', () => this.store.setView({ times: null })),
      button('Judged', 'The part that the table is about', () => this.store.setView({ times: this.judged })),
      button('All', 'All that was simulated', () => this.store.setView({ times: this.all })),
    ];
    host.replaceChildren(
      ...this.buttons,
      button('+', 'Zoom in', () => forces.timeline.zoomBy(2)),
      button('−', 'Zoom out', () => forces.timeline.zoomBy(0.5)),
    );
  }

  private get condition() {
    return this.shown?.answer.facts.conditions[this.shown.answer.facts.condition];
  }

  private get judged(): Times | null {
    return this.condition?.window ?? null;
  }

  private get all(): Times {
    return [0, this.condition?.duration ?? 1];
  }

  show(shown: Shown): void {
    this.shown = shown;
    const { spec, view } = this.store.state;
    const of = JSON.stringify([spec, view.condition]);
    if (!view.times) this.first = { of, times: shown.times };
    const known = this.first?.of === of ? this.first.times : null;
    const choices: [string, Times | null][] = [
      ['ringing', known],
      ['judged', this.judged],
      ['all', this.all],
    ];
    const is = (times: Times | null) => times !== null && String(times) === String(shown.times);
    const active = view.times ? choices.findIndex(([, times]) => is(times)) : 0;
    choices.forEach(([word, times], index) => {
      const button = this.buttons[index];
      if (!button) return;
      button.textContent = times ? `${span(times)} (${word})` : word;
      button.setAttribute('aria-pressed', String(index === active));
    });
  }
}
