// The verdict of the spec that is shown, asked for once it rests: every condition, every damping, every sensor, as `coilsense analyze` has it.
//
// Next door: the card that shows it (`verdict`), the case that is drawn meanwhile (`compute`).

import type { Compute } from '../compute';
import type { Outcome } from './outcome';

/** How long a spec stands before it is judged [ms]: the engine that judges is busy for seconds. */
const REST = 150;

/** Where the verdict stands. */
export type Standing =
  | { kind: 'pending'; done: number; of: number }
  | { kind: 'judged'; outcome: Outcome }
  | { kind: 'failed'; reason: string };

export class Judge {
  private text = '';
  private timer = 0;
  private cancel: (() => void) | null = null;

  constructor(
    private readonly compute: Compute,
    private readonly tell: (standing: Standing) => void,
  ) {}

  /** The state moved on: what is under way is of an earlier one. */
  moved(): void {
    this.stop();
    this.text = '';
    this.tell({ kind: 'pending', done: 0, of: 0 });
  }

  /** The spec that now rests; nothing is asked twice. */
  rests(text: string): void {
    if (text === this.text) return;
    this.stop();
    this.text = text;
    this.tell({ kind: 'pending', done: 0, of: 0 });
    this.timer = window.setTimeout(() => void this.ask(text), REST);
  }

  /** Asks anew, after a failure. */
  again(): void {
    const { text } = this;
    this.text = '';
    this.rests(text);
  }

  private async ask(text: string): Promise<void> {
    const told = (done: number, of: number) => text === this.text && this.tell({ kind: 'pending', done, of });
    const { reply, cancel } = await this.compute.job({ kind: 'verdict', text }, told);
    if (text !== this.text) return cancel();
    this.cancel = cancel;
    const found = await reply;
    if (text !== this.text) return;
    this.cancel = null;
    if ('error' in found) this.tell({ kind: 'failed', reason: found.error });
    else if ('answer' in found) this.tell({ kind: 'judged', outcome: (found.answer.facts as { json: Outcome }).json });
  }

  private stop(): void {
    clearTimeout(this.timer);
    this.cancel?.();
    this.cancel = null;
  }
}
