// How far each force is off in the case that is drawn: RMSD, maximum and bias in % of F_nom; and which sensors the command's verdict lets through.
//
// Next door: the same as curves (`plots`), the verdict over all cases (`verdict`), what else must be known (`warnings`).

import type { Answer, Deviation, ExactFacts, Facts } from '../answer';
import { fixed, make, rich, word } from '../dom';
import { FORCE_LINES, type Line } from '../plots/lines';
import { sample } from '../plots/looks';
import type { Store } from '../store';
import type { Outcome } from './outcome';

interface Row extends Line {
  off: Deviation | null;
}

export class Table {
  private readonly body = make('tbody');
  private readonly caption = make('caption');
  private meets = new Map<string, boolean | null>();
  /** The cells of the sensors' verdicts. */
  private marks: [string, HTMLElement][] = [];

  constructor(
    private readonly store: Store,
    host: HTMLElement,
  ) {
    const heads = Object.entries({ rmsd: 'RMSD', max: 'Max.', bias: 'Bias', limit: 'Goal' }).map(([id, text]) =>
      make('th', { scope: 'col' }, word(id, text)),
    );
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
    for (const [name, cell] of this.marks) this.mark(name, cell);
  }

  /** Exact values; while there are none, the last ones in grey. */
  show(facts: Facts, exact: Answer<ExactFacts> | null): void {
    this.body.classList.toggle('stale', exact === null);
    if (!exact) return;
    const { forces, sensors, spring, truth, dampings, damping, clash, contact } = exact.facts;
    const { hidden, sensors: wanted } = this.store.state.view;
    const paper = FORCE_LINES.map((line): Row => ({
      ...line,
      off: line.name === truth ? null : (forces[line.name] ?? null),
    }));
    const own = sensors.map(({ name, deviation }, number): Row => ({
      ...{ series: `reading ${number}`, name, meaning: '', number },
      off: deviation,
    }));
    const window = facts.conditions[facts.condition]?.window ?? [0, 0];
    // A coil whose windings would touch does something else: these numbers are of none.
    const beyond = contact === null && clash.firstContact !== null;
    this.body.classList.toggle('grey', beyond);
    this.caption.replaceChildren(
      rich(
        `This case, ${dampings[damping]?.label ?? ''}, judged from ${fixed(window[0], 2)} to ${fixed(window[1], 2)} s: off from ${truthOf(truth)}, in % of F_nom = ${fixed(spring.nominalForce, 1)} N.`,
      ),
      beyond ? ' In grey: windings would touch, so no real coil does this.' : '',
    );
    this.marks = [];
    const focused = this.body.contains(document.activeElement)
      ? document.activeElement?.closest('tr')?.getAttribute('data-force')
      : null;
    const heading = (text: string) =>
      make('tr', { class: 'group' }, make('th', { colspan: 5, scope: 'rowgroup' }, text));
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
    const cells = off ? [percent(off.rmsd), percent(off.maximumAbsolute), percent(off.mean)] : ['–', '–', '–'];
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
      ...cells.map((text) => make('td', {}, text)),
      verdict,
    );
  }

  private mark(name: string, cell: HTMLElement): void {
    const meets = this.meets.get(name);
    cell.className = typeof meets === 'boolean' ? (meets ? 'within' : 'above') : '';
    cell.replaceChildren(...(meets === undefined ? ['…'] : mark(meets)));
  }

  /** Shows and hides the curve. */
  private toggle({ series, name, meaning }: Line, shown: boolean): HTMLElement {
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
      make('span', {}, make('b', {}, rich(name)), meaning && ` ${meaning}`),
    );
  }
}

/** ✓ or ✗ and the word for it, by the command's verdict over all conditions and dampings. */
export function mark(meets: boolean | null, words = 'visually-hidden'): (string | HTMLElement)[] {
  if (meets === null) return ['–'];
  return [meets ? '✓' : '✗', make('span', { class: words }, meets ? ' meets it' : ' misses it')];
}

/** The force that counts as true, with what it is. */
const truthOf = (truth: string): string => (truth === 'F_x' ? 'F_x, if you take k × stretch as the force' : truth);
