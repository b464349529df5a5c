// All tabs, in the order in which they are shown. The first one is part of the first load; the others come when they are looked at.

import * as spring from './spring';
import type { Tab } from './tab';

export const TABS: readonly Tab[] = [
  { id: 'spring', label: 'Spring', load: () => Promise.resolve(spring) },
  { id: 'log', label: 'Log', load: () => import('./log') },
  { id: 'mitigate', label: 'Mitigate', load: () => import('./mitigate') },
  { id: 'paper', label: 'Paper', load: () => import('./paper') },
];
