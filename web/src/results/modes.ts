// Every mode of the coil, folded: what it takes is loaded and asked for once somebody opens it.
//
// Next door: what is in it (`modes/part`).

import type { Compute } from '../compute';
import { make } from '../dom';
import { part } from '../faults';
import type { Case, Part } from '../modes/part';

export class Modes {
  private readonly element = make('details', {}, make('summary', {}, 'Every mode of the coil'));
  private part: Promise<Part> | null = null;
  private shown: Case | null = null;

  constructor(
    host: HTMLElement,
    private readonly compute: Compute,
  ) {
    host.replaceChildren(this.element);
    this.element.addEventListener('toggle', () => this.fill());
  }

  /** The case that is shown; null while it is not exact: what stands there is then of an earlier one. */
  show(shown: Case | null): void {
    this.shown = shown;
    this.fill();
  }

  private fill(): void {
    if (!this.element.open) return;
    this.part ??= part('Every mode of the coil', () => import('../modes/part')).then(
      ({ Part }) => new Part(this.element, this.compute),
    );
    void this.part.then((part) => part.show(this.shown));
  }
}
