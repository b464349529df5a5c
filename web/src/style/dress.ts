// The styles of the tabs Log and Mitigate, which come with them: as text, since a sheet beside a script would be one more file to be missing.

import { make } from '../dom';
import jobs from './jobs.css?inline';
import log from './log.css?inline';

let isDressed = false;

export function dress(): void {
  if (!isDressed) document.head.append(make('style', {}, jobs, log));
  isDressed = true;
}
