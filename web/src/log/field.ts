// One option of a log as a field: what is typed or chosen, and red with the reason where it is refused.
//
// Next door: which there are (`options`), all of them together (`form`).

import { make } from '../dom';
import { unitOf } from '../inputs/quantity';
import { Reading } from '../inputs/reading';
import type { Typed } from '../inputs/typing';
import { parts, understand } from '../inputs/understand';
import type { Option } from './options';

export class OptionField {
  readonly element: HTMLElement;
  private readonly input: HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement;
  private readonly error = make('p', { class: 'error', role: 'alert', hidden: true });
  private readonly reading = new Reading();
  /** Something is typed and not left yet: whatever is said of the log meanwhile does not take it away. */
  private isTyping = false;

  constructor(readonly option: Option) {
    const { name, label, hint, tick, long } = option;
    const id = `log-${name}`;
    this.error.id = `${id}-error`;
    this.input = enter(id, option);
    const about = hint ? make('span', { class: 'hint', id: `${id}-hint` }, hint) : null;
    this.input.setAttribute(
      'aria-describedby',
      [this.reading.id(id), about?.id, this.error.id].filter(Boolean).join(' '),
    );
    const words = make('label', { for: id, class: tick ? 'tick' : '' });
    this.element = make('div', { class: long ? 'field long' : tick ? '' : 'field' });
    if (tick) words.append(this.input, ` ${label}`);
    else words.append(label);
    this.element.append(
      words,
      ...(tick ? [] : [this.input]),
      this.reading.element,
      ...(about ? [about] : []),
      this.error,
    );
    if (this.input instanceof HTMLInputElement && !tick) {
      this.input.addEventListener('input', () => {
        this.isTyping = true;
        this.reading.typing(this.word, this.understood);
      });
      this.input.addEventListener('blur', () => (this.isTyping = false));
      // Before anybody else hears of the change.
      this.input.addEventListener('change', () => {
        this.isTyping = false;
        this.reading.left(this.understood);
        this.word = String(this.understood.value);
      });
    }
  }

  /** What is typed, in the engine's words; a bare number has the unit of the example. */
  private get understood(): Typed & { value: string } {
    const units = parts(this.option.example ?? '').map(unitOf);
    const all = parts(this.word).map((part, index) => understand(part, units[index]));
    const of = (key: 'doubt' | 'note') => {
      const found = all.find((one) => one[key])?.[key];
      return found ? { [key]: found } : {};
    };
    return { value: all.map(({ text }) => text).join(', '), ...of('doubt'), ...of('note') };
  }

  /** What is said; nothing where it is left as it is. */
  get word(): string {
    const { input } = this;
    if (input instanceof HTMLInputElement && input.type === 'checkbox') return input.checked ? 'yes' : '';
    return input.value.trim();
  }

  set word(text: string) {
    const { input } = this;
    if (this.isTyping) return;
    if (input instanceof HTMLInputElement && input.type === 'checkbox') input.checked = text !== '';
    else if (input.value.trim() !== text) input.value = text;
    // An address may hold a word that is no choice.
    if (input instanceof HTMLSelectElement && input.selectedIndex < 0) input.selectedIndex = 0;
  }

  /** Marks it as wrong, or as right again. */
  refuse(reason: string | null): void {
    const { doubt } = this.input instanceof HTMLInputElement ? this.understood : {};
    this.error.textContent = reason === null ? '' : (doubt ?? reason);
    this.error.hidden = reason === null;
    this.element.classList.toggle('wrong', reason !== null);
    if (reason === null) return this.input.removeAttribute('aria-invalid');
    this.input.setAttribute('aria-invalid', 'true');
    const folded = this.element.closest('details');
    if (folded) folded.open = true;
  }
}

function enter(id: string, { words, tick, long, example = '' }: Option) {
  if (words) return make('select', { id }, ...words.map(([value, label]) => make('option', { value }, label)));
  if (tick) return make('input', { type: 'checkbox', id });
  if (long) return make('textarea', { id, rows: 6, spellcheck: 'false', placeholder: example });
  return make('input', { type: 'text', id, placeholder: example, autocomplete: 'off', spellcheck: 'false' });
}
