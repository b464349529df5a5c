// A part that is folded: what it takes is loaded and asked for once somebody opens it, or a link does.
//
// Next door: what is in such parts (`modes/part`, `response/part`).

import type { ExactFacts } from '../answer';
import { make } from '../dom';

/** An exact case, and the spec that it is of. */
export type Case = ExactFacts & { text: string };

/** What is in one; it is shown null while the case is not exact: what stands there is then of an earlier one. */
export interface Shows {
  show(shown: Case | null): void;
}

export class Folded {
  private readonly element: HTMLDetailsElement;
  private part: Promise<Shows> | null = null;
  private shown: Case | null = null;

  constructor(
    host: HTMLElement,
    private readonly title: string,
    private readonly load: (element: HTMLElement, title: string) => Promise<Shows>,
  ) {
    this.element = make('details', {}, make('summary', {}, title));
    host.replaceChildren(this.element);
    this.element.addEventListener('toggle', () => this.fill());
  }

  show(shown: Case | null): void {
    this.shown = shown;
    this.fill();
  }

  open(): void {
    this.element.open = true;
  }

  private fill(): void {
    if (!this.element.open) return;
    this.part ??= this.load(this.element, this.title);
    void this.part.then((part) => part.show(this.shown));
  }
}
