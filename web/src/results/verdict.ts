// The command's own verdict: what to choose, how sure that is, what each sensor lacks and what would mend it.
//
// Next door: who asks for it (`judge`), the case that is drawn, with a mark for each sensor (`table`).

import type { ExactFacts } from '../answer';
import { digits, fixed, make, reveal, rich, word } from '../dom';
import { called } from '../plots/looks';
import type { Standing } from './judge';
import type { Outcome, Ranked } from './outcome';
import { mark } from './table';
import css from '../style/verdict.css?inline';
import { wear } from '../style/wear';
import { brief } from './warnings';

export class Verdict {
  private readonly status = make('span', { class: 'standing' }, '…');
  private readonly bar = make('progress', { 'aria-label': 'Cases judged' });
  private readonly body = make('div', { class: 'verdict' });
  private readonly scope = make('p', { class: 'scope' });
  private readonly heed = make('p', { class: 'heed' });

  constructor(
    host: HTMLElement,
    private readonly again: () => void,
  ) {
    wear(css);
    host.replaceChildren(
      make('div', { class: 'head' }, make('h2', {}, 'Which sensor to trust'), word('sensors'), this.status),
      this.scope,
      this.bar,
      this.heed,
      this.body,
    );
  }

  /** What is judged, beside the one case that is drawn, and what that case must be read with. */
  about(facts: ExactFacts): void {
    this.scope.replaceChildren(...scope(facts));
    const warnings = brief(facts);
    this.heed.hidden = warnings === '';
    this.heed.replaceChildren(
      `${warnings}. `,
      lead('Read them', () => document.querySelector<HTMLElement>('.rely')),
    );
  }

  /** While a newer one is pending the last verdict stands in grey. */
  show(standing: Standing): void {
    const pending = standing.kind === 'pending';
    this.body.classList.toggle('stale', pending);
    this.body.toggleAttribute('inert', pending);
    this.body.setAttribute('aria-busy', String(pending));
    this.bar.hidden = !pending;
    if (standing.kind === 'pending') return this.wait(standing.done, standing.of);
    this.status.textContent = standing.kind === 'judged' ? 'as coilsense analyze' : 'not judged';
    this.body.replaceChildren(
      ...(standing.kind === 'judged'
        ? told(standing.outcome)
        : [
            make('p', { class: 'refusal' }, standing.reason),
            make('button', { type: 'button', class: 'plain', onclick: this.again }, 'Try again'),
          ]),
    );
  }

  private wait(done: number, of: number): void {
    this.status.textContent = of ? `judging: ${done} of ${of} cases` : 'judging …';
    if (of) [this.bar.max, this.bar.value] = [of, done];
    else this.bar.removeAttribute('value');
  }
}

