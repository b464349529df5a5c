// How far each force is off: RMSD, maximum and bias in % of F_nom, against the user's limit.
//
// Next door: the same as curves (`plots`), what else must be known (`warnings`).

import type { Answer, Deviation, ExactFacts, Facts } from '../answer';
import { fixed, make, rich } from '../dom';
import { FORCE_LINES, type Line } from '../plots/lines';
import { sample } from '../plots/looks';
import type { Store } from '../store';

interface Row extends Line {
  off: Deviation | null;
}

export class Table {
  private readonly body = make('tbody');
  private readonly caption = make('caption');

  constructor(
    private readonly store: Store,
    host: HTMLElement,
  ) {
    const heads = ['RMSD', 'Max.', 'Bias', 'Limit'].map((text) => make('th', { scope: 'col' }, text));
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

  /** Exact values; while there are none, the last ones in grey. */
  show(facts: Facts, exact: Answer<ExactFacts> | null): void {
    this.body.classList.toggle('stale', exact === null);
    if (!exact) return;
    const { forces, sensors, goal, spring, truth } = exact.facts;
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
    this.caption.replaceChildren(
      'Off from ',
      rich(truth),
      `, in % of F`,
      make('sub', {}, 'nom'),
      ` = ${fixed(spring.nominalForce, 1)} N, from ${fixed(window[0], 2)} to ${fixed(window[1], 2)} s.`,
    );
    const focused = this.body.contains(document.activeElement)
      ? document.activeElement?.closest('tr')?.getAttribute('data-force')
      : null;
    const heading = (text: string) =>
      make('tr', { class: 'group' }, make('th', { colspan: 5, scope: 'rowgroup' }, text));
    this.body.replaceChildren(
      heading('What the spring alone does'),
      ...paper.map((row) => this.row(row, spring.nominalForce, goal, !hidden.includes(row.name))),
      ...(own.length > 0 ? [heading('With each sensor’s own noise, filter and lag')] : []),
      ...own.map((row) => this.row(row, spring.nominalForce, goal, wanted.includes(row.name))),
    );
    if (focused) this.body.querySelector<HTMLElement>(`tr[data-force="${CSS.escape(focused)}"] button`)?.focus();
  }

  private row(row: Row, nominal: number, goal: number | null, shown: boolean): HTMLElement {
    const { name, off } = row;
    const percent = (force: number) => fixed((100 * force) / nominal, 3);
    const cells = off ? [percent(off.rmsd), percent(off.maximumAbsolute), percent(off.mean)] : ['–', '–', '–'];
    const above = off && goal !== null ? off.rmsd > goal : null;
    const verdict =
      above === null ? [] : [above ? '✗' : '✓', make('span', { class: 'word' }, above ? ' above' : ' within')];
    return make(
      'tr',
      { 'data-force': name },
      make('th', { scope: 'row' }, this.toggle(row, shown)),
      ...cells.map((text) => make('td', {}, text)),
      make('td', { class: above === null ? '' : above ? 'above' : 'within' }, ...verdict),
    );
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
