// The worker of one job: the larger engine, one answer, and on the way how much is done. Files are read by the engine as it parses them.
//
// Next door: who asks (`job`).

import { live } from '../alive';
import {
  STOPPED,
  type Answer,
  type FromWorker,
  type Job,
  type Log,
  type Series,
  type Told,
  type ToWorkshop,
} from '../answer';
import { Engine, LogFile, initSync, type Answer as Found } from '../workshop/coilsense_web';

/** Reads at once, which only workers may; the page's types know none of it. */
declare const FileReaderSync: new () => { readAsArrayBuffer(blob: Blob): ArrayBuffer };

/** The files of the question, by the number under which the engine asks for them. */
let logs: Log[] = [];

/** The next bytes of a file; −1 where it cannot be read: a folder, or one that was moved or changed since. */
function read(number: number, from: number, buffer: Uint8Array): number {
  const log = logs[number];
  try {
    if (!log) return -1;
    const piece = new FileReaderSync().readAsArrayBuffer(log.file.slice(from, from + buffer.length));
    buffer.set(new Uint8Array(piece));
    postMessage({ told: [from + piece.byteLength, log.file.size, log.name] } satisfies Told);
    return piece.byteLength;
  } catch {
    return -1;
  }
}

/** The engine calls them while it works and while it reads. */
Object.assign(globalThis, {
  coilsenseTold: (done: number, of: number) => postMessage({ told: [done, of] } satisfies Told),
  coilsenseRead: read,
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

/** A file for the engine, which asks for its bytes when it wants them. */
function opened(log: Log): LogFile {
  logs.push(log);
  return new LogFile(log.name, logs.length - 1, log.file.size);
}

function asked(engine: Engine, job: Job): Found {
  logs = [];
  switch (job.kind) {
    case 'columns':
      return engine.log_columns(opened(job.log), job.asked);
    case 'identify':
      return engine.identify(opened(job.log), job.second ? opened(job.second) : undefined, job.asked);
    case 'calibrate':
      return engine.calibrate(opened(job.log), job.asked);
    case 'trial':
      return engine.trial_log(job.text, job.condition, job.damping);
    case 'mitigate':
      return engine.mitigate(job.text, job.asked);
    case 'mitigate-log':
      return engine.mitigate_log(job.text, job.asked, opened(job.log));
    case 'mitigate-usual':
      return engine.mitigate_usual(job.text, job.asked);
  }
}
