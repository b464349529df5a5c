// Files for the user's disk.

import type { Shown } from './compute';
import { make } from './dom';

/** A name for files of what is shown: the spring's and the condition's. */
export function nameOf(shown: Shown | null): string {
  const { facts } = shown?.answer ?? {};
  const words = [facts?.spring.name ?? 'spring', facts?.conditions[facts.condition]?.name ?? ''];
  return words.join('-').replaceAll(/[^\w.-]+/g, '-');
}

/** A file for the user's disk. */
export function download(name: string, content: BlobPart, type: string): void {
  const address = URL.createObjectURL(new Blob([content], { type }));
  make('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
