// The verdict, loaded with its card once the first case is exact.
//
// Next door: the card (`verdict`), who asks for it (`judge`).

import type { ExactFacts } from '../answer';
import type { Compute } from '../compute';
import { part } from '../faults';
import type { Judge } from './judge';
import type { Outcome } from './outcome';
import type { Verdict } from './verdict';

/** So long after the first exact case its curves are drawn and the page may be used [ms]. */
const DRAWN = 100;

export class Judged {
  private judge: Promise<Judge> | null = null;
  private card: Verdict | null = null;
  private facts: ExactFacts | null = null;

  /** `told` hears each verdict, and null while there is none of the state or none can be had. */
  constructor(
    private readonly host: HTMLElement,
    private readonly compute: Compute,
    private readonly told: (outcome: Outcome | null, failed: boolean) => void,
  ) {}

  /** The spec of the exact case, and that case; null while the state moves. */
  show(text: string | null, facts?: ExactFacts): void {
    // An embedded page does not show it.
    if ((text === null && !this.judge) || document.documentElement.classList.contains('embed')) return;
    // What is drawn comes first.
    this.judge ??= new Promise<void>((done) => setTimeout(done, DRAWN)).then(() => this.load());
    if (facts) this.facts = facts;
    void this.judge.then((judge) => {
      if (text === null) return judge.moved();
      if (this.facts) this.card?.about(this.facts);
      judge.rests(text);
    });
  }

  private async load(): Promise<Judge> {
    const [{ Verdict }, { Judge }] = await part('The verdict', () =>
      Promise.all([import('./verdict'), import('./judge')]),
    );
    const card = (this.card = new Verdict(this.host, () => judge.again()));
    const judge = new Judge(this.compute, (standing) => {
      card.show(standing);
      this.told(standing.kind === 'judged' ? standing.outcome : null, standing.kind === 'failed');
    });
    return judge;
  }
}
