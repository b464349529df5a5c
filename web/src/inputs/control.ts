// One field of the spec on the page: a label, a slider where it has one, and the value to type; red with the reason where it is refused.
//
// Next door: which fields there are (`fields`), which of them are shown (`panels`), what is typed (`quantity`).

import { valueAt, withValue, type Value } from '../document';
import { make, rich } from '../dom';
import type { Field } from '../fields';
import { preset } from '../presets';
import type { State } from '../state';
import type { Store } from '../store';
import { fromSlider, read, shown, STEPS, toSlider, unitOf, type Quantity } from './quantity';
import { Reading } from './reading';
import { heard, typed, type Typed } from './typing';

export class Control {
  readonly element: HTMLElement;
  private readonly input: HTMLInputElement | HTMLSelectElement;
  private readonly slider: HTMLInputElement | null;
  private readonly hint: HTMLElement;
  private readonly error = make('p', { class: 'error', role: 'alert', hidden: true });
  private readonly reading = new Reading();
  /** The unit that the field shows, which a bare number takes. */
  private unit = '';
  /** What is being typed, as the state has it; null once the field is left. */
  private own: Typed | null = null;

  constructor(
    private readonly store: Store,
    readonly place: string,
    private readonly field: Field,
    private readonly onInput: (event: Event) => void,
  ) {
    const id = place.replaceAll('.', '-');
    this.error.id = `${id}-error`;
    this.input = field.list ? this.choice(id, []) : field.words ? this.choice(id, field.words) : this.text(id);
    this.slider = field.slide ? this.range() : null;
    this.hint = make('span', { class: 'hint', id: `${id}-hint`, hidden: !field.hint }, rich(field.hint ?? ''));
    this.input.setAttribute('aria-describedby', `${this.reading.id(id)} ${this.hint.id} ${this.error.id}`);
    this.element = make(
      'div',
      { class: `field${this.slider ? ' slides' : ''}${field.wide ? ' wide' : ''}` },
      make('label', { for: id }, field.label),
      this.input,
      this.reading.element,
      this.slider,
      this.hint,
      this.error,
    );
  }

  /** Shows what the state holds; what is being typed stays as it is. */
  show(state: State): void {
    const given = valueAt(state.spec, this.place);
    const text = shown(given);
    if (this.field.list) this.offer([...this.offered, text]);
    const wanted = this.field.words && text === '' ? this.unsaid || (this.field.words[0] ?? '') : text;
    const isOwn = this.own !== null && document.activeElement === this.input && shown(this.own.value) === text;
    if (!isOwn) {
      if (this.input.value !== wanted) this.input.value = wanted;
      // A word such as mid shows no unit; an empty field that of what holds there, else the last one.
      const last = text === '' || read(text) ? this.unit : '';
      this.unit = unitOf(given) || unitOf(this.input.getAttribute('placeholder') ?? '') || last;
    }
    if (!this.slider) return;
    const value = read(text || (this.field.usual ?? ''));
    this.slider.disabled = value === null;
    if (!value) return;
    const at = String(toSlider(this.field, value, this.usual(value)));
    if (document.activeElement !== this.slider || !this.isSliding) this.slider.value = at;
    this.slider.setAttribute('aria-valuetext', text || (this.field.usual ?? ''));
    this.slider.style.setProperty('--part', `${(100 * Number(this.slider.value)) / STEPS}%`);
    this.isSliding = false;
  }

  /** Gives a list its names; the first is what the field is called while nothing is chosen. */
  offer(names: readonly string[], none = this.none): void {
    this.none = none;
    this.offered = [...new Set(names)].filter(Boolean);
    const now = JSON.stringify([none, this.offered]);
    if (now === this.drawn) return;
    this.drawn = now;
    const { value } = this.input;
    const options = this.offered.map((name) => make('option', { value: name }, name));
    this.input.replaceChildren(make('option', { value: '' }, none), ...options);
    this.input.value = value;
  }

  /** Another hint than the field's own, and what holds while nothing is typed. */
  tell(hint: string, usual = ''): void {
    this.hint.replaceChildren(rich(hint));
    this.hint.hidden = hint === '';
    if (this.input instanceof HTMLInputElement) this.input.placeholder = usual;
  }

  /** What a choice shows while the spec says nothing. */
  usually(word: string): void {
    if (this.field.words?.includes(word)) this.unsaid = word;
  }

  /** The field's own hint. */
  get ownHint(): string {
    return this.field.hint ?? '';
  }

  private none = '–';
  private offered: string[] = [];
  private drawn = '';
  private unsaid = '';

  /** Marks the field as wrong, or as right again; a text that may be two numbers is told as that. */
  refuse(reason: string | null): void {
    const text = shown(valueAt(this.store.state.spec, this.place));
    const words = reason === null ? null : (typed(this.field, text, this.unit).doubt ?? reason);
    this.error.textContent = words ?? '';
    this.error.hidden = reason === null;
    this.element.classList.toggle('wrong', reason !== null);
    if (reason === null) this.input.removeAttribute('aria-invalid');
    else this.input.setAttribute('aria-invalid', 'true');
  }

  private isSliding = false;

  private text(id: string): HTMLInputElement {
    const input = make('input', { id, type: 'text', autocomplete: 'off', spellcheck: 'false' });
    input.placeholder = this.field.usual ?? '';
    input.addEventListener('input', (event) => {
      heard(() => {
        this.own = typed(this.field, input.value, this.unit);
        this.reading.typing(input.value, this.own);
        this.put(this.own.value, event);
      });
    });
    input.addEventListener('blur', () => {
      this.reading.left(this.own);
      this.own = null;
      this.show(this.store.state);
    });
    return input;
  }

  private choice(id: string, words: readonly string[]): HTMLSelectElement {
    const select = make(
      'select',
      { id },
      ...words.map((word) => make('option', { value: word }, this.field.names?.[word] ?? word)),
    );
    select.addEventListener('change', (event) => this.put(select.value || undefined, event));
    return select;
  }

  private range(): HTMLInputElement {
    const slider = make('input', {
      type: 'range',
      min: 0,
      max: STEPS,
      step: 1,
      'aria-label': `${this.field.label}, slider`,
    });
    slider.addEventListener('input', (event) => {
      const { state } = this.store;
      const value = read(shown(valueAt(state.spec, this.place)) || (this.field.usual ?? ''));
      if (!value) return;
      const moved = fromSlider(this.field, Number(slider.value), value, this.usual(value));
      this.isSliding = true;
      this.reading.left(null);
      this.put(moved.unit ? `${moved.number} ${moved.unit}` : moved.number, event);
    });
    return slider;
  }

  private put(value: Value | undefined, event: Event): void {
    this.onInput(event);
    const { spec } = this.store.state;
    const next = withValue(spec, this.place, value);
    this.store.setSpec(this.field.then?.(next) ?? next, `${event.type} ${this.place}`);
  }

  private anchor: Quantity | null = null;

  /** The value that the slider's ends are shares of: the preset's, else the first one met in its unit. */
  private usual(value: Quantity): Quantity {
    const text = shown(valueAt(preset(this.store.state.preset).spec, this.place));
    const given = read(text || (this.field.usual ?? ''));
    if (given && given.unit === value.unit && given.number !== 0) return given;
    if (!this.anchor || this.anchor.unit !== value.unit)
      this.anchor = value.number === 0 ? { ...value, number: 1 } : value;
    return this.anchor;
  }
}
