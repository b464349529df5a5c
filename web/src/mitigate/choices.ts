// What is asked, as words under the names of the command's options; kept in the address.
//
// Next door: the fields (`form`), the state (`state`).

import type { State } from '../state';
import type { Store } from '../store';

/** Beside the options: what it is judged on, the precision of settings, which candidate is picked. */
export type Name =
  | 'on'
  | 'rate'
  | 'noise'
  | 'bandwidth'
  | 'stiffness-tolerance'
  | 'mass-tolerance'
  | 'most-lag'
  | 'seeds'
  | 'precision'
  | 'candidate';

export class Choices {
  constructor(private readonly store: Store) {}

  /** Empty where nothing is said. */
  get(name: Name): string {
    return this.store.state.view.mitigate[name] ?? '';
  }

  set(name: Name, value: string): void {
    const { [name]: _, ...others } = this.store.state.view.mitigate;
    const mitigate = value === '' ? others : { ...others, [name]: value };
    this.store.setView({ mitigate }, true, `mitigate.${name}`);
  }

  /** Tells of every change of one of them. */
  follow(changed: (state: State, before: State) => void): void {
    this.store.subscribe((state, before) => state.view.mitigate !== before.view.mitigate && changed(state, before));
  }
}
