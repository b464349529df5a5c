// Keeping a state to compare, and two sensors side by side: the button, and when what it takes is loaded.
//
// Next door: what is kept (`part`), sensors side by side (`pair`).

import type { Compute, Refusal, Shown } from '../compute';
import { make } from '../dom';
import { part } from '../faults';
import type { ForcePlot } from '../plots/forces';
import type { SpectrumPlot } from '../plots/spectrum';
import type { Outcome } from '../results/outcome';
import type { layOut } from '../tabs/layout';
import type { Store } from '../store';

/** What comparing has to do with. */
export interface Around {
  store: Store;
  compute: Compute;
  parts: ReturnType<typeof layOut>;
  forces: ForcePlot;
  spectrum: SpectrumPlot;
  last(): Shown | null;
  /** Why the present state cannot be computed. */
  refused(): Refusal | null;
}

/** The verdict of the present state: null while it is pending, or cannot be had. */
export interface Judgement {
  outcome: Outcome | null;
  failed: boolean;
}

export class Compare {
  readonly keep = make(
    'button',
    { type: 'button', class: 'plain', title: 'Holds what is shown behind what comes', onclick: () => this.press() },
    'Keep to compare',
  );
  judgement: Judgement = { outcome: null, failed: false };
  /** Hear of it. */
  readonly hearers: (() => void)[] = [];
  private kept: Promise<{ keep(): void }> | null = null;
  private pair: Promise<unknown> | null = null;

  constructor(readonly around: Around) {
    around.parts.views.append(this.keep);
    // A reload, a link and an undo bring what was kept, and which sensors are drawn.
    around.store.subscribe(() => this.want());
    this.want();
  }

  judged(outcome: Outcome | null, failed: boolean): void {
    this.judgement = { outcome, failed };
    for (const hear of this.hearers) hear();
  }

  private press(): void {
    void this.load().then((kept) => kept.keep());
  }

  private want(): void {
    const { kept, sensors } = this.around.store.state.view;
    if (kept) void this.load();
    if (sensors.length > 1)
      this.pair ??= part('Sensors side by side', () => import('./pair')).then(({ Pair }) => new Pair(this));
  }

  private load(): Promise<{ keep(): void }> {
    return (this.kept ??= part('What compares states', () => import('./part')).then(({ Part }) => new Part(this)));
  }
}
