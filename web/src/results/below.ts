// What is below the first screen: how far each force is off, what must be known before the numbers are used, what may be downloaded.
//
// Next door: who loads it (`later`), its parts (`table`, `warnings`, `downloads`).

import type { Compute, Shown } from '../compute';
import { part } from '../faults';
import type { ForcePlot } from '../plots/forces';
import type { Store } from '../store';
import css from '../style/below.css?inline';
import figures from '../style/figures.css?inline';
import { wear } from '../style/wear';
import type { layOut } from '../tabs/layout';
import { Downloads } from './downloads';
import { Folded } from './folded';
import type { Outcome } from './outcome';
import { Table } from './table';
import { showWarnings, springLine } from './warnings';

/** What it has to do with. */
export interface Around {
  store: Store;
  compute: Compute;
  parts: ReturnType<typeof layOut>;
  forces: ForcePlot;
}

export class Below {
  private readonly table: Table;
  private readonly downloads: Downloads;
  private readonly speeds: Folded;

  constructor(private readonly around: Around) {
    wear(figures, css);
    const { store, compute, parts, forces } = around;
    this.table = new Table(store, parts.table);
    this.downloads = new Downloads(store, compute, parts.downloads, () => forces.plot);
    this.speeds = new Folded(parts.speeds, 'Over the speed of the recording', async (element, title) => {
      const { Part } = await part(title, () => import('../speeds/part'));
      return new Part(element, compute, store);
    });
  }

  /** Of the verdict; null while there is none. */
  judge(outcome: Outcome | null): void {
    this.table.judge(outcome);
  }

  show(shown: Shown): void {
    const { parts } = this.around;
    const { facts } = shown.answer;
    this.table.show(facts, shown.exact);
    showWarnings(parts.warnings, facts, shown.exact?.facts ?? null);
    parts.facts.replaceChildren(springLine(facts));
    this.downloads.show(shown);
    const isRecorded = facts.conditions[facts.condition]?.kind === 'recorded';
    parts.speeds.hidden = !isRecorded;
    if (isRecorded) this.speeds.show(shown.exact && { ...shown.exact.facts, text: shown.exactText });
  }
}
