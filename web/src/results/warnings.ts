// What a reader must know before using the numbers: the engine's own sentences, those that differ only in a sensor's name as one.
//
// Next door: who shows them (`below`), the verdict, which leads to them (`verdict`).

import type { ExactFacts, Facts } from '../answer';
import { digits, fixed, make, rich } from '../dom';

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

const heading = (subject: string): string => HEADINGS[subject] ?? subject;

/** The warnings of a case, of sensors that have the same one as one. */
function joined({ warnings, sensors }: ExactFacts): { subject: string; text: string }[] {
  const found = new Map<string, { subject: string; names: string[]; rest: string }>();
  for (const { subject, text } of warnings) {
    const name = sensors.find((sensor) => text.startsWith(`${sensor.name}: `))?.name;
    const rest = name === undefined ? text : text.slice(name.length);
    const key = JSON.stringify([subject, name === undefined, rest]);
    const one = found.get(key) ?? { subject, names: [], rest };
    found.set(key, { ...one, names: name === undefined ? [] : [...one.names, name] });
  }
  // Names have commas of their own.
  return [...found.values()].map(({ subject, names, rest }) => ({ subject, text: names.join(', and ') + rest }));
}

/** How many there are and what they are about, in a line; nothing where there are none. */
export function brief(facts: ExactFacts): string {
  const all = joined(facts);
  const kinds = [...new Set(all.map(({ subject }) => heading(subject)))].map((one) => one.toLowerCase());
  return all.length > 0 ? `${all.length} warning${all.length > 1 ? 's' : ''}: ${kinds.join('; ')}` : '';
}

export function showWarnings(host: HTMLElement, facts: Facts, exact: ExactFacts | null): void {
  if (exact) {
    const one = ({ subject, text }: { subject: string; text: string }) =>
      make(
        'li',
        { class: GRAVE.has(subject) ? 'grave' : '', 'data-subject': subject },
        make('b', {}, `${heading(subject)}. `),
        rich(text, true),
      );
    host.replaceChildren(...joined(exact).map(one));
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
export function springLine({ spring, lines }: Facts): DocumentFragment {
  const { solidLength, minLength, stiffness, mass } = spring;
  return rich(
    `k ${digits(stiffness)} N/m · m ${digits(1e3 * mass)} g · f1 ${digits(lines[0] ?? 0)} Hz · one way through the coil ${digits(1e3 * spring.transitTime)} ms · ` +
      `F_nom ${digits(spring.nominalForce, 4)} N · solid at ${digits(1e3 * solidLength)} mm, used from ${digits(1e3 * minLength)} mm`,
  );
}
