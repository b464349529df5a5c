// How much of a log is read, what comes after that, and Cancel: there once it takes longer than a moment.
//
// Next door: who asks (`asking`), what Cancel brings back (`tabs/log`).

import { make } from '../dom';
import { Told } from '../told';

/** What is over sooner needs no progress [ms]. */
const MOMENT = 300;
const MEGA = 1e6;

export class Underway {
  readonly element: HTMLElement;
  private readonly bar = make('progress', { 'aria-label': 'Read of the log' });
  private readonly amount = make('span', { class: 'hint' });
  private readonly told = new Told(make('span', { role: 'status' }));
  private readonly parts: HTMLElement[];
  private words = '';
  private timer = 0;
  private isBusy = false;

  constructor(cancel: () => void) {
    const stop = make('button', { type: 'button', class: 'plain', onclick: cancel }, 'Cancel');
    this.parts = [this.amount, this.bar, stop];
    // The status stays, so that its end is heard, too.
    this.element = make(
      'div',
      { class: 'underway' },
      make('p', {}, this.told.element, ' ', this.amount),
      this.bar,
      stop,
    );
    this.show(false);
  }

  private show(shown: boolean): void {
    for (const part of this.parts) part.hidden = !shown;
  }

  /** Begins or ends; what is asked anew at once is the same to those who look. */
  busy(busy: boolean): void {
    if (busy === this.isBusy) return;
    this.isBusy = busy;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(
      () => {
        this.show(this.isBusy);
        if (!this.isBusy) this.say('');
        else this.say(this.words || 'Loading the larger engine …');
      },
      busy && this.bar.hidden ? MOMENT : 0,
    );
  }

  /** Ends at once, and says why. */
  end(why: string): void {
    clearTimeout(this.timer);
    this.isBusy = false;
    this.show(false);
    this.say(why);
  }

  /** So many bytes of a file are read; without a file, nothing can be told of how long it takes. */
  tell(done: number, of: number, file?: string): void {
    const isRead = !file || done >= of;
    if (isRead) this.bar.removeAttribute('value');
    else [this.bar.value, this.bar.max] = [done, of];
    const all = of / MEGA;
    const decimals = all < 10 ? 1 : 0;
    this.amount.textContent = isRead ? '' : `${(done / MEGA).toFixed(decimals)} of ${all.toFixed(decimals)} MB`;
    this.say(
      isRead
        ? file
          ? `${file} is read: looking for what rings …`
          : 'Loading the larger engine …'
        : `Reading ${file} …`,
    );
  }

  private say(words: string): void {
    this.words = words;
    // What is over in a moment is not told.
    if (!words || !this.bar.hidden || !this.isBusy) this.told.tell(words);
  }
}
