// How far each force is off: RMSD, maximum and bias in % of F_nom, against the user's limit.
//
// Next door: the same as curves (`plots`), what else must be known (`warnings`).

import type { Answer, Deviation, ExactFacts, Facts } from '../answer';
import { fixed, make, rich } from '../dom';
import { FORCE_NAMES, MEANING, sample } from '../plots/looks';
import type { Store } from '../state';

interface Row {
  name: string;
  meaning: string;
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
    const paper = FORCE_NAMES.map((name): Row => ({
      name,
      meaning: MEANING[name] ?? '',
      off: name === truth ? null : (forces[name] ?? null),
    }));
    const own = sensors.map(({ name, deviation }): Row => ({ name, meaning: '', off: deviation }));
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
      ...paper.map((row) => this.row(row, spring.nominalForce, goal, true)),
      ...(own.length > 0 ? [heading('With each sensor’s own noise, filter and lag')] : []),
      ...own.map((row) => this.row(row, spring.nominalForce, goal, false)),
    );
    if (focused) this.body.querySelector<HTMLElement>(`tr[data-force="${focused}"] button`)?.focus();
  }

  private row({ name, meaning, off }: Row, nominal: number, goal: number | null, drawn: boolean): HTMLElement {
    const percent = (force: number) => fixed((100 * force) / nominal, 3);
    const cells = off ? [percent(off.rmsd), percent(off.maximumAbsolute), percent(off.mean)] : ['–', '–', '–'];
    const above = off && goal !== null ? off.rmsd > goal : null;
    const verdict =
      above === null ? [] : [above ? '✗' : '✓', make('span', { class: 'word' }, above ? ' above' : ' within')];
    const title = drawn ? this.toggle(name, meaning) : make('span', {}, name);
    return make(
      'tr',
      { 'data-force': name },
      make('th', { scope: 'row' }, title),
      ...cells.map((text) => make('td', {}, text)),
      make('td', { class: above === null ? '' : above ? 'above' : 'within' }, ...verdict),
    );
  }

  /** Shows and hides the curve. */
  private toggle(name: string, meaning: string): HTMLElement {
    const { hidden } = this.store.state.view;
    const shown = !hidden.includes(name);
    const flip = () => {
      const now = this.store.state.view.hidden;
      this.store.setView({ hidden: shown ? [...now, name] : now.filter((other) => other !== name) });
    };
    return make(
      'button',
      {
        type: 'button',
        class: 'line',
        'aria-pressed': String(shown),
        title: shown ? 'Hide the curve' : 'Show the curve',
        onclick: flip,
      },
      sample(name),
      make('span', {}, make('b', {}, rich(name)), ` ${meaning}`),
    );
  }
}
