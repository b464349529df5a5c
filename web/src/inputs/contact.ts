// Windings that meet: whether they do and how, as the table [contact] of the spec; without the table they pass through one another.
//
// Next door: all other fields (`control`), what comes of it (`results/meetings`).

import { section, withValue, type Spec, type Value } from '../document';
import { make } from '../dom';
import type { State } from '../state';
import type { Store } from '../store';
import { shown } from './quantity';
import { Reading } from './reading';
import { heard, ratios } from './typing';

const THROUGH = 'through';
/** Of each law the key that says what is lost, and where the command gives results if the spec is silent. */
const LAWS: Record<string, { key: string; label: string; hint: string; usual: readonly number[] }> = {
  hard: {
    key: 'restitution',
    label: 'Restitution e',
    hint: 'share of the closing speed that is left, 0 to 1; not measured by anybody: left out, 0 and 0.5 are computed',
    usual: [0, 0.5],
  },
  elastic: {
    key: 'damping_ratio',
    label: 'Contact damping ζ_c',
    hint: 'left out, 3 and 0.3 are computed, as lossy as e = 0.02 and 0.45; the stiffness is Hertz’s',
    usual: [3, 0.3],
  },
};

const law = (spec: Spec) =>
  spec['contact'] ? (LAWS[String(section(spec, 'contact')['windings'] ?? 'hard')] ?? null) : null;

/** In how many ways windings meet in a spec: each damping is computed in each of them. */
function ways(spec: Spec): number {
  const found = law(spec);
  const given = found && section(spec, 'contact')[found.key];
  if (!found) return 1;
  return given === undefined ? found.usual.length : Array.isArray(given) ? Math.max(1, given.length) : 1;
}

/** The same spec with windings that pass through one another, or meet by a law. */
export function withLaw(spec: Spec, windings: string): Spec {
  const { contact: _, ...rest } = spec;
  if (!(windings in LAWS)) return rest;
  const ends = section(spec, 'contact')['ends'];
  return { ...rest, contact: { windings, ...(ends === undefined ? {} : { ends }) } };
}

/** Puts a spec whose windings meet otherwise, and shows the same damping as before. */
export function putContact(store: Store, spec: Spec, gesture = ''): void {
  const [before, after] = [ways(store.state.spec), ways(spec)];
  const { damping } = store.state.view;
  const way = Math.min(damping % before, after - 1);
  store.setSpec(spec, gesture, { damping: Math.floor(damping / before) * after + way });
}

export class ContactControl {
  readonly element: HTMLElement;
  private readonly windings = make(
    'select',
    { id: 'contact-windings', 'aria-describedby': 'contact-windings-hint contact-error' },
    make('option', { value: THROUGH }, 'pass through one another'),
    make('option', { value: 'hard' }, 'are hard'),
    make('option', { value: 'elastic' }, 'are elastic'),
  );
  private readonly hint = make('span', { class: 'hint', id: 'contact-windings-hint' });
  private readonly loss = make('input', {
    id: 'contact-loss',
    type: 'text',
    autocomplete: 'off',
    spellcheck: 'false',
    'aria-describedby': 'contact-loss-understood contact-loss-hint contact-error',
  });
  private readonly lossLabel = make('label', { for: 'contact-loss' });
  private readonly reading = new Reading();
  private readonly lossHint = make('span', { class: 'hint', id: 'contact-loss-hint' });
  private readonly ends = make(
    'select',
    { id: 'contact-ends' },
    make('option', { value: '' }, 'as the ends are made'),
    make('option', { value: 'true' }, 'yes'),
    make('option', { value: 'false' }, 'no'),
  );
  private readonly error = make('p', { class: 'error', role: 'alert', id: 'contact-error', hidden: true });
  private readonly more: HTMLElement[];

  constructor(
    private readonly store: Store,
    onInput: (event: Event) => void,
  ) {
    this.windings.addEventListener('change', (event) => {
      onInput(event);
      putContact(store, withLaw(store.state.spec, this.windings.value));
    });
    this.reading.id(this.loss.id);
    this.loss.addEventListener('input', (event) => {
      onInput(event);
      heard(() => {
        const typed = ratios(this.loss.value);
        this.reading.typing(this.loss.value, typed);
        this.put(law(store.state.spec)?.key ?? '', typed.value);
      });
    });
    this.loss.addEventListener('blur', () => {
      this.reading.left(null);
      this.show(store.state);
    });
    this.ends.addEventListener('change', (event) => {
      onInput(event);
      this.put('ends', this.ends.value === '' ? undefined : this.ends.value === 'true');
    });
    this.more = [
      make('div', { class: 'field wide' }, this.lossLabel, this.loss, this.reading.element, this.lossHint),
      make('div', { class: 'field wide' }, make('label', { for: 'contact-ends' }, 'Ends meet their seats'), this.ends),
    ];
    this.element = make(
      'div',
      { class: 'contact' },
      make(
        'div',
        { class: 'field wide' },
        make('label', { for: 'contact-windings' }, 'Windings that meet'),
        this.windings,
        this.hint,
      ),
      ...this.more,
      this.error,
    );
  }

  /** Shows what the state holds; what is being typed stays as it is. */
  show({ spec }: State): void {
    const found = law(spec);
    const table = section(spec, 'contact');
    this.windings.value = found ? String(table['windings'] ?? 'hard') : THROUGH;
    this.hint.textContent = found ? '' : 'as if each were alone: quick, and right until two touch';
    this.hint.hidden = found !== null;
    for (const field of this.more) field.hidden = found === null;
    if (!found) return;
    this.lossLabel.textContent = found.label;
    this.lossHint.textContent = found.hint;
    this.loss.placeholder = found.usual.join(', ');
    if (document.activeElement !== this.loss) this.loss.value = shown(table[found.key]);
    this.ends.value = shown(table['ends']);
  }

  /** Says what is refused of the table; false where the refusal is about another place. */
  refuse(place: string, reason: string | null): boolean {
    const [table, key] = place.split('.');
    const isHere = reason !== null && table === 'contact';
    this.error.textContent = isHere ? reason : '';
    this.error.hidden = !isHere;
    this.element.classList.toggle('wrong', isHere);
    const at = key === 'ends' ? this.ends : key === 'windings' || key === undefined ? this.windings : this.loss;
    for (const field of [this.windings, this.loss, this.ends]) {
      if (isHere && field === at) field.setAttribute('aria-invalid', 'true');
      else field.removeAttribute('aria-invalid');
    }
    return isHere;
  }

  private put(key: string, value: Value | undefined): void {
    putContact(this.store, withValue(this.store.state.spec, `contact.${key}`, value), `contact ${key}`);
  }
}
