// The worker: holds the engine, answers one question after the other. Arrays are handed over, not copied.
//
// Next door: who asks and drops what is out of date (`compute`).

import { STOPPED, type Answer, type FromWorker, type Question, type Series, type ToWorker } from './answer';
import init, { Engine, type Answer as Found } from './engine/coilsense_web';

const ready: { engine: Promise<Engine> } & { open: (engine: Promise<Engine>) => void } = (() => {
  let open: (engine: Promise<Engine>) => void = () => {};
  const engine = new Promise<Engine>((resolve) => (open = resolve));
  return { engine, open };
})();

addEventListener('message', async ({ data }: MessageEvent<ToWorker>) => {
  if ('engine' in data) return ready.open(init({ module_or_path: data.engine }).then(() => new Engine()));
  const engine = await ready.engine;
  if ('file' in data) return engine.add_file(data.file, data.text);
  const begun = performance.now();
  const say = (message: FromWorker, hand: Transferable[]) => postMessage(message, { transfer: hand });
  try {
    const { question, id } = data;
    if (question.kind === 'csv') {
      const bytes = engine.csv(question.text, question.condition, question.damping) as Uint8Array<ArrayBuffer>;
      return say({ id, milliseconds: performance.now() - begun, bytes }, [bytes.buffer]);
    }
    if (question.kind === 'catalogue')
      return say({ id, milliseconds: performance.now() - begun, text: engine.catalogue() }, []);
    const answer = opened(asked(engine, question));
    const hand = [
      ...Object.values(answer.series).map((values) => values.buffer as ArrayBuffer),
      answer.positions.buffer as ArrayBuffer,
    ];
    say({ id, milliseconds: performance.now() - begun, answer }, hand);
  } catch (reason) {
    say(
      {
        id: data.id,
        milliseconds: performance.now() - begun,
        error: typeof reason === 'string' ? reason : `${STOPPED}${reason}`,
      },
      [],
    );
  }
});

function asked(engine: Engine, question: Exclude<Question, { kind: 'csv' | 'catalogue' }>): Found {
  switch (question.kind) {
    case 'preview':
      return engine.preview(
        question.text,
        question.condition,
        question.damping,
        question.from,
        question.to,
        question.samples,
      );
    case 'exact':
      return engine.exact(question.text, question.condition, question.damping);
    case 'modes':
      return engine.modes(question.text, question.lengths);
    case 'shape':
      return engine.mode_shape(question.text, question.length, question.loosest, question.number, question.points);
    case 'paper':
      return engine.paper();
  }
}

function opened(found: Found): Answer<unknown> {
  const series: Series = {};
  found.names().forEach((name, number) => (series[name] = found.take(number)));
  const answer = { facts: JSON.parse(found.meta()) as unknown, series, positions: found.take_positions() };
  found.free();
  return answer;
}
