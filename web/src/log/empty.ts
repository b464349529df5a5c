// What stands in the tab while no log is there: what to drop, what one gets, and a simulated log for those who have none.
//
// Next door: what stands there afterwards (`found`).

import { make, word } from '../dom';

const GETS: [string, string][] = [
  ['A verdict', 'Is it the spring that rings, or the frame, a motor, the mains? With what speaks for it.'],
  [
    'The spring',
    'Surge frequency, damping, stiffness, mass of the coil, each with its 95 % interval – as a spec, too.',
  ],
  ['What to trust', 'Up to which frequency the force at one end is the force at the other.'],
  ['A calibration', 'Of length by inductance, where the log holds L, beside the theories of a coil.'],
];

export function empty(tryIt: () => void): HTMLElement {
  return make(
    'section',
    { class: 'card empty', 'aria-label': 'What a log tells' },
    make('h2', {}, 'Drop a log of your spring: see what rings, and which spring it is ', word('cleaned')),
    make(
      'p',
      {},
      'Strike the spring a few times, or pull it slowly, and record a force; better both forces and both positions. A few seconds are enough.',
    ),
    make('ul', { class: 'gets' }, ...GETS.map(([name, words]) => make('li', {}, make('b', {}, name), ` ${words}`))),
    make(
      'div',
      { class: 'downloads' },
      make('button', { type: 'button', class: 'plain primary', onclick: tryIt }, 'Try it with a simulated log'),
      make('span', { class: 'hint' }, 'of the spring and the condition of the tab Spring, with noise'),
    ),
    make(
      'p',
      { class: 'hint' },
      'CSV and other text: comma, semicolon, tab or spaces, point or comma for decimals, with titles or without – all of it is found out. Parquet, MATLAB and MDF go to the command: coilsense identify. Nothing leaves this browser.',
    ),
  );
}
