// A spring by its values or by wire and coil: from one way to the other, with what the engine made of it; back with what was typed.
//
// Next door: the fields of either way (`panels`).

import type { Facts } from '../answer';
import { section, withValue, type Spec } from '../document';

export const byGeometry = (spec: Spec): boolean =>
  'wire_diameter' in section(spec, 'spring') || 'coil_diameter' in section(spec, 'spring');

/** Numbers of a spring have so many digits when they come from the engine. */
const DIGITS = 6;
const millimetres = (metres: number): string => `${Number((1e3 * metres).toPrecision(DIGITS))} mm`;

/** The table of a spring as it was before it was turned, by what it was turned into. */
const former = new Map<string, Spec[string]>();

/** The spring given the other way; as it was typed, where nothing of it was edited since it was turned. */
export function turned(spec: Spec, facts: Facts): Spec {
  const before = section(spec, 'spring');
  const known = former.get(JSON.stringify(before));
  const next = known ? { ...spec, spring: known } : byGeometry(spec) ? toValues(spec, facts) : toGeometry(spec, facts);
  former.set(JSON.stringify(section(next, 'spring')), before);
  return next;
}

function toGeometry(spec: Spec, { spring }: Facts): Spec {
  const without = ['stiffness', 'mass', 'coil_radius', 'wire_radius'].reduce(
    (rest, key) => withValue(rest, `spring.${key}`, undefined),
    spec,
  );
  const wire = withValue(without, 'spring.wire_diameter', millimetres(spring.wireDiameter));
  return withValue(wire, 'spring.coil_diameter', millimetres(2 * spring.coilRadius));
}

const ONLY_GEOMETRY = [
  'wire_diameter',
  'coil_diameter',
  'total_windings',
  'wire_diameter_tolerance',
  'coil_diameter_tolerance',
  'windings_tolerance',
  'shear_modulus_tolerance',
];

function toValues(spec: Spec, { spring }: Facts): Spec {
  const without = ONLY_GEOMETRY.reduce((rest, key) => withValue(rest, `spring.${key}`, undefined), spec);
  const values: Record<string, string> = {
    stiffness: `${Number(spring.stiffness.toPrecision(DIGITS))} N/m`,
    mass: `${Number((1e3 * spring.mass).toPrecision(DIGITS))} g`,
    coil_radius: millimetres(spring.coilRadius),
    wire_radius: millimetres(spring.wireDiameter / 2),
  };
  return Object.entries(values).reduce((rest, [key, value]) => withValue(rest, `spring.${key}`, value), without);
}
