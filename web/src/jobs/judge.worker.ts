// The worker that judges: the larger engine, for as long as the page is open. Between two cases it hears of a newer spec and leaves the one that it
// was at; what a change of the spec leaves as it was it does not compute again.
//
// Next door: who asks (`judging`), workers of one job each (`job.worker`).

import { live } from '../alive';
import { STOPPED, type FromJudge, type ToJudge } from '../answer';
import { Engine, initSync, Judge } from '../workshop/coilsense_web';

let newest = 0;
let begun: { engine: Engine; judge: Judge } | null = null;

live();

addEventListener('message', ({ data }: MessageEvent<ToJudge>) => {
  newest = data.id;
  if ('text' in data) void answer(data);
});

/** A turn of the loop, in which what has come is heard. */
const turn = (() => {
  const { port1, port2 } = new MessageChannel();
  let go = () => {};
  port1.onmessage = () => go();
  return () =>
    new Promise<void>((resolve) => {
      go = resolve;
      port2.postMessage(null);
    });
})();

function begin(module: WebAssembly.Module): { engine: Engine; judge: Judge } {
  initSync({ module });
  return { engine: new Engine(), judge: new Judge() };
}

async function answer({ id, engine: module, files, text }: Extract<ToJudge, { text: string }>): Promise<void> {
  const say = (message: FromJudge) => postMessage(message);
  try {
    const { engine, judge } = (begun ??= begin(module));
    for (const [file, content] of files) engine.add_file(file, content);
    const of = judge.begin(engine, text);
    for (let done = 0; done < of; done = judge.step()) {
      say({ id, told: [done, of] });
      await turn();
      if (id !== newest) return;
    }
    say({ id, told: [of, of] });
    const found = judge.conclude();
    const facts = JSON.parse(found.meta()) as unknown;
    found.free();
    say({ id, facts });
  } catch (reason) {
    say({ id, error: typeof reason === 'string' ? reason : `${STOPPED}${reason}` });
  }
}
