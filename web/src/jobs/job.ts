// A job for the larger engine, which is loaded with the first of them: one worker a job, ended with its answer or by the user.
//
// Next door: the worker (`job.worker`), the engine of the first load (`lane`).

import type { FromWorker, Job, Told, ToWorkshop } from '../answer';
import { workshop } from '../workshop';

export function begin(
  job: Job,
  files: Map<string, string>,
  told: (done: number, of: number) => void,
): { reply: Promise<FromWorker>; cancel: () => void } {
  const worker = new Worker(new URL('./job.worker.ts', import.meta.url), { type: 'module' });
  const reply = new Promise<FromWorker>((resolve) => {
    worker.addEventListener('message', ({ data }: MessageEvent<FromWorker | Told>) => {
      if ('told' in data) return told(...data.told);
      worker.terminate();
      resolve(data);
    });
  });
  void workshop().then((engine) => worker.postMessage({ engine, files, job } satisfies ToWorkshop));
  return { reply, cancel: () => worker.terminate() };
}
