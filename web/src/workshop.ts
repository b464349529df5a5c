// The larger engine, loaded once: with the first log, the first study, or the first windings that meet.
//
// Next door: what is asked of it (`jobs/job`, `compute`), the engine of the first load (`compute`).

import { persistently } from './faults';
import { compiled } from './fetched';
import address from './workshop/coilsense_web_bg.wasm?url';

let engine: Promise<WebAssembly.Module> | null = null;

/** The compiled engine, once it could be had. */
export function workshop(): Promise<WebAssembly.Module> {
  return (engine ??= persistently('The larger engine', (isAgain) => compiled(address, isAgain)));
}
