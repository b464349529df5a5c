// Styles of a part that is loaded later: they come with its script, as text, since a sheet beside it would be one more file to be missing.

import { make } from '../dom';

const worn = new Set<string>();

/** Puts a sheet's text on the page, once. */
export function wear(...sheets: string[]): void {
  for (const sheet of sheets) {
    if (!worn.has(sheet)) document.head.append(make('style', {}, sheet));
    worn.add(sheet);
  }
}
