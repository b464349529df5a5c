// The verdict, loaded with its card once the first case is exact.
//
// Next door: the card (`verdict`), who asks for it (`judge`).

import type { Compute } from '../compute';
import { part } from '../faults';
import type { Judge } from './judge';
import type { Outcome } from './outcome';

export class Judged {
  private judge: Promise<Judge> | null = null;

  /** `told` hears each verdict, and null while there is none of the state or none can be had. */
  constructor(
    private readonly host: HTMLElement,
    private readonly compute: Compute,
    private readonly told: (outcome: Outcome | null, failed: boolean) => void,
  ) {}

  /** The spec of the exact case; null while the state moves. */
  show(text: string | null): void {
    // An embedded page does not show it.
    if ((text === null && !this.judge) || document.documentElement.classList.contains('embed')) return;
    this.judge ??= this.load();
    void this.judge.then((judge) => (text === null ? judge.moved() : judge.rests(text)));
  }

  private async load(): Promise<Judge> {
    const [{ Verdict }, { Judge }] = await part('The verdict', () =>
      Promise.all([import('./verdict'), import('./judge')]),
    );
    const card = new Verdict(this.host, () => judge.again());
    const judge = new Judge(this.compute, (standing) => {
      card.show(standing);
      this.told(standing.kind === 'judged' ? standing.outcome : null, standing.kind === 'failed');
    });
    return judge;
  }
}
