// Below the plot: what is kept, in the legend's words, and what can be done with it.
//
// Next door: who does it (`part`), what changed since (`card`).

import { make } from '../dom';
import { sample } from '../plots/looks';
import { PALE, WIDER } from './held';

export interface Acts {
  swap(): void;
  forget(): void;
  look(): void;
}

/** A kept line, as in the plots. */
export function keptSample(): SVGSVGElement {
  const line = sample({ colour: 'ink', dash: [], width: 1.4 * WIDER });
  line.style.opacity = String(PALE);
  return line;
}

export class Bar {
  private readonly words = make('span');
  private readonly said = make('span', { class: 'visually-hidden', role: 'status' });
  private readonly look: HTMLButtonElement;
  private readonly swap: HTMLButtonElement;
  private readonly element: HTMLElement;

  constructor(after: HTMLElement, acts: Acts) {
    const button = (label: string, title: string, act: () => void) =>
      make('button', { type: 'button', class: 'plain', title, onclick: act }, label);
    this.look = button('What changed', 'The table below', acts.look);
    this.look.classList.add('look');
    this.swap = button('Swap', 'Exchanges the kept state and the one that is shown', acts.swap);
    this.element = make(
      'div',
      { class: 'kept', role: 'group', 'aria-label': 'Kept to compare', hidden: true },
      keptSample(),
      this.words,
      this.look,
      this.swap,
      button('Forget', 'Nothing is kept any more', acts.forget),
    );
    after.after(this.element, this.said);
  }

  /** `trouble`: why it is not drawn; what cannot be computed cannot be exchanged either. */
  show(words: string, trouble: string, canSwap: boolean): void {
    this.element.hidden = false;
    this.words.replaceChildren(
      make('b', {}, 'kept'),
      ` (broad, pale): ${words}`,
      make('span', { class: 'trouble' }, trouble && ` ${trouble}`),
    );
    this.swap.disabled = !canSwap;
  }

  hide(): void {
    this.element.hidden = true;
  }

  tell(words: string): void {
    this.said.textContent = words;
  }
}
