// Begin, how much is done, and cancel.
//
// Next door: what is begun (`tabs/mitigate`).

import { make } from '../dom';
import { Told } from '../told';

export class Progress {
  readonly element: HTMLElement;
  private readonly bar = make('progress', { 'aria-label': 'Candidates judged', hidden: true });
  private readonly told = new Told(make('p', { class: 'hint', role: 'status' }));
  private readonly start = make('button', { type: 'button', class: 'play' }, 'Judge');
  private readonly stop = make('button', { type: 'button', class: 'plain', hidden: true }, 'Cancel');

  constructor(begin: () => void, cancel: () => void) {
    this.start.addEventListener('click', begin);
    this.stop.addEventListener('click', cancel);
    this.element = make(
      'div',
      { class: 'progress' },
      make('div', { class: 'downloads' }, this.start, this.stop),
      this.bar,
      this.told.element,
    );
  }

  get isRunning(): boolean {
    return this.start.disabled;
  }

  begin(): void {
    [this.bar.hidden, this.stop.hidden, this.start.disabled] = [false, false, true];
    this.bar.removeAttribute('value');
    this.told.tell('Loading the larger engine …');
  }

  /** Candidates, or bytes of a file that is read. */
  tell(done: number, of: number, file?: string): void {
    if (file) return this.told.tell(`Reading ${file} …`);
    if (of === 0) return this.told.tell('Designing …');
    [this.bar.value, this.bar.max] = [done, of];
    this.told.tell(`${done} of ${of} candidates judged`);
  }

  rest(words: string): void {
    [this.bar.hidden, this.stop.hidden, this.start.disabled] = [true, true, false];
    this.told.tell(words);
  }
}
