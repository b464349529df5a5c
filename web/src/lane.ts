// One worker and the questions to it: one is under way, the newest waits, older ones are dropped.
//
// Next door: which questions there are (`compute`), the lanes of one engine (`lanes`).

import { STOPPED, type FromWorker, type Question, type ToWorker } from './answer';

/** An engine that cannot be had is told of once, by whoever fetched it. */
const ignored = () => {};

export type Reply = Exclude<FromWorker, never>;

interface Job {
  question: Question;
  done: (reply: Reply) => void;
}

export class Lane {
  private worker: Worker;
  private underWay: (Job & { id: number }) | null = null;
  private waiting: Job | null = null;
  private next = 0;

  /** `mayStop`: a newer question ends the one under way, at the price of a new worker, in place of waiting for it. */
  constructor(
    private readonly engine: Promise<WebAssembly.Module>,
    private readonly files: Map<string, string>,
    private readonly mayStop: boolean,
    private readonly hire: () => Worker,
  ) {
    this.worker = this.begin();
  }

  addFile(file: string, text: string): void {
    this.send({ file, text });
  }

  ask(question: Question, done: (reply: Reply) => void): void {
    this.waiting = { question, done };
    if (this.underWay && this.mayStop) {
      this.worker.terminate();
      this.underWay = null;
      this.worker = this.begin();
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
    this.worker.terminate();
  }

  private begin(): Worker {
    const worker = this.hire();
    worker.addEventListener('message', ({ data }: MessageEvent<FromWorker>) => this.finish(data));
    this.engine.then((engine) => {
      worker.postMessage({ engine } satisfies ToWorker);
      for (const [file, text] of this.files) worker.postMessage({ file, text } satisfies ToWorker);
    }, ignored);
    return worker;
  }

  private start(): void {
    if (!this.waiting) return;
    const job = { ...this.waiting, id: this.next++ };
    this.underWay = job;
    this.waiting = null;
    this.send({ id: job.id, question: job.question });
  }

  private send(message: ToWorker): void {
    const { worker } = this;
    // The engine's own message comes first.
    this.engine.then(() => worker.postMessage(message), ignored);
  }

  private finish(reply: Reply): void {
    if (reply.id !== this.underWay?.id) return;
    const { done } = this.underWay;
    this.underWay = null;
    if ('error' in reply && reply.error.startsWith(STOPPED)) {
      // What is left of an engine that stopped halfway is not to be asked again.
      this.worker.terminate();
      this.worker = this.begin();
    }
    this.start();
    done(reply);
  }
}
