// The larger engine, loaded once: with the first log, the first study, or the first windings that meet.
//
// Next door: what is asked of it (`jobs/job`, `compute`), the engine of the first load (`compute`).

import address from './workshop/coilsense_web_bg.wasm?url';

let engine: Promise<WebAssembly.Module> | null = null;

/** The compiled engine; one that could not be had is fetched anew by the next who asks. */
export function workshop(): Promise<WebAssembly.Module> {
  engine ??= WebAssembly.compileStreaming(fetch(address));
  engine.catch(() => (engine = null));
  return engine;
}
