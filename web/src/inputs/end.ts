// What end 2 is tied to, as a field; what goes with one choice only is put aside with it, and comes back with it.
//
// Next door: all other fields (`fields`, `control`), where it stands (`panels`).

import { section, withValue, type Spec, type Value } from '../document';
import type { Field } from '../fields';

/** Keys that the engine takes of an end 2 on a mass only. */
const OF_MASS = ['mount.end_mass', 'mount.first_mode_damping_ratio'];
/** Where nobody gave one: the example of the spec's reference. */
const USUAL_MASS = '2 kg';

export class FarEnd {
  /** What was put aside, by its place; a whole table by its name. */
  private readonly aside = new Map<string, Value>();
  private control: Spec[string] | undefined;

  /** Of a preset: what another one had on its end 2 is none of its own. */
  constructor(
    readonly preset: string,
    /** Hears that the loop of control was put aside. */
    private readonly aloud: () => void = () => {},
  ) {}

  readonly field: Field = {
    key: 'end2',
    label: 'End 2',
    wide: true,
    words: ['held', 'force', 'mass'],
    names: { force: 'under a constant force', mass: 'tied to a mass' },
    then: (spec) => this.fit(spec),
  };
  readonly mass: Field = { key: 'end_mass', label: 'Mass at end 2' };

  /** The spec with what its end 2 takes, and nothing else. */
  private fit(spec: Spec): Spec {
    const mount = section(spec, 'mount');
    const isMass = mount['end2'] === 'mass';
    let next = spec;
    for (const place of OF_MASS) {
      const given = mount[place.split('.')[1] ?? ''];
      if (given !== undefined) this.aside.set(place, given);
      const usual = place === 'mount.end_mass' ? USUAL_MASS : undefined;
      next = withValue(next, place, isMass ? (given ?? this.aside.get(place) ?? usual) : undefined);
    }
    return this.fitLoop(next, mount['end2'] === 'force');
  }

  /** A loop of control whose load is not told is none where end 2 is a force: the engine refuses the whole spec then. */
  private fitLoop(spec: Spec, isForce: boolean): Spec {
    const { control, ...rest } = spec;
    if (isForce && control && !('load_mass' in section(spec, 'control'))) {
      this.control = control;
      this.aloud();
      return rest;
    }
    return isForce || control || !this.control ? spec : { ...spec, control: this.control };
  }
}
