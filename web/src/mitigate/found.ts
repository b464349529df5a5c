// What came of it: the advice, error against lag, one candidate over time, the rankings. Whoever picks, all of them show the same one.
//
// Next door: its parts (`scatter`, `picked`, `table`, `shaping`), what was asked (`form`).

import { make, rich } from '../dom';
import { download } from '../download';
import { picture } from '../plots/picture';
import type { Choices } from './choices';
import { Picked } from './picked';
import { conditions, GROUPS, type Judged } from './ranking';
import { Scatter } from './scatter';
import { shaped } from './shaping';
import { Table } from './table';

/** From which number of series on the worst is one. */
const ENOUGH = 5;

export class Found {
  private readonly parts: { pick(number: number): void }[];
  private readonly picked: Picked;
  private shown = -1;

  constructor(
    host: HTMLElement,
    private readonly judged: Judged,
    private readonly choices: Choices,
  ) {
    const { ranking } = judged;
    const pick = (number: number) => choices.set('candidate', ranking.candidates[number]?.name ?? '');
    const figures = make('div', { class: 'figures' });
    const groups = GROUPS.filter(([truth]) => ranking.candidates.some(({ against }) => against === truth));
    const tables = groups.map(([truth, title]) => new Table(judged, truth, title, pick));
    this.picked = new Picked(judged, choices);
    host.replaceChildren(
      this.verdict(),
      figures,
      this.picked.element,
      make('div', { class: 'rankings' }, ...tables.map(({ element }) => element), shaped(ranking)),
      this.leftOut(),
    );
    const scatters = groups.map(([truth, title]) => new Scatter(figures, judged, truth, title, pick));
    host.append(this.downloads(scatters));
    this.parts = [...tables, ...scatters];
    this.follow();
  }

  /** Shows the candidate that is chosen, else the first one that is advised. */
  follow(): void {
    const { ranking, answer } = this.judged;
    const wanted = ranking.candidates.findIndex(({ name }) => name === this.choices.get('candidate'));
    const number = wanted >= 0 ? wanted : (answer.facts.best.find((best) => best !== null) ?? 0);
    if (number === this.shown) return;
    this.shown = number;
    for (const part of this.parts) part.pick(number);
    this.picked.show(number);
  }

  private verdict(): HTMLElement {
    const { ranking } = this.judged;
    const few = `With ${ranking.seeds} series of noise; coilsense mitigate takes ${ENOUGH} unless told otherwise.`;
    return make(
      'section',
      { class: 'card verdict', 'aria-label': 'Advice' },
      ...ranking.advice.map((line) => make('p', {}, rich(line))),
      make('p', { class: 'hint' }, rich(conditions(this.judged))),
      ranking.log === null && ranking.seeds < ENOUGH ? make('p', { class: 'warning' }, few) : null,
    );
  }

  private leftOut(): HTMLElement | string {
    const { left_out: each } = this.judged.ranking;
    if (each.length === 0) return '';
    const items = each.map(({ name, reason }) => make('li', {}, `${name}: ${reason}`));
    return make(
      'section',
      { class: 'card', 'aria-label': 'Left out' },
      make('h2', {}, 'Left out'),
      make('ul', { class: 'plainlist' }, ...items),
    );
  }

  private downloads(scatters: Scatter[]): HTMLElement {
    const plain = (label: string, act: () => void) =>
      make('button', { type: 'button', class: 'plain', onclick: act }, label);
    const all = () => download('mitigation.json', this.judged.answer.facts.json, 'application/json');
    const figure = ({ drawing }: Scatter, number: number) =>
      download(`trade-off-${number + 1}.svg`, picture(drawing, { width: 640, height: 420 }), 'image/svg+xml');
    return make(
      'div',
      { class: 'downloads' },
      plain('Everything (JSON)', all),
      plain('Error against lag (SVG)', () => scatters.forEach(figure)),
    );
  }
}
