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
    const { reply: coming, cancel } = this.compute.job(job, () => {});
    mine.push({ cancel });
    void coming.then((reply) => {
      // A newer question has come meanwhile.
      if (mine !== this.running) return;
      this.waiting -= 1;
      this.busy(this.waiting > 0);
      if ('answer' in reply) done(reply.answer as Answer<unknown>);
      else if ('error' in reply) wrong(reply.error);
    });
  }
}
