// The verdict of the spec that is shown, asked for once it rests: every condition, every damping, every sensor, as `coilsense analyze` has it.
//
// Next door: the card that shows it (`verdict`), the case that is drawn meanwhile (`compute`).

import type { Compute } from '../compute';
import { Judging } from '../jobs/judging';
import type { Outcome } from './outcome';

/** Where the verdict stands. */
export type Standing =
  | { kind: 'pending'; done: number; of: number }
  | { kind: 'judged'; outcome: Outcome }
  | { kind: 'failed'; reason: string };

export class Judge {
  private text = '';
  private readonly judging: Judging;

  constructor(
    compute: Compute,
    private readonly tell: (standing: Standing) => void,
  ) {
    this.judging = new Judging(() => compute.known());
  }

  /** The state moved on: what is under way is of an earlier one. */
  moved(): void {
    this.judging.drop();
    this.text = '';
    this.tell({ kind: 'pending', done: 0, of: 0 });
  }

  /** The spec that now rests; nothing is asked twice. */
  rests(text: string): void {
    if (text === this.text) return;
    this.text = text;
    this.tell({ kind: 'pending', done: 0, of: 0 });
    this.judging.ask({
      text,
      told: (done, of) => this.tell({ kind: 'pending', done, of }),
      done: (found) => {
        if ('error' in found) this.tell({ kind: 'failed', reason: found.error });
        else this.tell({ kind: 'judged', outcome: (found.facts as { json: Outcome }).json });
      },
    });
  }

  /** Asks anew, after a failure. */
  again(): void {
    const { text } = this;
    this.text = '';
    this.rests(text);
  }
}
