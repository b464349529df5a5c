// What is taken along, made when it is asked for: the spec, the series, the picture of the forces.
//
// Next door: who asks (`downloads`), how the picture is drawn (`svg`).

import type { Compute, Shown } from '../compute';
import { toToml } from '../document';
import { download } from '../download';
import { FORCE_LINES, readings } from '../plots/lines';
import { preset } from '../presets';
import type { State } from '../state';
import { forcesSvg } from './svg';

/** For a file: the spring and what is done to it. */
function name(shown: Shown | null): string {
  const { facts } = shown?.answer ?? {};
  const words = [facts?.spring.name ?? 'spring', facts?.conditions[facts.condition]?.name ?? ''];
  return words.join('-').replaceAll(/[^\w.-]+/g, '-');
}

export function takeSpec(state: State, shown: Shown | null): void {
  const { files, example } = preset(state.preset);
  const beside = Object.keys(files).map((file) => `# needs ${file} beside it, from examples/ of coilsense\n`);
  const heading = `# Made on the page of coilsense, from examples/${example}.toml\n${beside.join('')}\n`;
  download(`${name(shown)}.toml`, heading + toToml(state.spec).text, 'application/toml');
}

export async function takeSeries(state: State, shown: Shown | null, compute: Compute): Promise<void> {
  const { text, condition, damping } = compute.question(state);
  const reply = await compute.ask({ kind: 'csv', text, condition, damping });
  if ('bytes' in reply) download(`${name(shown)}.csv`, reply.bytes, 'text/csv');
}

export function takePicture({ view }: State, shown: Shown | null, size: { width: number; height: number }): void {
  if (!shown) return;
  const { answer, exact, times } = shown;
  const forces = FORCE_LINES.filter((line) => !view.hidden.includes(line.name));
  const lines = [...forces, ...readings(exact?.facts ?? null, view.sensors)];
  download(`${name(shown)}.svg`, forcesSvg(answer, times, lines, size), 'image/svg+xml');
}
