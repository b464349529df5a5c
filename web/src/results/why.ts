// Why the two ends disagree, in four steps of a hit; folded, and loaded once somebody opens it.
//
// Next door: what is in it (`tour`).

import type { Shown } from '../compute';
import { make } from '../dom';
import { part } from '../faults';
import type { Store } from '../store';
import type { Tour } from './tour';

export class Why {
  private readonly element = make('details', {}, make('summary', {}, 'Why the ends disagree, in four steps'));
  private tour: Promise<Tour> | null = null;
  private shown: Shown | null = null;

  /** `look` shows times and moves the mark to one of them. */
  constructor(
    host: HTMLElement,
    private readonly store: Store,
    private readonly look: (times: [number, number], at: number) => void,
  ) {
    host.replaceChildren(this.element);
    this.element.addEventListener('toggle', () => this.fill());
  }

  show(shown: Shown): void {
    this.shown = shown;
    this.fill();
  }

  private fill(): void {
    if (!this.element.open || !this.shown) return;
    const { shown } = this;
    this.tour ??= part('What tells why', () => import('./tour')).then(
      ({ Tour }) => new Tour(this.element, this.store, this.look),
    );
    void this.tour.then((tour) => tour.show(shown));
  }
}
