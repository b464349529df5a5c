// A number and its unit, as the spec holds them: a slider moves the number and leaves the unit.
//
// Next door: what people type (`typing`).

import { clamp } from '../dom';
import type { Field } from '../fields';
import type { Value } from '../document';

export interface Quantity {
  number: number;
  unit: string;
}

/** `760 N/m`, `0.5 f1`, `1 %`, `0.25`; nothing where it begins with no number. */
export function read(text: string): Quantity | null {
  const found = /^\s*([-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*$/.exec(text);
  return found ? { number: Number((found[1] ?? '').replace('−', '-')), unit: found[2] ?? '' } : null;
}

export const STEPS = 1000;

/** Where a value stands on its slider, 0 to `STEPS`; `usual` is what the slider's ends are shares of. */
export function toSlider(field: Field, value: Quantity, usual: Quantity): number {
  const ends = range(field, value, usual);
  if (!ends) return 0;
  const part =
    ends.scale === 'log'
      ? Math.log(value.number / ends.from) / Math.log(ends.to / ends.from)
      : (value.number - ends.from) / (ends.to - ends.from);
  return Math.round(STEPS * clamp(Number.isFinite(part) ? part : 0, 0, 1));
}

/** The value at a place of the slider, with three digits. */
export function fromSlider(field: Field, place: number, value: Quantity, usual: Quantity): Quantity {
  const ends = range(field, value, usual);
  if (!ends) return value;
  const part = place / STEPS;
  const number =
    ends.scale === 'log' ? ends.from * (ends.to / ends.from) ** part : ends.from + part * (ends.to - ends.from);
  return { number: ends.whole ? Math.max(1, Math.round(number)) : Number(number.toPrecision(3)), unit: value.unit };
}

function range(field: Field, { number, unit }: Quantity, usual: Quantity) {
  if (!field.slide) return null;
  const anchor = usual.unit === unit && usual.number !== 0 ? usual.number : number || 1;
  const [from, to] = [field.slide.from * anchor, field.slide.to * anchor];
  return {
    from: Math.min(from, to),
    to: Math.max(from, to),
    scale: field.slide.scale,
    whole: field.slide.whole === true,
  };
}

/** A value of the spec as text to edit. */
export function shown(value: Value | undefined): string {
  if (value === undefined) return '';
  return Array.isArray(value) ? value.map(shown).join(', ') : String(value);
}

/** The unit that a value is shown in, of several values that of the first; none where no number and unit stand there. */
export function unitOf(value: Value | undefined): string {
  const unit = read(shown(Array.isArray(value) ? value[0] : value))?.unit ?? '';
  return /^[\d.,]/.test(unit) ? '' : unit;
}
