// Refusals wait until typing rests or the field is left: half a number is no mistake, and readers would hear each letter's.
//
// Next door: what a refusal is put beside (`panels`).

/** Typing rests after so long [ms]. */
const REST = 1000;

export class Patience<T> {
  private held: T | null = null;
  private timer = 0;

  constructor(private readonly say: (refusal: T | null) => void) {}

  /** An input event; only letters make it wait. */
  heard({ target }: Event): void {
    clearTimeout(this.timer);
    this.timer = 0;
    if (!(target instanceof HTMLInputElement) || target.type !== 'text') return;
    this.timer = window.setTimeout(() => this.rest(), REST);
    target.addEventListener('blur', () => this.rest(), { once: true });
  }

  /** What is refused now, or nothing any more, which is said at once. */
  tell(refusal: T | null): void {
    this.held = this.timer ? refusal : null;
    if (!this.held) this.say(refusal);
  }

  private rest(): void {
    const { held } = this;
    clearTimeout(this.timer);
    [this.held, this.timer] = [null, 0];
    if (held) this.say(held);
  }
}
