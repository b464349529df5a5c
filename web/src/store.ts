// One store of the page's state, with undo and redo; whoever shows something subscribes.
//
// Next door: what the state is (`state`), the state as an address (`address`).

import { fromHash, toHash } from './address';
import type { Spec } from './document';
import { preset } from './presets';
import { defaultView, type State, type View } from './state';

type Listener = (state: State, before: State) => void;

/** Changes of one kind that follow each other so quickly are undone as one [ms]. */
const ONE_GESTURE = 800;
const MOST_STEPS = 200;
/** Browsers allow some hundred changes of an address a minute [ms]. */
const ADDRESS_WAITS = 250;

export class Store {
  private now: State;
  private readonly past: State[] = [];
  private readonly future: State[] = [];
  private readonly listeners: Listener[] = [];
  private gesture = { name: '', at: 0 };
  private timer = 0;

  constructor() {
    this.now = fromHash(location.hash);
    // What was typed, even where the state before it was written into the address meanwhile.
    addEventListener('hashchange', ({ newURL }) => {
      const { hash } = new URL(newURL);
      if (hash !== toHash(this.now)) this.put(fromHash(hash), '');
    });
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
    const { id: name, spec } = preset(id);
    const { tab, slow, hidden, mitigate, log } = this.now.view;
    this.put(
      { preset: name, spec: structuredClone(spec), view: { ...defaultView(), tab, slow, hidden, mitigate, log } },
      '',
    );
  }

  /** Back to the preset as it was. */
  reset(): void {
    this.choosePreset(this.now.preset);
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  undo(): void {
    const before = this.past.pop();
    if (!before) return;
    this.future.push(this.now);
    this.gesture.name = '';
    this.tell(before);
  }

  redo(): void {
    const next = this.future.pop();
    if (!next) return;
    this.past.push(this.now);
    this.gesture.name = '';
    this.tell(next);
  }

  private put(next: State, gesture: string): void {
    const at = performance.now();
    const goesOn = gesture !== '' && gesture === this.gesture.name && at - this.gesture.at < ONE_GESTURE;
    if (!goesOn) this.past.push(this.now);
    if (this.past.length > MOST_STEPS) this.past.shift();
    this.future.length = 0;
    this.gesture = { name: gesture, at };
    this.tell(next);
  }

  private tell(next: State): void {
    const before = this.now;
    this.now = next;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => history.replaceState(null, '', toHash(this.now)), ADDRESS_WAITS);
    for (const listener of this.listeners) listener(next, before);
  }
}