function told(outcome: Outcome): HTMLElement[] {
  const [first = '', ...rest] = outcome.answer;
  // What to do, as far as the first pause: "Choose two encoders".
  const end = /^.*?(?=[;,(]|\.\s|$)/.exec(first)?.[0].length ?? 0;
  const answer = make(
    'p',
    { class: 'answer' },
    make('b', {}, rich(first.slice(0, end), true)),
    make('span', {}, rich(first.slice(end), true)),
  );
  const lines = rest.map((line) => make('p', {}, rich(line, true)));
  const more = lines.length > 0 ? [make('details', {}, make('summary', {}, 'Details'), ...lines)] : [];
  return outcome.ranking.length > 0
    ? [answer, goal(outcome), ranking(outcome), ...remedies(outcome), ...more]
    : [answer, ...lines];
}

/** A button that leads to another place of the page. */
function lead(words: string, to: () => HTMLElement | null): HTMLElement {
  const go = () => {
    const place = to();
    if (!place) return;
    reveal(place);
    place.focus({ preventScroll: true });
  };
  return make('button', { type: 'button', class: 'lead', onclick: go }, words);
}

/** That the verdict is of more than the case that is drawn. */
function scope({ conditions, dampings, condition, contact, damping }: ExactFacts): (HTMLElement | string)[] {
  const count = (number: number, word: string) =>
    `${number === 1 ? 'the' : `all ${number}`} ${word}${number === 1 ? '' : 's'}`;
  const ways = contact ? 'way of damping and meeting' : 'damping';
  const all = `Over ${count(conditions.length, 'condition')}, ${count(dampings.length, ways)} and the tolerances of this spring`;
  const isOne = conditions.length * dampings.length === 1;
  const drawn = `“${conditions[condition]?.name ?? ''}”, ${dampings[damping]?.label ?? ''}`;
  return [make('b', {}, isOne ? all : `${all}, not only ${drawn}`), '.'];
}

/** What is judged: the goal with its force, its size and its bandwidth. */
function goal({ goal, nominal_force_n: nominal }: Outcome): HTMLElement {
  const size =
    goal.error_n === null
      ? 'No goal is set'
      : `Goal: ${digits(goal.error_n)} N (${digits((100 * goal.error_n) / nominal)} % of F_nom) standard uncertainty`;
  const band = goal.bandwidth_hz === null ? 'at every frequency' : `up to ${digits(goal.bandwidth_hz)} Hz`;
  return make(
    'p',
    { class: 'facts' },
    rich(`${size}, ${band}. Force taken as true: ${called(goal.force)}. `),
    lead('Change it', () => document.getElementById('goal-force')),
  );
}

/** Heads of the figures, each with the word that explains it. */
const HEADS = [
  ['u', 'u [N]'],
  ['F_nom', '% of F_nom'],
  ['worst', 'nominal [N]'],
  ['worst', 'worst [N]'],
  ['worst', 'inside'],
  ['lag', 'lag [ms]'],
  ['condition', 'worst in'],
] as const;

function ranking(outcome: Outcome): HTMLElement {
  const heads = [['kinds', 'Sensor'], ['limit', 'Goal'], ...HEADS].map(([id = '', text = '']) =>
    make('th', { scope: 'col' }, word(id, rich(text))),
  );
  const head = make('tr', {}, ...heads);
  const whole = () => table.classList.toggle('widened');
  const table = make(
    'div',
    { class: 'scroll ranking', tabindex: 0, role: 'region', 'aria-label': 'Every sensor’s uncertainty' },
    // A phone has room for the first four columns.
    make('button', { type: 'button', class: 'plain unfold', onclick: whole }, 'More or fewer columns'),
    make('table', {}, make('thead', {}, head), make('tbody', {}, ...outcome.ranking.map(row))),
    make(
      'p',
      { class: 'facts' },
      'u: combined standard uncertainty in the worst case, rms over the springs within tolerance; nominal, worst: error of the nominal and of the worst spring; inside: share of the springs that meet the goal in the least favourable case.',
    ),
  );
  return table;
}

function row(one: Ranked): HTMLElement {
  const meets = one.meets_goal;
  const cells = [
    digits(one.combined_n),
    digits(one.combined_percent),
    digits(one.nominal_n),
    digits(one.worst_specimen_n),
    one.share_inside_goal === null ? '–' : `${fixed(100 * one.share_inside_goal, 0)} %`,
    fixed(1e3 * one.lag_s, 2),
    `${one.worst_condition}, ${one.worst_damping}`,
  ];
  return make(
    'tr',
    { 'data-sensor': one.sensor },
    make('th', { scope: 'row' }, one.sensor),
    make('td', { class: meets === null ? '' : meets ? 'within' : 'above' }, ...mark(meets, 'word')),
    ...cells.map((text) => make('td', {}, text)),
  );
}

/** What would mend a sensor that misses the goal. */
function remedies({ ranking }: Outcome): HTMLElement[] {
  const mended = ranking.flatMap(({ sensor, fixes }) => fixes.slice(0, 1).map((fix) => ({ sensor, fix })));
  if (mended.length === 0) return [];
  const lines = mended.map(({ sensor, fix }) =>
    make(
      'li',
      {},
      `${sensor}: ${fix.change}, then ${digits(fix.combined_n)} N${fix.lag_s === null ? '' : `, ${fixed(1e3 * fix.lag_s, 1)} ms late`}`,
    ),
  );
  return [make('h3', {}, 'What would fix it'), make('ul', { class: 'plainlist' }, ...lines)];
}
