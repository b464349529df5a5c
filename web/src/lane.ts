// One worker and the questions to it: one is under way, the newest waits, older ones are dropped. A worker that ends is replaced, and asked once more.
//
// Next door: which questions there are (`compute`), the lanes of one engine (`lanes`), how an end is noticed (`alive`).

import { watch, type Alive } from './alive';
import { STOPPED, type FromWorker, type Question, type ToWorker } from './answer';
import { again, say, SILENT, slow } from './faults';

export type Reply = Exclude<FromWorker, never>;

interface Job {
  question: Question;
  done: (reply: Reply) => void;
}

const ENDS =
  'The engine’s worker ends as it begins: its file is missing or cut short, or memory is short. Nothing that you set is lost.';

export class Lane {
  private worker: Worker | null = null;
  private underWay: (Job & { id: number }) | null = null;
  private waiting: Job | null = null;
  private next = 0;
  /** Workers that ended one after the other without an answer. */
  private ended = 0;
  private isOver = false;
  private late = 0;
  private quick = () => {};

  /** `mayStop`: a newer question ends the one under way, at the price of a new worker, in place of waiting for it. */
  constructor(
    private readonly engine: Promise<WebAssembly.Module>,
    private readonly files: Map<string, string>,
    private readonly mayStop: boolean,
    private readonly hire: () => Worker,
  ) {
    this.begin();
  }

  addFile(file: string, text: string): void {
    this.send({ file, text });
  }

  ask(question: Question, done: (reply: Reply) => void): void {
    this.waiting = { question, done };
    if (this.underWay && this.mayStop) {
      this.underWay = null;
      this.begin();
    }
    if (!this.underWay) this.start();
  }

  /** Nobody waits for what was asked. */
  drop(): void {
    this.waiting = null;
    if (this.underWay) this.underWay.done = () => {};
  }

  /** No more questions. */
  end(): void {
    this.isOver = true;
    this.rest();
    this.worker?.terminate();
  }

  /** A worker in place of the one there was. */
  private begin(): void {
    this.rest();
    this.worker?.terminate();
    const worker = this.hire();
    this.worker = worker;
    watch(worker, () => worker === this.worker && void this.anew());
    worker.addEventListener('message', ({ data }: MessageEvent<FromWorker | Alive>) => {
      if (worker === this.worker && 'id' in data) this.finish(data);
    });
    void this.engine.then((engine) => {
      worker.postMessage({ engine } satisfies ToWorker);
      for (const [file, text] of this.files) worker.postMessage({ file, text } satisfies ToWorker);
    });
  }

  /** The worker has ended: another is asked the same; where that ends, too, the user is. */
  private async anew(): Promise<void> {
    if (this.isOver) return;
    this.rest();
    this.worker = null;
    this.ended += 1;
    if (this.ended > 1) {
      await again('worker', ENDS);
      this.ended = 0;
    } else say('worker', 'The engine had stopped and was restarted.');
    this.replace();
  }

  /** Another worker, which is asked what the last one was. */
  private replace(): void {
    if (this.underWay) this.waiting ??= this.underWay;
    this.underWay = null;
    this.begin();
    this.start();
  }

  private start(): void {
    if (!this.waiting || !this.worker) return;
    const job = { ...this.waiting, id: this.next++ };
    this.underWay = job;
    this.waiting = null;
    this.send({ id: job.id, question: job.question });
    // What is still being loaded says so by itself.
    void this.engine.then(() => {
      if (this.underWay === job) this.late = window.setTimeout(() => this.wait(), SILENT);
    });
  }

  /** No answer for long: it may be much to compute, or a worker that hangs. */
  private wait(): void {
    this.quick = slow('The engine is still computing …', 'Restart it', () => this.replace());
  }

  /** Nobody is waited for. */
  private rest(): void {
    clearTimeout(this.late);
    this.quick();
    this.quick = () => {};
  }

  private send(message: ToWorker): void {
    const { worker } = this;
    // The engine's own message comes first.
    void this.engine.then(() => worker?.postMessage(message));
  }

  private finish(reply: Reply): void {
    if (reply.id !== this.underWay?.id) return;
    const { done } = this.underWay;
    this.rest();
    this.underWay = null;
    this.ended = 0;
    // What is left of an engine that stopped halfway is not to be asked again.
    if ('error' in reply && reply.error.startsWith(STOPPED)) this.begin();
    this.start();
    done(reply);
  }
}
