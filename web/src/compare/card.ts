// "Now beside kept": what differs in the inputs of both states, and what they give.
//
// Next door: the inputs (`inputs`), the figures (`figures`), who tells both states (`part`).

import { make, rich, type Child } from '../dom';
import { mark } from '../results/table';
import { isBeyond, named, type Case } from './case';
import { change, figures, type Cell, type Figure } from './figures';
import { differences, type Difference } from './inputs';

/** More inputs than these are folded. */
const MOST = 8;

const PENDING = () => [
  make('span', { 'aria-hidden': 'true' }, '…'),
  make('span', { class: 'visually-hidden' }, 'pending'),
];

export class Card {
  readonly element: HTMLElement;
  private readonly status = make('span', { class: 'status' });
  private readonly words = make('p', { class: 'facts' });
  private readonly few = make('tbody');
  private readonly more = make('tbody', { hidden: true });
  private readonly body = make('tbody');
  private readonly unfold = make('button', { type: 'button', class: 'plain' });
  private isOpen = false;
  private isBlank = false;

  constructor(before: HTMLElement) {
    const heads = ['', 'Kept', 'Now'].map((text) => make('th', { scope: 'col' }, text || 'What'));
    this.unfold.addEventListener('click', () => {
      this.isOpen = !this.isOpen;
      this.fold();
    });
    this.element = make(
      'section',
      { class: 'card beside', 'aria-label': 'Now beside kept', tabindex: -1, hidden: true },
      make('div', { class: 'head' }, make('h2', {}, 'Now beside kept'), this.status),
      make(
        'div',
        { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'What differs, and what it gives' },
        make('table', {}, make('thead', {}, make('tr', {}, ...heads)), this.few, this.more, this.body),
      ),
      this.unfold,
      this.words,
    );
    before.before(this.element);
  }

  /** The state moves on: no number of an earlier one may stand as its own. */
  blank(): void {
    if (this.isBlank || this.element.hidden) return;
    this.isBlank = true;
    this.status.textContent = 'now pending …';
    this.status.classList.add('preview');
    for (const cell of this.element.querySelectorAll('td.present')) cell.replaceChildren(...PENDING());
  }

  show(kept: Case, now: Case): void {
    this.isBlank = false;
    this.element.hidden = false;
    const words = this.standing(kept, now);
    this.status.textContent = words;
    this.status.classList.toggle('preview', words !== 'exact');
    const inputs = differences(kept.state, now.state);
    this.more.replaceChildren(...inputs.slice(MOST).map((one) => this.input(one)));
    const few = inputs.slice(0, MOST).map((one) => this.input(one));
    const none = make('td', { colspan: 3, class: 'none' }, 'Nothing yet: drag a slider, or choose another spring.');
    this.few.replaceChildren(heading('What differs'), ...(few.length > 0 ? few : [make('tr', {}, none)]));
    this.body.replaceChildren(heading('What it gives'), ...figures(kept, now).map((one) => this.figure(one)));
    this.words.replaceChildren(rich(said(kept, now)));
    this.fold();
  }

  hide(): void {
    this.element.hidden = true;
  }

  look(): void {
    this.element.scrollIntoView({ block: 'start' });
    this.element.focus({ preventScroll: true });
  }

  private standing(kept: Case, now: Case): string {
    if (now.failed) return 'now not computed';
    if (!now.exact) return 'now pending …';
    if (!kept.exact && !kept.failed) return 'kept pending …';
    const isJudged = now.judged && (kept.judged || kept.failed);
    return isJudged ? 'exact' : 'verdict pending …';
  }

  private fold(): void {
    const count = this.more.rows.length;
    this.more.hidden = !this.isOpen;
    this.unfold.hidden = count === 0;
    this.unfold.setAttribute('aria-expanded', String(this.isOpen));
    this.unfold.textContent = this.isOpen ? 'Fewer inputs' : `${count} more inputs that differ`;
  }

  private input({ label, kept, now }: Difference): HTMLElement {
    return row(label, [kept], [now]);
  }

  private figure({ label, kept, now }: Figure): HTMLElement {
    const cell = (one: Cell | null): Child[] => {
      if (!one) return PENDING();
      const meets = one.meets === undefined ? [] : ['\u00a0', goal(one.meets)];
      return [rich(one.text), ...meets];
    };
    const by = change(kept, now);
    return row(label, cell(kept), [...cell(now), by && make('span', { class: 'by' }, ` (${by})`)]);
  }
}

const heading = (text: string): HTMLElement =>
  make('tr', { class: 'group' }, make('th', { colspan: 3, scope: 'rowgroup' }, text));

const row = (label: string, kept: Child[], now: Child[]): HTMLElement =>
  make(
    'tr',
    { 'data-row': label },
    make('th', { scope: 'row' }, rich(label)),
    make('td', {}, ...kept),
    make('td', { class: 'present' }, ...now),
  );

const goal = (meets: boolean | null): HTMLElement =>
  make('span', { class: meets === null ? '' : meets ? 'within' : 'above' }, ...mark(meets));

/** What must be known of both before they are compared. */
function said(kept: Case, now: Case): string {
  const words = [
    `Kept: ${named(kept)}. Now: ${named(now)}. Errors of forces are in % of each state’s own F_nom, in the case that is shown; ✓ and ✗ are over all cases.`,
  ];
  const [one, other] = [kept.exact?.facts, now.exact?.facts];
  if (one && other) {
    const [a, b] = [one.conditions[one.condition], other.conditions[other.condition]];
    if (a && b && (a.name !== b.name || a.kind !== b.kind || String(a.window) !== String(b.window)))
      words.push('The two states differ in what happens, or in which part of it is judged.');
    if (isBeyond(one) || isBeyond(other))
      words.push('Where windings would touch, a real coil does not follow these figures.');
  }
  return words.join(' ');
}
