// What a tab is. To add one: a file here that exports `open`, and a line in `all.ts`; see book/src/guide/page.md.
//
// Next door: the list of tabs (`all`), the page around them (`main`).

import type { Compute } from '../compute';
import type { Store } from '../store';

export interface Tab {
  /** As it stands in an address. */
  id: string;
  label: string;
  /** What stands below the title while the tab is shown; without it, the answer of the spring that is set up. */
  lead?: string;
  /** Its code, loaded when it is first looked at. */
  load(): Promise<{ open: Open }>;
}

/** Begins to work in its panel; called once. */
export type Open = (panel: HTMLElement, store: Store, compute: Compute) => void;
