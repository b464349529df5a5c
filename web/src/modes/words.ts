// What the chart of the modes is of, in words.
//
// Next door: the chart (`chart`).

import type { ExactFacts, LinesFacts } from '../answer';
import { make } from '../dom';

const hertz = (value: number): string => `${value.toFixed(1)} Hz`;
const mm = (length: number): string => `${(1e3 * length).toFixed(1)} mm`;

/** A paragraph for each thing to know; `way` is the number of the way in which the ends are held. */
export function about(facts: LinesFacts, shown: ExactFacts, way: number): HTMLElement[] {
  const { lines } = facts;
  const [tight, loose] = lines.ways;
  const model = facts.isChain
    ? `The forces above are of the paper’s chain of masses, which only moves along its axis: ${hertz(facts.modelFrequency)} at every length.`
    : `The model behind the forces above has its first mode along the axis at ${hertz(facts.modelFrequency)}.`;
  const shaded = tight && loose ? ` Shaded: from ${tight.ends} to ${loose.ends}.` : '';
  return [
    `Of the wire of ${shown.spring.name} as a helix, ${lines.ways[way]?.ends ?? ''}.${shaded} ${model}`,
    driven(facts),
    beyond(lines.lengths_m, shown),
    ...lines.ways.map((one) => buckled(one, lines.lengths_m)),
  ]
    .filter(Boolean)
    .map((text) => make('p', { class: 'facts' }, text));
}

/** What drives the spring. */
function driven({ driven: all, broad, lines }: LinesFacts): string {
  const name = ({ condition, frequency_hz }: LinesFacts['driven'][number]) => `${condition} ${hertz(frequency_hz)}`;
  const within = all.filter(({ frequency_hz }) => frequency_hz <= lines.top_hz);
  const above = all.filter(({ frequency_hz }) => frequency_hz > lines.top_hz);
  return [
    within.length > 0 ? `Driven along level lines: ${within.map(name).join(', ')}.` : '',
    above.length > 0 ? `Driven above the chart: ${above.map(name).join(', ')}.` : '',
    broad.length > 0 ? `At every frequency: ${broad.join(', ')}.` : '',
  ]
    .filter(Boolean)
    .join(' ');
}

/** A condition at a length that is not in use. */
function beyond(lengths: number[], { meanLength, conditions, condition }: ExactFacts): string {
  const [first = 0, last = 0] = [lengths[0], lengths[lengths.length - 1]];
  const isBeyond = meanLength < first || meanLength > last;
  return isBeyond
    ? `${conditions[condition]?.name ?? 'The condition'} is at ${mm(meanLength)}, which is not on the chart: in use is ${mm(first)} to ${mm(last)}.`
    : '';
}

/** Lengths at which the spring has left its axis. */
function buckled({ ends, buckles }: LinesFacts['lines']['ways'][number], lengths: number[]): string {
  const those = lengths.filter((_, index) => buckles[index]);
  const [first, last] = [those[0], those[those.length - 1]];
  if (first === undefined || last === undefined) return '';
  const where = those.length === lengths.length ? 'at every length in use' : `from ${mm(first)} to ${mm(last)}`;
  return `With ${ends} the spring buckles ${where}, unless a guide holds it: its lines end there.`;
}
