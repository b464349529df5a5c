// A job for the larger engine, which is loaded with the first of them: one worker a job, ended with its answer or by the user.
//
// Next door: the worker (`job.worker`), the engine of the first load (`lane`), how a worker's end is noticed (`alive`).

import { watch, type Alive } from '../alive';
import type { FromWorker, Job, Told, ToWorkshop } from '../answer';
import { again, say } from '../faults';
import { workshop } from '../workshop';

type TellDone = (done: number, of: number, file?: string) => void;

export function begin(
  job: Job,
  files: Map<string, string>,
  told: TellDone,
): { reply: Promise<FromWorker>; cancel: () => void } {
  let worker: Worker | null = null;
  let isOver = false;
  const cancel = () => {
    isOver = true;
    worker?.terminate();
  };
  /** One try; nothing where the worker ended. */
  const once = (engine: WebAssembly.Module) =>
    new Promise<FromWorker | null>((resolve) => {
      worker = new Worker(new URL('./job.worker.ts', import.meta.url), { type: 'module' });
      watch(worker, () => !isOver && resolve(null));
      worker.addEventListener('message', ({ data }: MessageEvent<FromWorker | Told | Alive>) => {
        if ('told' in data) return told(...data.told);
        if ('id' in data) resolve(data);
      });
      told(0, 0);
      worker.postMessage({ engine, files, job } satisfies ToWorkshop);
    });
  const run = async (): Promise<FromWorker> => {
    for (let ended = 1; ; ended++) {
      const engine = await workshop();
      // Nobody hears what was cancelled.
      if (isOver) return new Promise(() => {});
      const reply = await once(engine);
      worker?.terminate();
      if (reply) return reply;
      if (ended % 2 === 1) say('job', 'The computation had stopped and was restarted.');
      else
        await again(
          'job',
          'The worker of this question ends without an answer: its file is missing or came cut short, or memory is short. What you gave it is still here.',
        );
    }
  };
  return { reply: run(), cancel };
}
