// What a worker does with its engine: answers one question after the other. Arrays are handed over, not copied.
//
// Next door: the workers of the two engines (`engine.worker`, `meeting.worker`), who asks and drops what is out of date (`lane`).

import { live } from './alive';
import { STOPPED, type Answer, type FromWorker, type Question, type Series, type ToWorker } from './answer';
import type { Engine, Answer as Found } from './engine/coilsense_web';

/** What an engine answers that not every one does; null where it is not asked that. */
type More<E> = (engine: E, question: Question) => Found | null;

/** Answers from now on; `begin` makes an engine of what comes first. */
export function serve<E extends Engine>(begin: (engine: WebAssembly.Module) => E, more: More<E> = () => null): void {
  live();
  let open: (engine: E) => void = () => {};
  const ready = new Promise<E>((resolve) => (open = resolve));
  addEventListener('message', async ({ data }: MessageEvent<ToWorker>) => {
    if ('engine' in data) return open(begin(data.engine));
    const engine = await ready;
    if ('file' in data) return engine.add_file(data.file, data.text);
    reply(engine, data, more);
  });
}

function reply<E extends Engine>(engine: E, { id, question }: { id: number; question: Question }, more: More<E>): void {
  const begun = performance.now();
  const say = (message: FromWorker, hand: Transferable[]) => postMessage(message, { transfer: hand });
  try {
    if (question.kind === 'csv') {
      const bytes = engine.csv(question.text, question.condition, question.damping) as Uint8Array<ArrayBuffer>;
      return say({ id, milliseconds: performance.now() - begun, bytes }, [bytes.buffer]);
    }
    if (question.kind === 'catalogue')
      return say({ id, milliseconds: performance.now() - begun, text: engine.catalogue() }, []);
    const answer = opened(more(engine, question) ?? asked(engine, question));
    const hand = [
      ...Object.values(answer.series).map((values) => values.buffer as ArrayBuffer),
      answer.positions.buffer as ArrayBuffer,
    ];
    say({ id, milliseconds: performance.now() - begun, answer }, hand);
  } catch (reason) {
    const error = typeof reason === 'string' ? reason : `${STOPPED}${reason}`;
    say({ id, milliseconds: performance.now() - begun, error }, []);
  }
}

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
    default:
      throw `${question.kind} is for the larger engine`;
  }
}

function opened(found: Found): Answer<unknown> {
  const series: Series = {};
  found.names().forEach((name, number) => (series[name] = found.take(number)));
  const answer = { facts: JSON.parse(found.meta()) as unknown, series, positions: found.take_positions() };
  found.free();
  return answer;
}
