// The fields: what it is judged on, and the options of `coilsense mitigate`; red with the reason where the engine refuses one.
//
// Next door: where their values are (`choices`), what comes of it (`found`).

import { make, rich } from '../dom';
import { unitOf } from '../inputs/quantity';
import { Reading } from '../inputs/reading';
import { understand } from '../inputs/understand';
import type { Choices, Name } from './choices';

interface Option {
  name: Name;
  label: string;
  hint: string;
  /** On what it counts; the stated scenario has all its own. */
  on: readonly string[];
}

const BOTH = ['', 'log'];
const OPTIONS: readonly Option[] = [
  { name: 'most-lag', label: 'Most lag', hint: 'At the bandwidth: what is advised is no later.', on: BOTH },
  { name: 'rate', label: 'Sampling rate', hint: 'How often the controller samples.', on: [''] },
  { name: 'noise', label: 'Noise of F_i', hint: 'White, rms per sample; else that of a load cell at end 1.', on: BOTH },
  {
    name: 'bandwidth',
    label: 'Bandwidth',
    hint: 'Up to which the force moves by itself; else the goal’s, or f1/20.',
    on: BOTH,
  },
  { name: 'stiffness-tolerance', label: 'Stiffness off by', hint: 'Either way.', on: BOTH },
  { name: 'mass-tolerance', label: 'Mass off by', hint: 'Either way.', on: BOTH },
  { name: 'seeds', label: 'Series of noise', hint: '1 to 1000; one is quicker and enough for a look.', on: [''] },
];
const ON = [
  ['', 'this spring’s conditions'],
  ['log', 'a log of yours'],
  ['stated', 'the stated scenario'],
] as const;
/** How a refusal begins that is about an option. */
const PLACED = /^([a-z-]+): (.*)$/s;

export class Form {
  readonly element: HTMLElement;
  private readonly fields = new Map<
    string,
    { box: HTMLElement; input: HTMLInputElement; error: HTMLElement; on: readonly string[] }
  >();
  private readonly on = make(
    'select',
    { id: 'mitigate-on' },
    ...ON.map(([value, label]) => make('option', { value }, label)),
  );
  private readonly stated = make(
    'p',
    { class: 'hint', hidden: true },
    'An impact at 0.25 m/s while end 1 moves by 5 mm at 1.5 Hz, 2.5 kHz, 0.24 N of noise, 50 series, k and m off by up to 10 %: what designs are compared on. Takes some ten times as long.',
  );

  /** `between` stands below the first choice. */
  constructor(
    private readonly choices: Choices,
    between: HTMLElement,
    /** Hears of what is typed. */
    private readonly typed: (event: Event) => void,
  ) {
    this.on.addEventListener('change', () => choices.set('on', this.on.value));
    const [first, ...others] = OPTIONS.map((option) => this.field(option));
    this.element = make(
      'div',
      { class: 'fields' },
      make('div', { class: 'field wide' }, make('label', { for: this.on.id }, 'Judge on'), this.on),
      this.stated,
      between,
      first,
      make('details', { class: 'options' }, make('summary', {}, 'Sampling, noise, tolerances'), ...others),
    );
    this.show();
  }

  /** Puts the choices into the fields; what is being typed stays as it is. */
  show(): void {
    const on = this.choices.get('on');
    this.on.value = on;
    this.stated.hidden = on !== 'stated';
    for (const [name, { box, input, on: where }] of this.fields) {
      const value = this.choices.get(name as Name);
      // What is typed stands in its own words until the field is left.
      if (document.activeElement !== input || understand(input.value, this.unit(input)).text !== value)
        input.value = value;
      box.hidden = !where.includes(on);
    }
    this.element.querySelector('.options')?.toggleAttribute('hidden', on === 'stated');
  }

  /** The unit that a field shows, which a bare number takes: that of what holds there. */
  private unit(input: HTMLInputElement): string {
    return unitOf(input.placeholder);
  }

  /** What counts of the options, as the engine takes it. */
  asked(more: Record<string, unknown> = {}): string {
    const on = this.choices.get('on');
    const each = [...this.fields].filter(([, { on: where }]) => where.includes(on));
    return JSON.stringify({
      ...(on ? { on } : {}),
      ...Object.fromEntries(each.map(([name]) => [name, this.choices.get(name as Name)])),
      ...more,
    });
  }

  /** What the options are where nothing is said. */
  usual(usual: Record<string, string>): void {
    for (const [name, { input }] of this.fields) input.placeholder = usual[name] ?? '';
  }

  /** Marks the fields that refusals are about; gives back those that are about none. */
  refuse(reasons: readonly string[]): string[] {
    const rest: string[] = [];
    const wrong = new Map<string, string>();
    for (const reason of reasons) {
      const [, name = '', text = ''] = PLACED.exec(reason) ?? [];
      if (this.fields.has(name)) wrong.set(name, text);
      else rest.push(reason);
    }
    for (const [name, { box, input, error }] of this.fields) {
      const reason = wrong.get(name);
      error.hidden = reason === undefined;
      error.textContent = reason === undefined ? '' : (understand(input.value).doubt ?? reason);
      box.classList.toggle('wrong', reason !== undefined);
      if (reason === undefined) input.removeAttribute('aria-invalid');
      else {
        input.setAttribute('aria-invalid', 'true');
        box.closest('details')?.setAttribute('open', '');
      }
    }
    return rest;
  }

  private field({ name, label, hint, on }: Option): HTMLElement {
    const id = `mitigate-${name}`;
    const error = make('p', { class: 'error', role: 'alert', id: `${id}-error`, hidden: true });
    const input = make('input', {
      type: 'text',
      id,
      autocomplete: 'off',
      spellcheck: 'false',
      'aria-describedby': `${id}-understood ${id}-hint ${id}-error`,
    });
    const reading = new Reading();
    reading.id(id);
    input.addEventListener('input', (event) => {
      this.typed(event);
      const { text: value, ...told } = understand(input.value, this.unit(input));
      reading.typing(input.value, { value, ...told });
      this.choices.set(name, value);
    });
    input.addEventListener('blur', () => {
      reading.left({ value: undefined, ...understand(input.value, this.unit(input)) });
      this.show();
    });
    const box = make(
      'div',
      { class: 'field' },
      make('label', { for: id }, rich(label)),
      input,
      reading.element,
      make('span', { class: 'hint', id: `${id}-hint` }, rich(hint)),
      error,
    );
    this.fields.set(name, { box, input, error, on });
    return box;
  }
}
