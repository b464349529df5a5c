// Which times are shown, by buttons.
//
// Next door: the plot that is zoomed (`forces`).

import type { Shown } from '../compute';
import { make } from '../dom';
import type { Store } from '../store';
import type { ForcePlot } from './forces';

export class Views {
  private shown: Shown | null = null;

  constructor(
    private readonly store: Store,
    host: HTMLElement,
    forces: ForcePlot,
  ) {
    const button = (label: string, title: string, act: () => void) =>
      make('button', { type: 'button', class: 'plain', title, onclick: act }, label);
    const condition = () => this.shown?.answer.facts.conditions[this.shown.answer.facts.condition];
    host.replaceChildren(
      button('First ringing', 'The first six surge periods', () => this.store.setView({ times: null })),
      button('Judged', 'The part that the table is about', () =>
        this.store.setView({ times: condition()?.window ?? null }),
      ),
      button('All', 'All that was simulated', () => this.store.setView({ times: [0, condition()?.duration ?? 1] })),
      button('+', 'Zoom in', () => forces.timeline.zoomBy(2)),
      button('−', 'Zoom out', () => forces.timeline.zoomBy(0.5)),
    );
  }

  show(shown: Shown): void {
    this.shown = shown;
  }
}
