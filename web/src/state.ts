// The page's state: a spec, and what of it is shown.
//
// Next door: who keeps it (`store`), the state as an address (`address`), what is computed from it (`compute`).

import type { Spec } from './document';

export interface View {
  tab: string;
  /** Numbers of the condition and of the damping that are shown. */
  condition: number;
  damping: number;
  /** Shown times [s]; null is the first surge periods. */
  times: [number, number] | null;
  /** Curves that are not drawn. */
  hidden: string[];
  /** Sensors whose readings are drawn, by name. */
  sensors: string[];
  /** Seconds of the spring per second of the viewer; zero as fits what is shown. */
  slow: number;
  /** At which frequency the two ends are looked at [Hz]; zero where nobody chose. */
  frequency: number;
  /** What is kept to compare, as an address has it; empty where nothing is. */
  kept: string;
  /** What the tab Mitigate is asked, where it is not as the command has it, and the name of the candidate that is picked. */
  mitigate: Record<string, string>;
  /** What the user says of a log, by the command's options; not the log itself. */
  log: Record<string, string>;
}

export interface State {
  preset: string;
  spec: Spec;
  view: View;
}

/** Whether another case is asked for, and not only other times of it. */
export const isOther = (state: State, before: State): boolean =>
  state.spec !== before.spec ||
  state.view.condition !== before.view.condition ||
  state.view.damping !== before.view.damping;

export const defaultView = (): View => ({
  tab: 'spring',
  condition: 0,
  damping: 0,
  times: null,
  hidden: [],
  sensors: [],
  slow: 0,
  frequency: 0,
  kept: '',
  mitigate: {},
  log: {},
});
