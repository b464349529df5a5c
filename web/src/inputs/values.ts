// Typed texts as values of the spec. It is loaded when the page is at rest, or with the first letter.
//
// Next door: who asks, and what holds until then (`typing`), how people write numbers and units (`understand`).

import type { Field } from '../fields';
import type { Typed } from './typing';
import { parts, understand } from './understand';

/** `unit` is the one that the field shows. */
export function typed(field: Field, text: string, unit: string): Typed {
  const trimmed = text.trim();
  if (trimmed === '') return { value: undefined };
  if (field.words || field.list || field.free) return { value: trimmed };
  if (!field.pair) {
    const { text: one, ...told } = understand(trimmed, unit);
    return { value: field.number && Number.isFinite(Number(one)) ? Number(one) : one, ...told };
  }
  const all = parts(trimmed).map((part) => understand(part, unit));
  const [doubt, note] = [all.find(({ doubt }) => doubt)?.doubt, all.find(({ note }) => note)?.note];
  return { value: all.map(({ text: one }) => one), ...(doubt ? { doubt } : {}), ...(note ? { note } : {}) };
}

/** A number without a unit, perhaps one in per cent; what is none stays a text, for the engine to refuse. */
export function ratio(text: string): Typed & { value: number | string } {
  const { text: one, ...told } = understand(text);
  const share = /^(.*\d) ?%$/.exec(one);
  const number = share ? Number((Number(share[1]) / 100).toPrecision(15)) : Number(one);
  return { value: one !== '' && Number.isFinite(number) ? number : one, ...told };
}

/** One such number or several; what is none stays as it is. */
export function ratios(text: string): Typed {
  // A comma between digits is a decimal one, unless a point beside it already is.
  const all = parts(text.includes('.') ? text.replaceAll(',', '; ') : text).map((part) => ratio(part).value);
  return { value: all.length > 1 ? all : all[0] };
}
