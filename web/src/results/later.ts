// What is below the first screen is loaded once there are curves: whoever waits for those does not wait for it.
//
// Next door: what is in it (`below`).

import type { Shown } from '../compute';
import { part } from '../faults';
import type { Around, Below } from './below';
import type { Outcome } from './outcome';

export class Later {
  private below: Below | null = null;
  private shown: Shown | null = null;
  private outcome: Outcome | null = null;

  /** `ready` hears that it is there, and shows what was shown last. */
  constructor(
    private readonly around: Around,
    private readonly ready: (shown: Shown) => void,
  ) {}

  /** Whether there is nothing more to wait for. */
  get isThere(): boolean {
    return this.below !== null;
  }

  load(): void {
    void part('What is below the plots', () => import('./below')).then(({ Below }) => {
      this.below = new Below(this.around);
      this.below.judge(this.outcome);
      if (!this.shown) return;
      this.below.show(this.shown);
      this.ready(this.shown);
    });
  }

  judge(outcome: Outcome | null): void {
    this.outcome = outcome;
    this.below?.judge(outcome);
  }

  show(shown: Shown): void {
    this.shown = shown;
    this.below?.show(shown);
  }
}
