// A live region that speaks once a second at most: of what comes faster, the last is said.

/** Between two sayings [ms]. */
const CALM = 1000;

export class Told {
  private next = '';
  private timer = 0;
  private last = -Infinity;

  constructor(readonly element: HTMLElement) {}

  tell(words: string): void {
    this.next = words;
    if (this.timer) return;
    const wait = Math.max(0, this.last + CALM - performance.now());
    this.timer = window.setTimeout(() => {
      [this.timer, this.last] = [0, performance.now()];
      if (this.element.textContent !== this.next) this.element.textContent = this.next;
    }, wait);
  }
}
