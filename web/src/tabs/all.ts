// All tabs, in the order in which they are shown. The first one is part of the first load; the others come when they are looked at.

import * as spring from './spring';
import type { Tab } from './tab';

export const TABS: readonly Tab[] = [
  { id: 'spring', label: 'Spring', load: () => Promise.resolve(spring) },
  {
    id: 'log',
    label: 'Log',
    lead: 'Drop a recording of your own spring: what rings, how strongly it is damped, how far its forces can be trusted.',
    load: () => import('./log'),
  },
  { id: 'mitigate', label: 'Mitigate', load: () => import('./mitigate') },
  {
    id: 'paper',
    label: 'Paper',
    lead: 'Where it comes from: tables and figures of a paper on two springs of walking robots, computed beside the printed numbers.',
    load: () => import('./paper'),
  },
];
