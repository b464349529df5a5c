// The finding in one sentence with one size, for people who have just come; in smaller type below it, what it holds for.

import type { Answer, ConditionFacts, ContactFacts, Facts, Series } from '../answer';
import { digits, fixed, make, word, type Child } from '../dom';

const bold = (...text: Child[]) => make('b', {}, ...text);
const nominal = () => word('F_nom', 'F', make('sub', {}, 'nom'));

/** A motion of the length below this share of what the ends differ by is none [1]: k × stretch is then a straight line on the plot. */
const STILL = 1e-3;
/** Forces that are the same but for rounding, of F_nom [1]. */
const SAME = 1e-6;
/** What begins with a blow, which is over when the curves begin. */
const BLOWS = ['impact', 'end-stop'];

/** The largest of what is asked for over the shown times. */
function most(series: Series, [from, to]: [number, number], of: (index: number) => number): number {
  const time = series['time'] ?? new Float64Array();
  return time.reduce((most, at, index) => (at >= from && at <= to ? Math.max(most, of(index)) : most), -Infinity);
}

/** What the two ends do, and below it what that means for a load cell. */
export function sentence({ facts, series }: Answer<Facts>, times: [number, number]): Child[] {
  const [one, two, length] = [series['F_i'], series['F_o'], series['F_x']];
  const condition = facts.conditions[facts.condition];
  if (!one || !two || !condition) return [];
  const apart = most(series, times, (index) => Math.abs((one[index] ?? 0) - (two[index] ?? 0)));
  const of = (sign: number) => most(series, times, (index) => sign * (length?.[index] ?? NaN));
  const swing = length ? of(1) + of(-1) : NaN;
  return [
    make(
      'span',
      { class: 'finding' },
      BLOWS.includes(condition.kind) ? 'After ' : 'In ',
      word('condition', `“${condition.name}”`),
      ...finding(facts, apart, swing),
      facts.contact ? met(facts.contact) : facts.clash.firstContact !== null && beyond(),
    ),
    make('span', { class: 'finer' }, ...finer(facts, condition, times)),
  ];
}

/** How far the ends are apart, and whether the length tells of it. */
function finding({ spring, lines, clash, contact }: Facts, apart: number, swing: number): Child[] {
  const force = spring.nominalForce;
  const size = [nominal(), ` = ${digits(force, 4)}\u00a0N`];
  if (apart < SAME * force) return [' the forces at the two ends are the same; errors are told in % of ', ...size, '.'];
  const share = `${digits((100 * apart) / force, 2)}\u00a0%`;
  // On a mass at end 2 the first mode is the mass's swing, far below the coil's own.
  const line = lines.find((line) => line > 0.4 * spring.surgeFrequency) ?? 0;
  // Windings that meet do not ring at a frequency.
  const isFree = (contact ? contact.first : clash.firstContact) === null;
  const ring = [word('surge', 'ringing'), ` (${digits(line)}\u00a0Hz)`];
  const told =
    swing < STILL * apart
      ? [' shows none of this', ...(isFree ? [' ', ...ring] : [])]
      : [` itself changes by ${digits(swing, 2)}\u00a0N`];
  return [
    ' the forces at the two ends differ by up to ',
    bold(`${digits(apart, 2)}\u00a0N`),
    `, ${share} of `,
    ...size,
    '; ',
    word('F_x', 'k × stretch'),
    ...told,
    '.',
  ];
}

/** Which damping and times that is of, and how far off a load cell is where the forces are judged. */
function finer(
  { forces, truth, spring, dampings, damping }: Facts,
  { window }: ConditionFacts,
  times: number[],
): Child[] {
  const [from = 0, to = 0] = times.map((time) => fixed(1e3 * time, 0));
  const other = truth === 'F_o' ? 'F_i' : 'F_o';
  const meant = truth === 'F_x' ? 'k × stretch' : `the force at end ${truth === 'F_i' ? '1' : '2'}`;
  return [
    word('zeta', dampings[damping]?.label ?? 'ζ = 0'),
    times[0] === 0 ? `, first ${to}\u00a0ms. ` : `, ${from}–${to}\u00a0ms. `,
    `Over ${digits(window[0])}–${digits(window[1])}\u00a0s a load cell at end ${other === 'F_o' ? '2' : '1'} is off from `,
    word('truth', meant),
    ` by ${digits((100 * (forces[other]?.rmsd ?? 0)) / spring.nominalForce)}\u00a0% of `,
    nominal(),
    ', ',
    word('rmsd', 'rms'),
    '.',
  ];
}

/** Above all tabs; whoever is at one of its words stays there. */
export function say(parts: Child[]): void {
  const [host, next] = [document.getElementById('sentence'), make('p', {}, ...parts)];
  if (!host || host.textContent === next.textContent) return;
  const at = host.contains(document.activeElement) ? document.activeElement?.getAttribute('data-word') : null;
  host.replaceChildren(...next.childNodes);
  if (at) host.querySelector<HTMLElement>(`[data-word=${at}]`)?.focus();
}

const beyond = () => make('b', { class: 'beyond' }, ' Windings touch: a real coil would do something else.');

/** What windings did that were asked to meet. */
function met({ law, first, touches, fastest }: ContactFacts): string {
  if (first === null) return ` No windings meet (${law}).`;
  return ` Windings meet from ${fixed(1e3 * first, 1)}\u00a0ms on, ${touches} times, at up to ${digits(fastest)}\u00a0m/s (${law}).`;
}
