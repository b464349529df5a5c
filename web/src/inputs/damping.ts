// Damping: one of those that the spec gives results for, or an own ratio by slider.
//
// Next door: all other fields (`control`).

import type { Facts } from '../answer';
import { section, withValue, type Value } from '../document';
import { clamp, make } from '../dom';
import type { State } from '../state';
import type { Store } from '../store';
import { Reading } from './reading';
import { heard, ratio, type Typed } from './typing';

/** The highest ζ of the slider; its square root is even, so that small ones can be told apart. */
const MOST = 0.1;
const STEPS = 1000;

export class DampingControl {
  readonly element: HTMLElement;
  private readonly chips = make('div', { class: 'chips' });
  private readonly input = make('input', {
    id: 'damping',
    type: 'text',
    autocomplete: 'off',
    spellcheck: 'false',
    'aria-describedby': 'damping-understood damping-hint damping-error',
  });
  private readonly slider = make('input', { type: 'range', min: 0, max: STEPS, 'aria-label': 'Damping ζ, slider' });
  private readonly error = make('p', { class: 'error', role: 'alert', id: 'damping-error', hidden: true });
  private readonly reading = new Reading();
  private own: Typed | null = null;
  private drawn = '';

  constructor(
    private readonly store: Store,
    private readonly onInput: (event: Event) => void,
  ) {
    this.slider.addEventListener('input', (event) => {
      const ratio = MOST * (Number(this.slider.value) / STEPS) ** 2;
      this.put(Number(ratio.toPrecision(2)), event);
    });
    this.reading.id('damping');
    this.input.addEventListener('input', (event) => {
      heard(() => {
        this.own = ratio(this.input.value);
        this.reading.typing(this.input.value, this.own);
        if (this.own.value !== undefined && this.own.value !== '') this.put(this.own.value, event);
      });
    });
    this.input.addEventListener('blur', () => {
      this.reading.left(this.own);
      this.own = null;
      this.show(this.store.state, this.facts);
    });
    this.element = make(
      'div',
      { class: 'field slides' },
      make('label', { for: 'damping' }, 'Damping ζ'),
      this.input,
      this.reading.element,
      this.slider,
      make('span', { class: 'hint', id: 'damping-hint' }, 'how soon it stops ringing; rarely known'),
      this.chips,
      this.error,
    );
  }

  private facts: Facts | null = null;

  show(state: State, facts: Facts | null): void {
    this.facts = facts;
    const given = section(state.spec, 'mount')['damping_ratio'];
    const ratio = typeof given === 'number' ? given : (facts?.dampings[state.view.damping]?.ratio ?? null);
    const text = typeof given === 'string' ? given : ratio === null ? '' : String(ratio);
    if (document.activeElement !== this.input) this.input.value = text;
    if (document.activeElement !== this.slider)
      this.slider.value = String(STEPS * Math.sqrt(clamp((ratio ?? 0) / MOST, 0, 1)));
    this.slider.style.setProperty('--part', `${(100 * Number(this.slider.value)) / STEPS}%`);
    this.slider.setAttribute('aria-valuetext', text);
    this.drawChips(state, facts);
  }

  refuse(reason: string | null): void {
    const given = String(section(this.store.state.spec, 'mount')['damping_ratio'] ?? '');
    this.error.textContent = reason === null ? '' : (ratio(given).doubt ?? reason);
    this.error.hidden = reason === null;
    this.element.classList.toggle('wrong', reason !== null);
    if (reason === null) this.input.removeAttribute('aria-invalid');
    else this.input.setAttribute('aria-invalid', 'true');
  }

  private put(value: Value, event: Event): void {
    this.onInput(event);
    this.store.setSpec(withValue(this.store.state.spec, 'mount.damping_ratio', value), 'damping', { damping: 0 });
  }

  /** A button for each damping, where there are several. */
  private drawChips(state: State, facts: Facts | null): void {
    // Room for those that will come, before the engine has told them.
    const { damping_ratio: given } = section(state.spec, 'mount');
    this.chips.classList.toggle('awaited', !facts && (given === undefined || Array.isArray(given)));
    const labels = facts && facts.dampings.length > 1 ? facts.dampings.map((damping) => damping.label) : [];
    const now = JSON.stringify([labels, state.view.damping]);
    if (now === this.drawn) return;
    this.drawn = now;
    const chip = (label: string, index: number) =>
      make(
        'button',
        {
          type: 'button',
          class: 'chip',
          'aria-pressed': String(index === state.view.damping),
          onclick: () => this.store.setView({ damping: index }, true),
        },
        label.replace('ζ = ', ''),
      );
    this.chips.replaceChildren(...labels.map(chip));
  }
}
