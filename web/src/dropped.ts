// Files dropped anywhere on the page: a spec is opened in the tab Spring, with the recorded motions that it names; anything else is a log.
//
// Next door: who takes logs (`log/takers`), a spec as the state (`log/spec`).

import type { Compute } from './compute';
import { say } from './faults';
import { openSpec } from './log/spec';
import { give, specOf, takes } from './log/takers';
import type { Store } from './store';

export async function take(files: File[], store: Store, compute: Compute): Promise<void> {
  const spec = await specOf(files);
  if (spec) return open(spec, files, store, compute);
  const { tab, mitigate } = store.state.view;
  const isJudged = tab === 'mitigate' && mitigate['on'] === 'log' && takes(tab);
  if (!isJudged) store.setView({ tab: 'log' });
  give(isJudged ? tab : 'log', files);
}

async function open(spec: File, files: readonly File[], store: Store, compute: Compute): Promise<void> {
  try {
    const text = await spec.text();
    for (const file of files)
      if (file !== spec && text.includes(file.name)) compute.addFile(file.name, await file.text());
    openSpec(store, text);
  } catch (reason) {
    say(
      'file',
      `${spec.name} cannot be opened: ${reason instanceof Error ? (reason.message.split('\n')[0] ?? '') : String(reason)}.`,
    );
  }
}
