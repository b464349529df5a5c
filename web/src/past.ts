// What can be undone: for each tab the part of the state that is its own, as it was before each change.
//
// Next door: who keeps the state (`store`), what it is (`state`).

import { preset } from './presets';
import { defaultView, type State, type View } from './state';

/** Changes of one kind that follow each other so quickly are undone as one [ms]. */
const ONE_GESTURE = 800;
const MOST_STEPS = 200;

type Part = Pick<State, 'view'> & Partial<State>;

/** What of the view each tab's controls change; the tab that is shown is no part of any. The spring is the first one's, too. */
export const PARTS: Record<string, readonly (keyof View)[]> = {
  spring: ['condition', 'damping', 'times', 'hidden', 'sensors', 'slow', 'frequency'],
  log: ['log'],
  mitigate: ['mitigate'],
};

/** What of a state is a tab's own; `exchanged`: with what is kept, which only a step that changes it takes back. */
function part(tab: string, { view, ...spring }: State, exchanged = false): Part {
  const keys = [...(PARTS[tab] ?? []), ...(exchanged && tab === 'spring' ? (['kept'] as const) : [])];
  const own = Object.fromEntries(keys.map((key) => [key, view[key]])) as unknown as View;
  return { ...(tab === 'spring' ? spring : {}), view: own };
}

const put = (state: State, part: Part): State => ({ ...state, ...part, view: { ...state.view, ...part.view } });

/** The steps of one tab. */
class Steps {
  readonly back: Part[] = [];
  readonly forth: Part[] = [];
  private gesture = { name: '', at: 0 };

  add(part: Part, name: string): void {
    const at = performance.now();
    const goesOn = name !== '' && name === this.gesture.name && at - this.gesture.at < ONE_GESTURE;
    if (!goesOn) this.back.push(part);
    if (this.back.length > MOST_STEPS) this.back.shift();
    this.forth.length = 0;
    this.gesture = { name, at };
  }

  /** The next step one way; what was is the next one the other way. */
  step(way: 'back' | 'forth', now: (next: Part) => Part): Part | undefined {
    const next = this[way].pop();
    if (!next) return next;
    this[way === 'back' ? 'forth' : 'back'].push(now(next));
    this.gesture.name = '';
    return next;
  }
}

export class Past {
  private readonly steps = new Map(Object.keys(PARTS).map((tab) => [tab, new Steps()]));

  /** Remembers what a change is of: a link that was followed changes the parts of several tabs. */
  add(before: State, next: State, gesture: string): void {
    for (const [tab, steps] of this.steps) {
      const exchanged = before.view.kept !== next.view.kept;
      const old = part(tab, before, exchanged);
      if (JSON.stringify(old) !== JSON.stringify(part(tab, next, exchanged))) steps.add(old, gesture);
    }
  }

  can(way: 'back' | 'forth', tab: string): boolean {
    return (this.steps.get(tab)?.[way].length ?? 0) > 0;
  }

  /** The state with the last change of the tab that it shows taken back, or made again; null where there is none. */
  go(way: 'back' | 'forth', state: State): State | null {
    const { tab } = state.view;
    const found = this.steps.get(tab)?.step(way, ({ view }) => part(tab, state, 'kept' in view));
    return found ? put(state, found) : null;
  }
}

/** The state with the part of a tab as it comes, with a preset where that is the spring's; the same where the tab has none. */
export function afresh(state: State, tab: string, id = state.preset): State {
  const { slow, hidden } = state.view;
  const { id: known, spec } = preset(id);
  return put(
    state,
    part(tab, { preset: known, spec: structuredClone(spec), view: { ...defaultView(), slow, hidden } }),
  );
}
