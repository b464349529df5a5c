// Questions about a log to the larger engine: newer ones end those under way, and the panel is busy while any is.
//
// Next door: what is asked (`tabs/log`), the workers (`jobs/job`).

import type { Answer, Job } from '../answer';
import type { Compute } from '../compute';

export class Asking {
  private running: { cancel: () => void }[] = [];
  private waiting = 0;

  constructor(
    private readonly compute: Compute,
    private readonly busy: (busy: boolean) => void,
    /** Hears how much of a file is read. */
    private readonly told: (done: number, of: number, file?: string) => void = () => {},
    /** Hears that nothing is left under way, unless it was ended. */
    private readonly over: () => void = () => {},
  ) {}

  /** Ends what is under way. */
  cancel(): void {
    for (const { cancel } of this.running) cancel();
    this.running = [];
    this.waiting = 0;
    this.busy(false);
  }

  ask(job: Job, wrong: (error: string) => void, done: (answer: Answer<unknown>) => void): void {
    const mine = this.running;
    this.waiting += 1;
    this.busy(true);
    const { reply: coming, cancel } = this.compute.job(job, (...told) => {
      if (mine === this.running) this.told(...told);
    });
    mine.push({ cancel });
    void coming.then((reply) => {
      // A newer question has come meanwhile.
      if (mine !== this.running) return;
      if ('answer' in reply) done(reply.answer as Answer<unknown>);
      else if ('error' in reply) wrong(reply.error);
      // What came of it may have ended the others, and asked something else.
      if (mine === this.running) this.waiting -= 1;
      if (this.waiting > 0) return;
      this.busy(false);
      this.over();
    });
  }
}
