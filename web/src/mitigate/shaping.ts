// Shaping the command instead: what each shaper leaves of the ringing, and what it costs; where a condition moves u1.
//
// Next door: filters and estimators (`table`), the whole answer (`found`).

import { fixed, make, rich } from '../dom';
import type { Ranking } from './ranking';

export interface Shaper {
  name: string;
  mode_1_left: number;
  mode_1_left_worst: number;
  worst_case: string;
  modes_2_to_5_left_worst: number;
  mean_delay_s: number;
  length_s: number;
}

export interface Shaping {
  advice: string;
  shapers: Shaper[];
  left_out: { name: string; reason: string }[];
}

const HEADS = ['Left of ringing', 'Mode 1', 'At worst', 'Modes 2 to 5', 'Late', 'Length'];
const percent = (share: number) => `${fixed(100 * share, 1)} %`;
const milliseconds = (time: number) => `${fixed(1e3 * time, 1)} ms`;

/** Nothing where no condition moves u1. */
export function shaped({ command_shaping: shaping }: Ranking): HTMLElement | string {
  if (!shaping) return '';
  const title = 'Shape the command instead';
  const row = (one: Shaper) => {
    const shares = [one.mode_1_left, one.mode_1_left_worst, one.modes_2_to_5_left_worst].map(percent);
    const times = [one.mean_delay_s, one.length_s].map(milliseconds);
    const cells = [...shares, ...times].map((text) => make('td', {}, text));
    return make('tr', { 'data-shaper': one.name }, make('th', { scope: 'row' }, one.name), ...cells);
  };
  const table = make(
    'table',
    { class: 'ranking' },
    make(
      'caption',
      {},
      'Of what the plain command leaves when it ends, whatever it is; at worst of any spring in the box. Late: on the mean.',
    ),
    make('thead', {}, make('tr', {}, ...HEADS.map((word) => make('th', { scope: 'col' }, word)))),
    make('tbody', {}, ...shaping.shapers.map(row)),
  );
  return make(
    'section',
    { class: 'card', 'aria-label': title },
    make('div', { class: 'head' }, make('h2', {}, title)),
    make('p', { class: 'hint' }, rich(shaping.advice)),
    make('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Shaped commands' }, table),
    ...shaping.left_out.map(({ name, reason }) => make('p', { class: 'hint' }, `Left out: ${name}: ${reason}`)),
  );
}
