// How far each force is off in the case that is drawn: RMSD, maximum and bias; and which sensors the command's verdict lets through, in its order.
//
// Next door: the same as curves (`plots`), the verdict over all cases (`verdict`), what else must be known (`warnings`).

import type { Answer, Deviation, ExactFacts, Facts } from '../answer';
import { clamp, digits, fixed, make, rich, word } from '../dom';
import { FORCE_LINES, type Line } from '../plots/lines';
import { called, NAMES, sample } from '../plots/looks';
import type { Store } from '../store';
import type { Outcome } from './outcome';

interface Row extends Line {
  off: Deviation | null;
}

/** Heads of the figures as those of the verdict: whether the goal is met, newtons, then per cent; each with the word that explains it. */
const HEADS = [
  ['limit', 'Goal', ''],
  ['rmsd', 'RMSD', ' [N]'],
  ['rmsd', 'RMSD', ' [%]'],
  ['max', 'Max.', ' [%]'],
  ['bias', 'Bias', ' [%]'],
] as const;

export class Table {
  private readonly body = make('tbody');
  private readonly caption = make('caption');
  private meets = new Map<string, boolean | null>();
  /** Sensors from the best to the worst, as the last verdict has them. */
  private order: string[] = [];
  /** What is shown, for a verdict that puts its sensors in another order. */
  private shown: Parameters<Table['show']> | null = null;
  /** The cells of the sensors' verdicts. */
  private marks: [string, HTMLElement][] = [];

  constructor(
    private readonly store: Store,
    host: HTMLElement,
  ) {
    const heads = HEADS.map(([id, text, unit]) => make('th', { scope: 'col' }, word(id, text), unit));
    host.replaceChildren(
      make(
        'table',
        {},
        this.caption,
        make('thead', {}, make('tr', {}, make('th', { scope: 'col' }, 'Force'), ...heads)),
        this.body,
      ),
    );
  }

  /** What the command concludes of each sensor over all cases; null while it is not known. */
  judge(outcome: Outcome | null): void {
    this.meets = new Map(outcome?.ranking.map(({ sensor, meets_goal: meets }) => [sensor, meets]));
    const order = outcome?.ranking.map(({ sensor }) => sensor) ?? this.order;
    const isOther = order.join() !== this.order.join();
    this.order = order;
    if (isOther && this.shown) return this.show(...this.shown);
    for (const [name, cell] of this.marks) this.mark(name, cell);
  }

  /** Exact values; while there are none, the last ones in grey. */
  show(facts: Facts, exact: Answer<ExactFacts> | null): void {
    this.body.classList.toggle('stale', exact === null);
    if (!exact) return;
    this.shown = [facts, exact];
    const { forces, sensors, spring, truth, dampings, damping, clash, contact } = exact.facts;
    const { hidden, sensors: wanted } = this.store.state.view;
    const paper = FORCE_LINES.map((line): Row => ({
      ...line,
      off: line.name === truth ? null : (forces[line.name] ?? null),
    }));
    const place = (name: string) => (this.order.includes(name) ? this.order.indexOf(name) : Infinity);
    const own = sensors
      .map(({ name, deviation }, number): Row => ({ series: `reading ${number}`, name, number, off: deviation }))
      .sort((a, b) => place(a.name) - place(b.name) || a.number - b.number);
    const window = facts.conditions[facts.condition]?.window ?? [0, 0];
    // A coil whose windings would touch does something else: these numbers are of none.
    const beyond = contact === null && clash.firstContact !== null;
    this.body.classList.toggle('grey', beyond);
    const { name } = facts.conditions[facts.condition] ?? {};
    this.caption.replaceChildren(
      make(
        'b',
        {},
        `This “${name}”, ${dampings[damping]?.label ?? ''}, ${digits(window[0])}–${digits(window[1])}\u00a0s: `,
      ),
      rich(`off from ${called(truth)}, the force taken as true; % of F_nom = ${digits(spring.nominalForce, 4)} N`),
      beyond ? ' In grey: windings would touch, so no real coil does this.' : '',
    );
    this.marks = [];
    const focused = this.body.contains(document.activeElement)
      ? document.activeElement?.closest('tr')?.getAttribute('data-force')
      : null;
    const heading = (text: string) =>
      make('tr', { class: 'group' }, make('th', { colspan: 6, scope: 'rowgroup' }, text));
    this.body.replaceChildren(
      heading('What the spring alone does'),
      ...paper.map((row) => this.row(row, spring.nominalForce, !hidden.includes(row.name))),
      ...(own.length > 0 ? [heading('With each sensor’s own noise, filter and lag (tick two to compare)')] : []),
      ...own.map((row) => this.row(row, spring.nominalForce, wanted.includes(row.name))),
    );
    if (focused) this.body.querySelector<HTMLElement>(`tr[data-force="${CSS.escape(focused)}"] button`)?.focus();
  }

  private row(row: Row, nominal: number, shown: boolean): HTMLElement {
    const { name, off, series } = row;
    const percent = (force: number) => fixed((100 * force) / nominal, 3);
    const cells = off
      ? [
          fixed(off.rmsd, clamp(5 - Math.floor(Math.log10(nominal)), 0, 6)),
          percent(off.rmsd),
          percent(off.maximumAbsolute),
          percent(off.mean),
        ]
      : ['–', '–', '–', '–'];
    const verdict = make('td');
    // The spring alone is no sensor: the goal is for what measures it.
    if (series.startsWith('reading')) {
      this.marks.push([name, verdict]);
      this.mark(name, verdict);
    }
    return make(
      'tr',
      { 'data-force': name },
      make('th', { scope: 'row' }, this.toggle(row, shown)),
      verdict,
      ...cells.map((text) => make('td', {}, text)),
    );
  }

  private mark(name: string, cell: HTMLElement): void {
    const meets = this.meets.get(name);
    cell.className = typeof meets === 'boolean' ? (meets ? 'within' : 'above') : '';
    cell.replaceChildren(...(meets === undefined ? ['…'] : mark(meets)));
  }

  /** Shows and hides the curve. */
  private toggle({ series, name }: Line, shown: boolean): HTMLElement {
    // Forces are drawn unless they are hidden, readings only where they are asked for.
    const list = FORCE_LINES.some((line) => line.series === series) ? 'hidden' : 'sensors';
    const flip = () => {
      const now = this.store.state.view[list];
      const next = now.includes(name) ? now.filter((other) => other !== name) : [...now, name];
      this.store.setView({ [list]: next });
    };
    return make(
      'button',
      {
        type: 'button',
        class: 'line toggle',
        'aria-pressed': String(shown),
        title: shown ? 'Hide the curve' : 'Show the curve',
        onclick: flip,
      },
      sample(series),
      make('span', {}, make('b', {}, NAMES[name] ?? name), NAMES[name] && make('span', {}, ' (', rich(name), ')')),
    );
  }
}

/** ✓ or ✗ and the word for it, by the command's verdict over all conditions and dampings. */
export function mark(meets: boolean | null, words = 'visually-hidden'): (string | HTMLElement)[] {
  if (meets === null) return ['–'];
  return [meets ? '✓' : '✗', make('span', { class: words }, meets ? ' meets it' : ' misses it')];
}
