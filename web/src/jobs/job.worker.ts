// The worker of one job: the larger engine, one answer, and on the way how much is done.
//
// Next door: who asks (`job`).

import { live } from '../alive';
import { STOPPED, type Answer, type FromWorker, type Job, type Series, type Told, type ToWorkshop } from '../answer';
import { Engine, initSync, type Answer as Found } from '../workshop/coilsense_web';

/** The engine calls it while it works. */
Object.assign(globalThis, {
  coilsenseTold: (done: number, of: number) => postMessage({ told: [done, of] } satisfies Told),
});

live();

addEventListener('message', ({ data: { engine, files, job } }: MessageEvent<ToWorkshop>) => {
  const begun = performance.now();
  const say = (message: { answer: Answer<unknown> } | { error: string }) =>
    postMessage({ id: 0, milliseconds: performance.now() - begun, ...message } satisfies FromWorker);
  try {
    initSync({ module: engine });
    const made = new Engine();
    for (const [file, text] of files) made.add_file(file, text);
    const found = asked(made, job);
    const series: Series = {};
    found.names().forEach((name, number) => (series[name] = found.take(number)));
    say({ answer: { facts: JSON.parse(found.meta()) as unknown, series, positions: new Float32Array() } });
  } catch (reason) {
    say({ error: typeof reason === 'string' ? reason : `${STOPPED}${reason}` });
  }
});

function asked(engine: Engine, job: Job): Found {
  switch (job.kind) {
    case 'columns':
      return engine.log_columns(job.log.name, job.log.bytes, job.asked);
    case 'identify':
      return engine.identify(job.log.name, job.log.bytes, job.second?.name ?? '', job.second?.bytes, job.asked);
    case 'calibrate':
      return engine.calibrate(job.log.name, job.log.bytes, job.asked);
    case 'trial':
      return engine.trial_log(job.text, job.condition, job.damping);
    case 'mitigate':
      return engine.mitigate(job.text, job.asked);
    case 'mitigate-log':
      return engine.mitigate_log(job.text, job.asked, job.name, job.bytes);
    case 'mitigate-usual':
      return engine.mitigate_usual(job.text, job.asked);
  }
}
