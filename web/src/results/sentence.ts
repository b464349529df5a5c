// The answer in one sentence with numbers, for people who have just come.

import type { Answer, ContactFacts, Facts } from '../answer';
import { digits, fixed, make, word, type Child } from '../dom';

const percent = (force: number, { spring }: Facts) => `${digits((100 * force) / spring.nominalForce)}\u00a0%`;
const bold = (...text: Child[]) => make('b', {}, ...text);

/** What the two ends do, and what that means for a load cell. */
export function sentence(answer: Answer<Facts>, times: [number, number]): Child[] {
  const { facts, series } = answer;
  const { spring, forces, truth } = facts;
  const [one, two] = [series['F_i'], series['F_o']];
  if (!one || !two) return [];
  const time = series['time'] ?? new Float64Array();
  const shown = (index: number) => (time[index] ?? 0) >= times[0] && (time[index] ?? 0) <= times[1];
  const apart = one.reduce(
    (most, force, index) => (shown(index) ? Math.max(most, Math.abs(force - (two[index] ?? force))) : most),
    0,
  );
  const { name, window } = facts.conditions[facts.condition] ?? { name: 'this', window: [0, 0] };
  const other = truth === 'F_o' ? 'F_i' : 'F_o';
  const end = other === 'F_o' ? '2' : '1';
  const meant =
    truth === 'F_x' ? [word('F_x', 'k × stretch')] : [word(truth, `that at end ${truth === 'F_i' ? '1' : '2'}`)];
  const off = forces[other]?.rmsd ?? 0;
  // On a mass at end 2 the first mode is the mass's swing, far below the coil's own.
  const ring = `${digits(facts.lines.find((line) => line > 0.4 * spring.surgeFrequency) ?? 0)}\u00a0Hz`;
  const from = times[0] === 0 ? 'in the first ' : `from ${fixed(1e3 * times[0], 0)} to `;
  return [
    'In ',
    word('condition', `“${name}”`),
    ' (',
    word('zeta', facts.dampings[facts.damping]?.label ?? 'ζ = 0'),
    ') it ',
    word('surge', 'rings'),
    ` at ${ring}, ends up to `,
    bold(`${digits(apart, 3)}\u00a0N apart`),
    ` ${from}${fixed(1e3 * times[1], 0)}\u00a0ms: ${percent(apart, facts)} of `,
    word('F_nom', 'F', make('sub', {}, 'nom')),
    `. At ${digits(window[0])}–${digits(window[1])}\u00a0s end ${end}’s load cell is `,
    bold(`${percent(off, facts)} `, word('rmsd', 'rms'), ' off'),
    ' if you take ',
    ...meant,
    ' as the force.',
    facts.contact ? met(facts.contact) : facts.clash.firstContact !== null && beyond(),
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
