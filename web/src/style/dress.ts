// The styles of the tabs Log and Mitigate, which come with them.
//
// Next door: how they are put on (`wear`).

import figures from './figures.css?inline';
import jobs from './jobs.css?inline';
import log from './log.css?inline';
import { wear } from './wear';

export const dress = (): void => wear(figures, jobs, log);
