// What stands there before anything is judged: what it is about, and what to press.
//
// Next door: what comes in its place (`found`).

import { make, rich } from '../dom';

const STEPS = [
  'Every filter of F_i and every estimator of F_o is designed for the spring of the tab Spring.',
  'Each runs sample by sample on what happens there, with noise, and with k and m off by some per cent.',
  'You get the one to take, how much error it leaves, how late it comes, and its settings for C or Rust.',
];

export const empty = (): HTMLElement =>
  make(
    'section',
    { class: 'card verdict', 'aria-label': 'What this is' },
    make('h2', {}, 'Which filter takes the ringing out of the force?'),
    make('ol', { class: 'plainlist' }, ...STEPS.map((text) => make('li', {}, rich(text)))),
    make('p', {}, 'Press ', make('b', {}, 'Judge'), '. It takes some seconds, in this browser.'),
  );
