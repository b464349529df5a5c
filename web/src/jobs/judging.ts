// Asks for verdicts: one worker, which stays; the newest spec counts. A worker that ends, or is long at a case that nobody waits for, is replaced.
//
// Next door: the worker (`judge.worker`), who wants the verdict (`results/judge`), jobs of a worker each (`job`).

import { watch, type Alive } from '../alive';
import { STOPPED, type FromJudge } from '../answer';
import { again, say } from '../faults';
import { workshop } from '../workshop';

/** How long a newer spec waits for the case that is under way [ms]. */
const PATIENCE = 400;

/** A verdict, or why there is none. */
export type Found = { facts: unknown } | { error: string };

interface Asked {
  text: string;
  told: (done: number, of: number) => void;
  done: (found: Found) => void;
}

export class Judging {
  private worker: Worker | null = null;
  private asked: Asked | null = null;
  private id = 0;
  /** The newest that the worker was heard of; nothing while it begins, which may take long. */
  private heard = 0;
  private late = 0;
  private ended = 0;

  constructor(private readonly files: () => Promise<Map<string, string>>) {}

  /** Of a spec that a newer one overtook, nobody hears. */
  ask(asked: Asked): void {
    this.asked = asked;
    void this.send();
  }

  /** Nobody waits. */
  drop(): void {
    if (!this.asked) return;
    this.asked = null;
    this.worker?.postMessage({ id: ++this.id });
  }

  /** No more verdicts. */
  end(): void {
    this.asked = null;
    this.dismiss();
  }

  private async send(): Promise<void> {
    const id = ++this.id;
    const [engine, files] = [await workshop(), await this.files()];
    // A newer one has its own turn.
    if (id !== this.id || !this.asked) return;
    const begun = this.worker && this.heard > 0;
    this.worker ??= this.hire();
    this.worker.postMessage({ id, engine, files, text: this.asked.text });
    clearTimeout(this.late);
    if (begun) this.late = window.setTimeout(() => this.heard < id && this.anew(), PATIENCE);
  }

  private hire(): Worker {
    this.heard = 0;
    const worker = new Worker(new URL('./judge.worker.ts', import.meta.url), { type: 'module' });
    watch(worker, () => worker === this.worker && void this.gone());
    worker.addEventListener('message', ({ data }: MessageEvent<FromJudge | Alive>) => {
      if (worker === this.worker && 'id' in data) this.hear(data);
    });
    return worker;
  }

  private hear(data: FromJudge): void {
    this.heard = Math.max(this.heard, data.id);
    const { asked } = this;
    // An engine that stopped answers nothing more.
    const stopped = 'error' in data && data.error.startsWith(STOPPED);
    if (stopped) this.dismiss();
    if (data.id !== this.id || !asked) return;
    if ('told' in data) return asked.told(...data.told);
    this.ended = 0;
    this.asked = null;
    asked.done(data);
  }

  /** The same once more, by another worker. */
  private anew(): void {
    this.dismiss();
    if (this.asked) void this.send();
  }

  private dismiss(): void {
    clearTimeout(this.late);
    this.worker?.terminate();
    this.worker = null;
  }

  private async gone(): Promise<void> {
    this.dismiss();
    if (!this.asked) return;
    if (++this.ended % 2 === 1) say('judge', 'The worker that judges had stopped and was restarted.');
    else
      await again(
        'judge',
        'The worker that judges ends without an answer: its file is missing or came cut short, or memory is short. What you gave it is still here.',
      );
    if (this.asked && !this.worker) void this.send();
  }
}
