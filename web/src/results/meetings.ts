// Windings that meet: which, how often, how hard, for how long; loaded with the first that do.
//
// Next door: what is in it (`meet/card`), how they are asked to (`inputs/contact`).

import type { ExactFacts, Facts } from '../answer';
import { part } from '../faults';
import type { Card } from '../meet/card';

export class Meetings {
  private card: Promise<Card> | null = null;

  constructor(private readonly host: HTMLElement) {}

  /** Exact values; while there are none, the last ones in grey. */
  show(exact: ExactFacts | null, facts: Facts): void {
    this.host.hidden = facts.contact === null;
    if (!facts.contact) return;
    this.card ??= part('The card on windings that meet', () => import('../meet/card')).then(
      ({ Card }) => new Card(this.host),
    );
    void this.card.then((card) => card.show(exact));
  }
}
