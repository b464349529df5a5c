// The fields of the state that is shown, in groups: what is dragged first, then the spring, the condition, the sensors.
//
// Next door: one field (`control`), damping (`damping`), windings that meet (`contact`), the spring given the other way (`way`), what end 2 is tied to (`end`), the fields' words (`fields`).

import type { Facts } from '../answer';
import type { Refusal } from '../compute';
import { section, sections, type Spec } from '../document';
import { make, reveal, word } from '../dom';
import { say } from '../faults';
import {
  BY_GEOMETRY,
  BY_VALUES,
  CONDITION,
  ENDS,
  GOAL,
  OFF_GEOMETRY,
  OFF_LENGTH,
  OFF_VALUES,
  RADII,
  SHAPE,
  TEMPLATES,
  TIMING,
  WARMTH,
  type Field,
} from '../fields';
import type { State } from '../state';
import type { Store } from '../store';
import { ContactControl } from './contact';
import { Control } from './control';
import { DampingControl } from './damping';
import { FarEnd } from './end';
import type { Shelf } from './shelf';
import { sensorFields } from './sensors';
import { byGeometry, turned } from './way';

export class Panels {
  private readonly damping: DampingControl;
  private readonly contact: ContactControl;
  private end = new FarEnd('');
  private controls: Control[] = [];
  private drawn = '';
  private facts: Facts | null = null;
  private revealed = '';
  /** Of the engine's catalogue, once a group of fields was opened. */
  private shelf: Shelf | null = null;

  constructor(
    private readonly store: Store,
    private readonly first: HTMLElement,
    private readonly host: HTMLElement,
    private readonly onInput: (event: Event) => void,
    private readonly catalogue: () => Promise<Shelf>,
  ) {
    this.damping = new DampingControl(store, onInput);
    this.contact = new ContactControl(store, onInput);
  }

  show(state: State, facts: Facts | null): void {
    this.facts = facts ?? this.facts;
    const shape = this.shape(state);
    if (shape !== this.drawn) this.draw(state);
    this.drawn = shape;
    this.shelf?.fill(state, this.controls, this.facts);
    for (const control of this.controls) control.show(state);
    this.damping.show(state, this.facts);
    this.contact.show(state);
  }

  private leftOut(): void {
    const text =
      'The table [control] does not go with an end 2 under a force: it is left out of the spec, and comes back with another end 2.';
    say('control', text, 'Undo', () => this.store.undo());
  }

  private async load(): Promise<void> {
    this.shelf = await this.catalogue();
    const show = () => this.show(this.store.state, null);
    show();
    this.shelf.load(show);
  }

  /** Puts a refusal beside its field, and shows that; null where there is no such field. */
  refuse(refusal: Refusal | null): HTMLElement | null {
    const place = refusal?.place ?? '';
    let found: HTMLElement | null = null;
    for (const control of this.controls) {
      const hit = control.place === place;
      control.refuse(hit ? (refusal?.text ?? null) : null);
      if (hit) found = control.element;
    }
    const damped = place === 'mount.damping_ratio';
    this.damping.refuse(damped ? (refusal?.text ?? null) : null);
    const met = this.contact.refuse(place, refusal?.text ?? null);
    if (damped) found = this.damping.element;
    if (met) found = this.contact.element;
    // Whoever types or drags is not taken elsewhere, and of one refusal everybody is once.
    const seen = found ? place : '';
    const isNew = seen !== this.revealed;
    this.revealed = seen;
    const isBusy = document.activeElement?.matches('input, select, textarea') ?? false;
    if (found && isNew && !isBusy) reveal(found);
    else for (let at = found?.closest('details'); at; at = at.parentElement?.closest('details')) at.open = true;
    return found;
  }

  /** What decides which fields there are. */
  private shape({ preset, spec, view }: State): string {
    const kind = sections(spec, 'condition')[view.condition]?.['kind'];
    return JSON.stringify([
      preset,
      byGeometry(spec),
      view.condition,
      kind,
      section(spec, 'mount')['end2'],
      sections(spec, 'sensor').length,
    ]);
  }

  private draw(state: State): void {
    this.controls = [];
    const { preset, spec, view } = state;
    if (this.end.preset !== preset) this.end = new FarEnd(preset, () => this.leftOut());
    const number = view.condition;
    const kind = String(sections(spec, 'condition')[number]?.['kind'] ?? 'impact');
    const condition = CONDITION[kind] ?? { first: [], more: [] };
    const geometry = byGeometry(spec);
    const at = (place: string) => (field: Field) => this.control(`${place}.${field.key}`, field);
    const spring = at('spring');
    const open = new Set([...this.host.querySelectorAll('details[open]')].map((one) => one.id));
    const group = (id: string, heading: string, ...children: (HTMLElement | null)[]) =>
      make(
        'details',
        { id, open: open.has(id), ontoggle: () => void this.load() },
        make('summary', {}, heading),
        ...children,
      );
    const mass = section(spec, 'mount')['end2'] === 'mass' ? this.control('mount.end_mass', this.end.mass) : null;
    // What is done comes first, beside the choice of it: on a phone it stands above the spring.
    this.first.replaceChildren(...condition.first.map(at(`condition.${number}`)));
    this.host.replaceChildren(
      make('div', { class: 'head' }, make('h2', {}, 'Spring, sensors and limit'), word('spring')),
      this.damping.element,
      this.contact.element,
      ...(geometry ? BY_GEOMETRY : BY_VALUES).map(spring),
      this.control('mount.end2', this.end.field),
      ...(mass ? [mass] : []),
      group(
        'more-condition',
        'What is done, in full',
        ...condition.more.map(at(`condition.${number}`)),
        ...TIMING.map(at(`condition.${number}`)),
      ),
      group(
        'more-spring',
        'The spring, in full',
        this.way(geometry),
        ...SHAPE.map(spring),
        ...(geometry ? ENDS : RADII).map(spring),
      ),
      group('more-sensors', `Sensors (${sections(spec, 'sensor').length})`, ...sensorFields(this.store, at)),
      ...GOAL.map(at('goal')),
      group(
        'more-tolerances',
        'Tolerances of real springs',
        ...[...(geometry ? OFF_GEOMETRY : OFF_VALUES), ...OFF_LENGTH].map(spring),
        ...WARMTH.map(at('uncertainty')),
      ),
    );
  }

  private control(place: string, field: Field): HTMLElement {
    const control = new Control(this.store, place, field, this.onInput);
    this.controls.push(control);
    return control.element;
  }

  /** By Table I's values or by wire and coil: the other way begins with what the one way gives. */
  private way(geometry: boolean): HTMLElement {
    const radio = (label: string, checked: boolean) =>
      make(
        'label',
        {},
        make('input', {
          type: 'radio',
          name: 'way',
          checked,
          onchange: () => this.facts && this.store.setSpec(turned(this.store.state.spec, this.facts)),
        }),
        make('span', {}, label),
      );
    return make(
      'fieldset',
      { class: 'choice' },
      make('legend', {}, 'Given by'),
      radio('values', !geometry),
      radio('wire and coil', geometry),
    );
  }
}

/** A condition more, with a name that no other has. */
export function withCondition(spec: Spec, kind: string): Spec {
  const all = sections(spec, 'condition');
  const names = new Set(all.map((one) => String(one['name'] ?? one['kind'])));
  let name = kind;
  for (let number = 2; names.has(name); number++) name = `${kind} ${number}`;
  return { ...structuredClone(spec), condition: [...structuredClone(all), { name, ...TEMPLATES[kind] }] };
}
