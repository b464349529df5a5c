// What the two ends do at a frequency, in words: the sizes, the phase, up to where one may be taken for the other, and what the curve leaves out.
//
// Next door: the curve (`curve`), where it all comes together (`part`).

import type { Answer, CurveFacts, ExactFacts, PointFacts, Polar } from '../answer';
import { digits, make, rich, type Child } from '../dom';
import { hertz } from './choice';

/** From so many times the driven end's force on there is no number any more. */
const LIMITLESS = 1e6;
/** Phases that are no farther apart are one [deg]. */
const IN_STEP = 0.5;
/** Where the force at the driven end is less or more than this of k times its motion, the ratio hides why. */
const FAINT = 0.3;
const LOUD = 3;

/** The forces at the driven end and at the other one. */
export const names = (driven: 1 | 2): { own: string; other: string; end: number } =>
  driven === 1 ? { own: 'F_i', other: 'F_o', end: 2 } : { own: 'F_o', other: 'F_i', end: 1 };

/** A factor as people read it. */
export const times = (value: Polar): string =>
  value && value[0] < LIMITLESS ? `×${digits(value[0], 4)}` : 'without limit';

function phase(value: Polar): string {
  if (!value) return '';
  const degrees = (value[1] * 180) / Math.PI;
  if (Math.abs(degrees) < IN_STEP) return 'in step with it';
  if (180 - Math.abs(degrees) < IN_STEP) return 'opposite to it (180°)';
  return `${digits(Math.abs(degrees))}° ${degrees < 0 ? 'behind' : 'ahead of'} it`;
}

/** A share of a force, by its name; from twice of it on a factor. */
function share(value: number | null, force: string): string {
  if (value === null || value >= LIMITLESS) return `more than a million times ${force}`;
  return value < 2 ? `${digits(100 * value)}\u00a0% of it` : `${digits(value)} times ${force}`;
}

/** For the slider: short. */
export const brief = ({ driven, frequency, through }: PointFacts): string =>
  `${hertz(frequency)}: ${names(driven).other} is ${times(through)} ${names(driven).own}`;

/** The live sentence. */
export function sentence(point: PointFacts, { until }: CurveFacts): Child[] {
  const { driven, isMoved, frequency, through, lengthOverOwn, off, within } = point;
  const { own, other, end } = names(driven);
  const percent = `${digits(100 * within)}\u00a0%`;
  const how = isMoved ? 'moved' : 'pulled';
  return [
    `At ${hertz(frequency)} a load cell at end ${end} shows `,
    make('b', {}, times(through)),
    rich(` of the force at end ${driven}, which is ${how} (${other}/${own}), ${phase(through)}`),
    rich(`; k × stretch shows ${times(lengthOverOwn)} of it. `),
    rich(`Taken for ${own}, ${other} is off by ${share(off, own)} here; `),
    until.through === null
      ? make('b', {}, `it is nowhere within ${percent}.`)
      : make('b', {}, `it is within ${percent} up to ${hertz(until.through)}.`),
  ];
}

/** Why the ratio is as it is, where it does not say so itself. */
export function reason({ driven, isMoved, own, other, through }: PointFacts): Child[] {
  if (!isMoved) return [];
  const { own: name, other: far } = names(driven);
  const [near, there] = [own?.[0] ?? Infinity, other?.[0] ?? Infinity];
  if (near < FAINT && (through?.[0] ?? Infinity) > LOUD)
    return [
      rich(
        `The ratio is this large since ${name} all but vanishes here: it is ${times(own)} of k × motion, and ${far} ${times(other)}. The coil swings almost as it would with that end free.`,
      ),
    ];
  if (near > LOUD && there > LOUD)
    return [
      rich(
        `The coil rings here: ${name} is ${times(own)} and ${far} ${times(other)} of k × motion. Their ratio says little.`,
      ),
    ];
  return [rich(`Of k × motion, ${name} is ${times(own)} and ${far} ${times(other)}.`)];
}

/** What the curve is of, and what it leaves out. */
export function about({ facts: curve, series }: Answer<CurveFacts>, shown: ExactFacts): HTMLElement[] {
  const { tied, undamped, driven, peaks } = curve;
  const { own, other } = names(driven);
  const damping = shown.dampings[shown.damping]?.label ?? 'ζ = 0';
  const [first] = peaks;
  const texts = [
    `A sine at end ${driven}, once everything else has died down, for ${damping}${curve.isMoved ? '' : '; the other end is held'}.`,
    tied === 'force' &&
      'End 2 is under a force that is prescribed, whatever end 1 does: it is pulled here with a sine, and end 1, held, feels what arrives.',
    tied === 'mass' &&
      curve.isMoved &&
      `End 2 carries a mass: what end 1 accelerates of the spring does not arrive there, so that ${other}/${own} begins at ${times([series['through']?.[0] ?? NaN, 0])}, not at 1.`,
    undamped &&
      first &&
      `ζ = 0: the peaks have no top, and ${other}/${own} none at ${hertz(first[0])}, where ${own} is nothing at all. Any real spring has one.`,
    shown.contact
      ? 'Windings are asked to meet: the curve is of motions so small that none do.'
      : shown.clash.firstContact !== null &&
        'Windings touch in the motion that is shown above: a real coil does not follow this curve then.',
  ];
  return texts.filter((text) => typeof text === 'string').map((text) => make('p', {}, rich(text)));
}
