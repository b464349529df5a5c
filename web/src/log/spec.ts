// Between the tabs Spring and Log: a log simulated of the one's spring, and the other's spring as the state.
//
// Next door: who offers both (`tabs/log`), specs (`document`).

import { parse } from 'smol-toml';
import type { Job } from '../answer';
import { toToml, type Spec } from '../document';
import type { Store } from '../store';

/** A simulated log of the spring and the condition that are shown. */
export function trialJob({ state }: Store): Job {
  const { condition, damping } = state.view;
  return { kind: 'trial', text: toToml(state.spec).text, condition, damping };
}

/** Puts a spec's spring, conditions and sensors in place of the state's, and shows them. */
export function openSpec(store: Store, text: string): void {
  // Of what stands above all tables the page has no need.
  const spec = Object.fromEntries(Object.entries(parse(text)).filter(([, table]) => typeof table === 'object')) as Spec;
  store.setSpec(spec, '', { tab: 'spring', condition: 0, damping: 0, times: null });
}
