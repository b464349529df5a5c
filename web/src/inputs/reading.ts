// What a typed text is understood as, in a line below its field: while it differs from the text, and after that where it might be mistaken.
//
// Next door: how it is understood (`understand`), the fields (`control`, `damping`, `contact`).

import { make } from '../dom';
import { shown } from './quantity';
import type { Typed } from './typing';

export class Reading {
  readonly element = make('span', { class: 'understood', hidden: true });

  /** Gives its line a name, by which the field can be described. */
  id(field: string): string {
    return (this.element.id = `${field}-understood`);
  }

  /** While somebody types. */
  typing(text: string, typed: Typed): void {
    const taken = shown(typed.value);
    const differs = !typed.doubt && taken !== '' && taken !== text.trim();
    this.say([differs ? `= ${taken}` : '', typed.note ?? '']);
  }

  /** The field was left and shows what was taken. */
  left(typed: Typed | null): void {
    this.say([typed?.note ?? '']);
  }

  private say(words: string[]): void {
    this.element.textContent = words.filter(Boolean).join(', ');
    this.element.hidden = this.element.textContent === '';
  }
}
