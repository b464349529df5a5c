// A spring by its values or by wire and coil: from one way to the other, with what the engine made of it.
//
// Next door: the fields of either way (`panels`).

import type { Facts } from '../answer';
import { section, withValue, type Spec } from '../document';

export const byGeometry = (spec: Spec): boolean =>
  'wire_diameter' in section(spec, 'spring') || 'coil_diameter' in section(spec, 'spring');

const millimetres = (metres: number): string => `${Number((1e3 * metres).toPrecision(6))} mm`;

export function toGeometry(spec: Spec, { spring }: Facts): Spec {
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

export function toValues(spec: Spec, { spring }: Facts): Spec {
  const without = ONLY_GEOMETRY.reduce((rest, key) => withValue(rest, `spring.${key}`, undefined), spec);
  const values: Record<string, string> = {
    stiffness: `${Number(spring.stiffness.toPrecision(6))} N/m`,
    mass: `${Number((1e3 * spring.mass).toPrecision(6))} g`,
    coil_radius: millimetres(spring.coilRadius),
    wire_radius: millimetres(spring.wireDiameter / 2),
  };
  return Object.entries(values).reduce((rest, [key, value]) => withValue(rest, `spring.${key}`, value), without);
}
