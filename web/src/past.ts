// What can be undone: for each tab the part of the state that is its own, as it was before each change.
//
// Next door: who keeps the state (`store`), what it is (`state`).

import { preset } from './presets';
import { defaultView, type State, type View } from './state';

/** Changes of one kind that follow each other so quickly are undone as one [ms]. */
const ONE_GESTURE = 800;
const MOST_STEPS = 200;

type Part = Partial<Omit<State, 'view'>> & { view: Partial<View> };

const OF_SPRING = ['condition', 'damping', 'times', 'hidden', 'sensors', 'slow'] as const;

/** What of a state each tab's controls change; the tab that is shown is no part of any. */
const PARTS: Record<string, (state: State) => Part> = {
  spring: ({ preset, spec, view }) => ({
    preset,
    spec,
    view: Object.fromEntries(OF_SPRING.map((key) => [key, view[key]])),
  }),
  log: ({ view }) => ({ view: { log: view.log } }),
  mitigate: ({ view }) => ({ view: { mitigate: view.mitigate } }),
};

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
  step(from: Part[], to: Part[], now: Part): Part | null {
    const part = from.pop();
    if (!part) return null;
    to.push(now);
    this.gesture.name = '';
    return part;
  }
}

export class Past {
  private readonly steps = new Map(Object.keys(PARTS).map((tab) => [tab, new Steps()]));

  /** Remembers what a change is of: a link that was followed changes the parts of several tabs. */
  add(before: State, next: State, gesture: string): void {
    for (const [tab, part] of Object.entries(PARTS)) {
      const [old, young] = [part(before), part(next)];
      if (JSON.stringify(old) !== JSON.stringify(young)) this.steps.get(tab)?.add(old, gesture);
    }
  }

  can(way: 'back' | 'forth', tab: string): boolean {
    return (this.steps.get(tab)?.[way].length ?? 0) > 0;
  }

  /** The state with the last change of the tab that it shows taken back, or made again; null where there is none. */
  go(way: 'back' | 'forth', state: State): State | null {
    const { tab } = state.view;
    const [steps, part] = [this.steps.get(tab), PARTS[tab]];
    if (!steps || !part) return null;
    const found = steps.step(steps[way], steps[way === 'back' ? 'forth' : 'back'], part(state));
    return found && put(state, found);
  }
}

/** The state with the part of the tab that it shows as that came; null where the tab has none. */
export function afresh(state: State): State | null {
  const { tab } = state.view;
  const part = PARTS[tab];
  if (!part) return null;
  const { slow, hidden } = state.view;
  const { id, spec } = preset(state.preset);
  const whole = { preset: id, spec: structuredClone(spec), view: { ...defaultView(), slow, hidden } };
  return put(state, part(whole));
}
