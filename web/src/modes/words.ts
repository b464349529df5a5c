// What the chart of the modes is of, in words.
//
// Next door: the chart (`chart`).

import type { ExactFacts } from '../answer';
import { make } from '../dom';
import type { Lines } from './lines';

const hertz = (value: number): string => `${value.toFixed(1)} Hz`;
const mm = (length: number): string => `${(1e3 * length).toFixed(1)} mm`;

/** A paragraph for each thing to know; `way` is the number of the way in which the ends are held. */
export function about(lines: Lines, shown: ExactFacts, way: number): HTMLElement[] {
  const { facts, ways } = lines;
  const [tight, loose] = ways;
  const model = facts.isChain
    ? `The forces above are of the paper’s chain of masses, which only moves along its axis: ${hertz(facts.modelFrequency)} at every length.`
    : `The model behind the forces above has its first mode along the axis at ${hertz(facts.modelFrequency)}.`;
  const shaded = tight && loose ? ` Shaded: from ${tight.ends} to ${loose.ends}.` : '';
  return [
    `Of the wire of ${shown.spring.name} as a helix, ${ways[way]?.ends ?? ''}.${shaded} ${model}`,
    driven(lines, shown),
    beyond(lines.lengths, shown),
    ...ways.map((one) => buckled(one, lines.lengths)),
  ]
    .filter(Boolean)
    .map((text) => make('p', { class: 'facts' }, text));
}

/** What drives the spring. */
function driven({ facts }: Lines, { conditions }: ExactFacts): string {
  const name = ([condition, value]: [number, number]) => `${conditions[condition]?.name ?? ''} ${hertz(value)}`;
  const within = facts.driven.filter(([, value]) => value <= facts.top);
  const above = facts.driven.filter(([, value]) => value > facts.top);
  const broad = conditions.filter((_, condition) => facts.broad[condition]);
  return [
    within.length > 0 ? `Driven along level lines: ${within.map(name).join(', ')}.` : '',
    above.length > 0 ? `Driven above the chart: ${above.map(name).join(', ')}.` : '',
    broad.length > 0 ? `Driven at every frequency: ${broad.map((one) => one.name).join(', ')}.` : '',
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
function buckled({ ends, buckles }: Lines['ways'][number], lengths: number[]): string {
  const those = lengths.filter((_, index) => buckles[index]);
  const [first, last] = [those[0], those[those.length - 1]];
  if (first === undefined || last === undefined) return '';
  const where = those.length === lengths.length ? 'at every length in use' : `from ${mm(first)} to ${mm(last)}`;
  return `With ${ends} the spring buckles ${where}, unless a guide holds it: its lines end there.`;
}
