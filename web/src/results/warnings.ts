// What a reader must know before using the numbers: the engine's own sentences.

import type { ExactFacts, Facts } from '../answer';
import { digits, fixed, make } from '../dom';

const HEADINGS: Record<string, string> = {
  clash: 'Windings touch',
  contact: 'Windings meet',
  length: 'Out of the range in use',
  doubt: 'Values do not fit together',
  alias: 'Folded down by sampling',
  range: 'Overloaded',
  temperature: 'Drift with temperature not known',
  neighbour: 'Other motion nearby',
};
const GRAVE = new Set(['clash', 'length', 'range']);

export function showWarnings(host: HTMLElement, facts: Facts, exact: ExactFacts | null): void {
  if (exact) {
    const one = ({ subject, text }: { subject: string; text: string }) =>
      make(
        'li',
        { class: GRAVE.has(subject) ? 'grave' : '', 'data-subject': subject },
        make('b', {}, `${HEADINGS[subject] ?? subject}. `),
        text,
      );
    host.replaceChildren(...exact.warnings.map(one));
  } else if (!facts.contact && facts.clash.firstContact !== null && !host.querySelector('[data-subject=clash]')) {
    host.prepend(
      make(
        'li',
        { class: 'grave', 'data-subject': 'clash' },
        make('b', {}, 'Windings touch. '),
        `From ${fixed(1e3 * facts.clash.firstContact, 1)} ms on (preview).`,
      ),
    );
  }
}

/** A line of numbers of the spring. */
export function springLine({ spring, lines }: Facts): string {
  const { solidLength, minLength, stiffness, mass } = spring;
  return (
    `k ${digits(stiffness)} N/m · m ${digits(1e3 * mass)} g · f1 ${digits(lines[0] ?? 0)} Hz · one way through the coil ${digits(1e3 * spring.transitTime)} ms · ` +
    `F_nom ${digits(spring.nominalForce, 4)} N · solid at ${digits(1e3 * solidLength)} mm, used from ${digits(1e3 * minLength)} mm`
  );
}
