// How the kinds of modes look: in the report's colours, and with a dash each.

import type { Kind } from '../answer';
import type { Look } from '../plots/looks';

export const LOOKS: Readonly<Record<Kind, Look>> = {
  axial: { colour: 'red', dash: [], width: 1.8 },
  torsional: { colour: 'green', dash: [9, 3, 2, 3], width: 1.8 },
  lateral: { colour: 'blue', dash: [7, 4], width: 1.6 },
  mixed: { colour: 'ink', dash: [2, 2.5], width: 1.6 },
};

/** What a kind is, for people. */
export const MEANING: Readonly<Record<Kind, string>> = {
  axial: 'windings move along the axis',
  torsional: 'windings turn about the axis',
  lateral: 'windings move sideways',
  mixed: 'none of these alone',
};
