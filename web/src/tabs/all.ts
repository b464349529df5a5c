// All tabs, in the order in which they are shown.

import { paperTab } from './paper';
import { springTab } from './spring';
import type { Tab } from './tab';

export const TABS: readonly Tab[] = [springTab, paperTab];
