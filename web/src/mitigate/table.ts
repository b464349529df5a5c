// The ranking as a table, one of whose lines is picked.
//
// Next door: the same as points (`scatter`).

import { make, rich, word } from '../dom';
import { type Candidate, degrees, type Judged, lag, mostLag, percent, those } from './ranking';

export class Table {
  readonly element: HTMLElement;
  private readonly buttons = new Map<number, HTMLElement>();

  constructor(
    private readonly judged: Judged,
    truth: string,
    title: string,
    private readonly picked: (number: number) => void,
  ) {
    const heads = ['Pick one', 'Worst error', 'Error', 'Lag', 'Noise', 'Origin'];
    const table = make(
      'table',
      { class: 'ranking' },
      make(
        'caption',
        {},
        'rms, in % of F',
        make('sub', {}, 'nom'),
        judged.ranking.log === null ? ', over all conditions; worst: of any spring in the box. ' : ', over the log. ',
        'Noise: what comes out over what goes in. Best first.',
      ),
      make('thead', {}, make('tr', {}, ...heads.map((word) => make('th', { scope: 'col' }, word)))),
      make('tbody', {}, ...those(judged, truth).map(({ one, number }) => this.row(one, number))),
    );
    this.element = make(
      'section',
      { class: 'card', 'aria-label': title },
      make('div', { class: 'head' }, make('h2', {}, rich(title)), word('cleaned')),
      make('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': `Ranking: ${title}` }, table),
    );
  }

  pick(number: number): void {
    for (const [other, button] of this.buttons) button.setAttribute('aria-pressed', String(other === number));
  }

  private row(one: Candidate, number: number): HTMLElement {
    const { facts } = this.judged.answer;
    const late = lag(one) > mostLag(this.judged);
    const button = make(
      'button',
      { type: 'button', class: 'line', 'aria-pressed': 'false', onclick: () => this.picked(number) },
      one.name,
    );
    this.buttons.set(number, button);
    const advised = facts.best.includes(number) ? make('b', { class: 'within' }, ' ✓ advised') : null;
    return make(
      'tr',
      { 'data-candidate': one.name },
      make('th', { scope: 'row' }, button, advised),
      make('td', {}, percent(this.judged, one.worst_rms_error_n)),
      make('td', {}, percent(this.judged, one.rms_error_n)),
      make('td', { class: late ? 'above' : '' }, `${degrees(lag(one))}${late ? ' ✗ late' : ''}`),
      make('td', {}, one.noise_gain.toFixed(2)),
      make('td', {}, one.origin),
    );
  }
}
