// Which spring, and what happens to it: the two choices at the top.
//
// Next door: the fields below them (`panels`).

import { sections } from '../document';
import { make } from '../dom';
import { TEMPLATES } from '../fields';
import { PRESETS } from '../presets';
import type { State } from '../state';
import type { Store } from '../store';
import { withCondition } from './panels';

const NEW = 'new:';

export class Choose {
  private readonly spring = make(
    'select',
    { id: 'preset' },
    ...PRESETS.map(({ id, label }) => make('option', { value: id }, label)),
  );
  private readonly condition = make('select', { id: 'condition' });
  private drawn = '';

  constructor(
    private readonly store: Store,
    host: HTMLElement,
    first: HTMLElement,
  ) {
    this.spring.addEventListener('change', () => store.choosePreset(this.spring.value));
    this.condition.addEventListener('change', () => this.choose(this.condition.value));
    host.replaceChildren(
      make('div', { class: 'field' }, make('label', { for: 'preset' }, 'Spring'), this.spring),
      make('div', { class: 'field' }, make('label', { for: 'condition' }, 'What happens'), this.condition),
      first,
    );
    this.cue(first);
  }

  /** Who has just come is shown what to drag, until anything is changed. */
  private cue(first: HTMLElement): void {
    if (location.hash.length > 1) return;
    first.classList.add('cue');
    this.store.subscribe(({ spec }, before) => {
      if (spec !== before.spec) first.classList.remove('cue');
    });
  }

  show(state: State): void {
    this.spring.value = state.preset;
    const names = sections(state.spec, 'condition').map((one) => String(one['name'] ?? one['kind']));
    const now = JSON.stringify(names);
    if (now !== this.drawn) {
      this.drawn = now;
      const known = names.map((name, index) => make('option', { value: index }, name));
      const more = Object.keys(TEMPLATES).map((kind) => make('option', { value: NEW + kind }, kind));
      this.condition.replaceChildren(
        make('optgroup', { label: 'Of this spring' }, ...known),
        make('optgroup', { label: 'Add' }, ...more),
      );
    }
    this.condition.value = String(state.view.condition);
  }

  private choose(value: string): void {
    const { spec } = this.store.state;
    if (!value.startsWith(NEW)) return this.store.setView({ condition: Number(value), times: null }, true);
    const more = withCondition(spec, value.slice(NEW.length));
    this.store.setSpec(more, '', { condition: sections(more, 'condition').length - 1, times: null });
  }
}
