// The tab *Paper*: Tables II and III beside the print, Figs. 2 and 4, all computed when the tab is opened.
//
// Next door: how they are computed (`coilsense-web`, `paper`).

import type { Answer, PaperFacts } from '../answer';
import { fixed, make, rich, word } from '../dom';
import { curves } from '../plots/curves';
import { readInk } from '../plots/looks';
import figures from '../style/figures.css?inline';
import css from '../style/paper.css?inline';
import { wear } from '../style/wear';
import type { Open } from './tab';

const CONDITIONS = [
  ['heel strike', '(a) Heel strike'],
  ['end stop max', '(b) End stop when extending'],
  ['resonance', '(c) At the first eigenfrequency'],
] as const;

export const open: Open = (panel, _, compute) => {
  readInk();
  wear(figures, css);
  const place = make(
    'div',
    { class: 'paper', 'aria-busy': 'true' },
    make('p', {}, 'Computing both springs in five conditions under two readings …'),
  );
  panel.replaceChildren(place);
  const begun = performance.now();
  void compute.alone({ kind: 'paper' }).then((reply) => {
    if ('answer' in reply) fill(place, reply.answer as Answer<PaperFacts>, performance.now() - begun);
    else place.replaceChildren(make('p', { class: 'refusal' }, 'error' in reply ? reply.error : 'no answer'));
  });
};

function fill(place: HTMLElement, { facts, series }: Answer<PaperFacts>, milliseconds: number): void {
  place.setAttribute('aria-busy', 'false');
  const figures = make('div', { class: 'figures' });
  place.replaceChildren(
    make('div', { class: 'head' }, make('h2', {}, 'The paper, computed here'), word('cleaned')),
    make(
      'p',
      {},
      'Van der Weijde, van Ostayen and Vallery, “',
      make(
        'a',
        { href: PAPER, target: '_blank', rel: 'noopener noreferrer' },
        'Influence of Internal Oscillations on Force Sensing in Coil Springs',
      ),
      '”: its simulated tables and figures, ' +
        `computed in your browser just now in ${fixed(milliseconds / 1e3, 1)} s. Two readings: “tables” is what makes the printed numbers come out, “text” is what the words say. ` +
        'A cell that is more than 0.02 percentage points from the print is marked.',
    ),
    make('div', { class: 'tables' }, ...['II', 'III'].map((numeral) => table(facts, numeral))),
    ...facts.warnings.map((text) => make('p', { class: 'warning' }, text)),
    figures,
  );
  const none = new Float64Array();
  const of = (name: string) => series[name] ?? none;
  curves(figures, {
    title: 'Fig. 2: transmittance of S_T’s chain against eq. (1), far end clamped',
    x: { label: 'Frequency [Hz]', values: of('figure 2 frequency') },
    y: { label: '|Fₒ / Fᵢ|', logarithmic: true, range: [0.5, 1000] },
    curves: [
      { look: 'F_o', label: 'chain of 52 windings', values: of('figure 2 chain') },
      { look: 'F_i', label: 'eq. (1)', values: of('figure 2 continuous') },
    ],
  });
  for (const spring of ['S_T', 'S_A']) {
    for (const [condition, title] of CONDITIONS) {
      const at = (what: string) => of(`${spring} ${condition} ${what}`);
      curves(figures, {
        title: `Fig. 4 for ${spring}: ${title}`,
        x: { label: 'Time [s]', values: at('time') },
        y: { label: 'Force [N]' },
        curves: ['F_o', 'F_i', 'F_L', 'F_x'].map((force) => ({ look: force, label: force, values: at(force) })),
      });
    }
  }
}

function table({ cells }: PaperFacts, numeral: string): HTMLElement {
  const of = cells.filter((cell) => cell.table === numeral);
  const rows = [...new Set(of.map((cell) => `${cell.spring}, ${cell.condition}`))];
  const forces = ['F_i', 'F_o', 'F_L'];
  const find = (row: string, force: string) =>
    of.find((cell) => `${cell.spring}, ${cell.condition}` === row && cell.force === force);
  const value = (row: string, force: string) => {
    const cell = find(row, force);
    if (!cell) return [];
    const computed = (['tables', 'text'] as const).map((reading) => {
      const { percent, differs } = cell.computed[reading];
      return make(
        'td',
        { class: differs ? 'off' : '' },
        fixed(percent, 2),
        differs ? make('span', { class: 'visually-hidden' }, ' differs') : null,
      );
    });
    return [make('td', { class: 'printed group' }, fixed(cell.printed, 2)), ...computed];
  };
  const what = numeral === 'II' ? 'RMSD from F_x' : 'maximum deviation from F_x';
  return make(
    'div',
    { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': `Table ${numeral}` },
    make(
      'table',
      {},
      make('caption', {}, make('b', {}, `Table ${numeral}: `), rich(what), ', in % of F', make('sub', {}, 'nom')),
      make(
        'thead',
        {},
        make(
          'tr',
          {},
          make('td'),
          ...forces.map((force) => make('th', { colspan: 3, scope: 'colgroup', class: 'group' }, rich(force))),
        ),
        make(
          'tr',
          {},
          make('th', { scope: 'col' }, 'Spring, condition'),
          ...forces.flatMap(() =>
            ['printed', 'tables', 'text'].map((word, index) =>
              make('th', { scope: 'col', class: index === 0 ? 'group' : '' }, word),
            ),
          ),
        ),
      ),
      make(
        'tbody',
        {},
        ...rows.map((row) =>
          make('tr', {}, make('th', { scope: 'row' }, row), ...forces.flatMap((force) => value(row, force))),
        ),
      ),
    ),
  );
}
