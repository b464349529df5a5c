// What is typed, as values of the spec: by `values`, which comes when the page is at rest, or with the first letter. Until it has come a text is
// taken as it stands, as the engine would; after that it is gone through again.
//
// Next door: the fields that are typed into (`control`, `damping`, `contact`), what is shown of it (`reading`).

import type { Value } from '../document';
import { part } from '../faults';
import type { Field } from '../fields';

export interface Typed {
  /** Nothing for an empty text, which leaves the key out. */
  value: Value | undefined;
  /** Why it is not taken: it may be two numbers. */
  doubt?: string;
  /** What else somebody may have meant, and what was taken. */
  note?: string;
}

let values: typeof import('./values') | null = null;
let coming: Promise<void> | null = null;

export function load(): Promise<void> {
  coming ??= part('What reads numbers as people type them', () => import('./values')).then(
    (come) => void (values = come),
  );
  return coming;
}

/** Does what is to be done about a letter, and once more where letters are understood only later. */
export function heard(act: () => void): void {
  act();
  if (!values) void load().then(act);
}

const plain = (text: string): Typed => ({ value: text.trim() === '' ? undefined : text.trim() });

/** `unit` is the one that the field shows. */
export const typed = (field: Field, text: string, unit: string): Typed =>
  values ? values.typed(field, text, unit) : plain(text);

/** A number without a unit. */
export const ratio = (text: string): Typed => (values ? values.ratio(text) : plain(text));

/** One or several of them. */
export const ratios = (text: string): Typed => (values ? values.ratios(text) : plain(text));
