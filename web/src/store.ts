// One store of the page's state, with undo and redo, and its address with a step of the browser's history for each tab that was looked at;
// whoever shows something subscribes.
//
// Next door: what the state is (`state`), what can be undone (`past`), the state as an address (`address`).

import { fromHash, toHash } from './address';
import type { Spec } from './document';
import { afresh, PARTS, Past } from './past';
import type { State, View } from './state';

type Listener = (state: State, before: State) => void;

/** Browsers allow some hundred changes of an address a minute [ms]. */
const ADDRESS_WAITS = 250;

/** What a step of the browser's history is: a tab, since the last time that an address was followed. */
interface Step {
  tab: string;
  since: number;
}

export class Store {
  private now: State;
  private readonly past = new Past();
  private readonly listeners: Listener[] = [];
  private timer = 0;
  /** How often an address was followed. */
  private since = 0;

  /** `unread` hears what of an address says nothing. */
  constructor(private readonly unread: (words: string[]) => void) {
    this.now = this.read(location.hash);
    const { since } = (history.state ?? {}) as Partial<Step>;
    this.since = since ?? 0;
    history.replaceState(this.step, '');
    addEventListener('popstate', ({ state }) => this.follow(state as Step | null));
    // What was typed, even where the state before it was written into the address meanwhile; steps of our own were followed by now.
    addEventListener('hashchange', ({ newURL }) => {
      const { hash } = new URL(newURL);
      if (hash === toHash(this.now) || (history.state && newURL === location.href)) return;
      this.since++;
      this.put(this.read(hash), '', true);
    });
  }

  private read(hash: string): State {
    const { state, unread } = fromHash(hash);
    if (unread.length > 0) this.unread(unread);
    return state;
  }

  get state(): State {
    return this.now;
  }

  subscribe(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** A new spec; `gesture` names what the user does, so that a drag is undone as one. */
  setSpec(spec: Spec, gesture = '', view: Partial<View> = {}): void {
    this.put({ ...this.now, spec, view: { ...this.now.view, ...view } }, gesture);
  }

  /** What is shown; whether it can be undone, and as which gesture. */
  setView(view: Partial<View>, undoable = false, gesture = ''): void {
    const next = { ...this.now, view: { ...this.now.view, ...view } };
    if (undoable) this.put(next, gesture);
    else this.tell(next);
  }

  choosePreset(id: string): void {
    this.put(afresh(this.now, 'spring', id), '');
  }

  /** Whether there is anything that the tab changes. */
  get canReset(): boolean {
    return this.now.view.tab in PARTS;
  }

  /** The spec without what no spec has; there is no way back to that. */
  leaveOut(spec: Spec): void {
    this.tell({ ...this.now, spec });
  }

  /** What the tab changes, as it came. */
  reset(): void {
    this.put(afresh(this.now, this.now.view.tab), '');
  }

  get canUndo(): boolean {
    return this.past.can('back', this.now.view.tab);
  }

  get canRedo(): boolean {
    return this.past.can('forth', this.now.view.tab);
  }

  /** Takes back the last change that was made on the tab that is shown. */
  undo(): void {
    const before = this.past.go('back', this.now);
    if (before) this.tell(before);
  }

  redo(): void {
    const next = this.past.go('forth', this.now);
    if (next) this.tell(next);
  }

  /** The page's address as of now, also where it has not been written yet. */
  get address(): string {
    this.write();
    return location.href;
  }

  /** Another state; `isStep`: the browser's history has a step for it already. */
  put(next: State, gesture: string, isStep = false): void {
    this.past.add(this.now, next, gesture);
    this.tell(next, isStep);
  }

  /** `isStep`: the browser's history has a step for it already. */
  private tell(next: State, isStep = false): void {
    const before = this.now;
    // The step that is left has the state as it was left.
    if (next.view.tab !== before.view.tab && !isStep) {
      this.write();
      this.now = next;
      history.pushState(this.step, '', toHash(next));
    }
    this.now = next;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.write(), ADDRESS_WAITS);
    for (const listener of this.listeners) listener(next, before);
  }

  private get step(): Step {
    return { tab: this.now.view.tab, since: this.since };
  }

  private write(): void {
    clearTimeout(this.timer);
    history.replaceState(this.step, '', toHash(this.now));
  }

  /** A step back or forth: to its tab, with what was edited since; beyond an address that was followed, to all that it says. */
  private follow(step: Step | null): void {
    if (!step) return;
    clearTimeout(this.timer);
    if (step.since === this.since) return this.tell({ ...this.now, view: { ...this.now.view, tab: step.tab } }, true);
    this.since = step.since;
    this.put(this.read(location.hash), '', true);
  }
}
