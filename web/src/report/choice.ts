// Which condition at which damping is shown: a row of buttons for each, and a line of facts.
//
// Next door: what is shown of it (`viewer`).

import { digits, fixed, make } from '../dom';
import type { PackedCase } from './data';

export class Choice {
  private readonly buttons: { button: HTMLButtonElement; is: (one: PackedCase) => boolean }[] = [];
  private shown: PackedCase | null = null;
  private readonly facts = make('p', { class: 'note' });

  /** `chosen` hears of another case. */
  constructor(
    host: HTMLElement,
    private readonly cases: readonly PackedCase[],
    private readonly chosen: (one: PackedCase) => void,
  ) {
    host.replaceChildren(this.row('Condition', 'condition', 'damping'), this.row('Damping', 'damping', 'condition'));
    host.append(this.facts);
  }

  /** Buttons for what differs between cases; pressed, one keeps the `other` choice as it is. */
  private row(title: string, key: 'condition' | 'damping', other: 'condition' | 'damping'): HTMLElement {
    const labels = [...new Set(this.cases.map((one) => one[key]))];
    const row = make(
      'div',
      { class: 'controls', role: 'group', 'aria-label': title, hidden: labels.length < 2 },
      title,
    );
    for (const label of labels) {
      const is = (one: PackedCase) => one[key] === label;
      const button = make('button', { type: 'button', class: 'plain' }, label);
      button.addEventListener('click', () => {
        const kept = this.cases.find((one) => is(one) && one[other] === this.shown?.[other]);
        this.chosen(kept ?? this.cases.find(is)!);
      });
      this.buttons.push({ button, is });
      row.append(button);
    }
    return row;
  }

  show(shown: PackedCase): void {
    this.shown = shown;
    for (const { button, is } of this.buttons) button.setAttribute('aria-pressed', String(is(shown)));
    const { goal_n: goal, surge_lines_hz: lines } = shown;
    const goalSaid = goal === null ? '' : `, goal ±${digits(goal, 4)} N`;
    const some = lines.slice(0, 3).map((hertz) => fixed(hertz, 1));
    const more = lines.length > 3 ? ' …' : '';
    const ringing = lines[0]
      ? `, surges at ${some.join(', ')}${more} Hz (${fixed(1e3 / lines[0], 1)} ms to and fro)`
      : '';
    this.facts.replaceChildren(make('b', {}, `${shown.condition}, ${shown.damping}`), `${goalSaid}${ringing}.`);
  }
}
