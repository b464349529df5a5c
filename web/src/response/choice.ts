// Which frequency is looked at: a slider in equal factors, a field for a number, and buttons for those that stand out.
//
// Next door: what is shown of it (`part`).

import type { CurveFacts } from '../answer';
import { clamp, digits, make } from '../dom';
import { read } from '../inputs/quantity';

/** Steps of the slider, each the same factor; and so many digits a frequency has that it sets. */
const STEPS = 1000;
const DIGITS = 4;
/** How many peaks and modes have a button. */
const MOST_BUTTONS = 2;

/** Hertz as people read them. */
export const hertz = (value: number): string => `${digits(value, DIGITS)}\u00a0Hz`;

export class Choice {
  frequency = 0;
  private range: [number, number] = [1, 10];
  private readonly slider = make('input', {
    type: 'range',
    min: 0,
    max: STEPS,
    step: 1,
    'aria-label': 'Frequency, slider',
  });
  private readonly field = make('input', {
    type: 'text',
    inputmode: 'decimal',
    size: 9,
    'aria-label': 'Frequency',
    'aria-describedby': 'frequency-refusal',
  });
  private readonly refusal = make('span', { class: 'refused', id: 'frequency-refusal', role: 'status' });
  private readonly places = make('div', { class: 'places' });
  readonly element = make(
    'div',
    { class: 'frequency' },
    make('div', { class: 'stops' }, make('label', {}, 'Frequency ', this.slider), this.field, this.refusal),
    this.places,
  );

  /** `moved` hears each frequency, and whether the hand has let go. */
  constructor(private readonly moved: (isDone: boolean) => void) {
    this.slider.addEventListener('input', () => this.tell(this.atStep(), false));
    this.slider.addEventListener('change', () => this.tell(this.frequency, true));
    this.field.addEventListener('change', () => this.typed());
  }

  /** Takes over a curve; `wanted` is what was chosen [Hz], zero where nothing was. */
  show(facts: CurveFacts, wanted: number): void {
    this.range = facts.range;
    this.places.replaceChildren('Go to ', ...this.buttons(facts));
    this.put(wanted || usual(facts));
  }

  /** A frequency that was chosen elsewhere [Hz]. */
  pick(frequency: number, isDone = true): void {
    this.tell(Number(frequency.toPrecision(DIGITS)), isDone);
  }

  /** What a reader hears of the slider. */
  say(words: string): void {
    this.slider.setAttribute('aria-valuetext', words);
  }

  private tell(frequency: number, isDone: boolean): void {
    this.put(frequency);
    this.moved(isDone);
  }

  private put(frequency: number): void {
    const [from, to] = this.range;
    this.frequency = clamp(frequency, from, to);
    this.slider.value = String(Math.round((STEPS * Math.log(this.frequency / from)) / Math.log(to / from)));
    this.field.value = hertz(this.frequency);
    this.refuse('');
  }

  private atStep(): number {
    const [from, to] = this.range;
    return Number((from * (to / from) ** (Number(this.slider.value) / STEPS)).toPrecision(DIGITS));
  }

  private typed(): void {
    const found = read(this.field.value.replaceAll('\u00a0', ' ').replace(',', '.'));
    const scale = { '': 1, hz: 1, khz: 1e3 }[found?.unit.toLowerCase() ?? '?'];
    const frequency = found && scale ? found.number * scale : NaN;
    const [from, to] = this.range;
    if (frequency >= from && frequency <= to) return this.tell(frequency, true);
    this.refuse(`A frequency from ${hertz(from)} to ${hertz(to)}.`);
  }

  private refuse(text: string): void {
    this.refusal.textContent = text;
    this.field.setAttribute('aria-invalid', String(text !== ''));
  }

  private buttons({ until, peaks, modes, lines, range: [, to], within }: CurveFacts): HTMLElement[] {
    const some = (values: number[], label: string) =>
      values
        .filter((value) => value <= to)
        .slice(0, MOST_BUTTONS)
        .map((value) => ({ value, label }));
    const all = [
      ...(until.through ? [{ value: until.through, label: `${digits(100 * within)} % limit` }] : []),
      ...some(
        peaks.map(([value]) => value),
        'peak',
      ),
      ...some(modes, 'mode'),
      ...some(lines, 'driven at'),
    ];
    return all.map(({ value, label }) =>
      make(
        'button',
        { type: 'button', class: 'plain', onclick: () => this.pick(value) },
        `${label} ${digits(value, DIGITS)}\u00a0Hz`,
      ),
    );
  }
}

/** Where nobody chose: where the condition drives, else where the ends differ but neither peaks. */
function usual({ lines, peaks, range: [from, to] }: CurveFacts): number {
  const driven = lines.find((line) => line >= from && line <= to);
  const between = peaks[0] ? 0.5 * peaks[0][0] : Math.sqrt(from * to);
  return Number((driven ?? between).toPrecision(DIGITS));
}
