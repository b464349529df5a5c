// What becomes of a wish to take something along: the spec as a file, the series as the command writes them, the picture of the forces.
//
// Next door: the buttons, which load this (`downloads`), the picture (`svg`).

import type { Compute, Shown } from '../compute';
import { heldNow, keptLines } from '../compare/held';
import { toToml } from '../document';
import { download, nameOf } from '../download';
import { say } from '../faults';
import { FORCE_LINES, readings } from '../plots/lines';
import { preset } from '../presets';
import type { State } from '../state';
import { forcesSvg } from './svg';

export function takeSpec(state: State, shown: Shown | null): void {
  const { files, example } = preset(state.preset);
  const beside = Object.keys(files).map((file) => `# needs ${file} beside it, from examples/ of coilsense\n`);
  const heading = `# Made on the page of coilsense, from examples/${example}.toml\n${beside.join('')}\n`;
  download(`${nameOf(shown)}.toml`, heading + toToml(state.spec).text, 'application/toml');
}

export async function takeSeries(state: State, shown: Shown | null, compute: Compute): Promise<void> {
  const { text, condition, damping } = compute.question(state);
  const reply = await compute.ask({ kind: 'csv', text, condition, damping });
  if ('bytes' in reply) download(`${nameOf(shown)}.csv`, reply.bytes, 'text/csv');
  else if ('error' in reply) say('csv', `There are no series to take along: ${reply.error.replace(/^spec:\d+: /, '')}`);
}

export function takePicture({ view }: State, shown: Shown | null, size: { width: number; height: number }): void {
  if (!shown) return say('svg', 'There is no picture to take along yet.');
  const forces = FORCE_LINES.filter(({ name }) => !view.hidden.includes(name));
  const lines = [...forces, ...readings(shown.exact?.facts ?? null, view.sensors)];
  // The picture is what is seen: what is kept is behind it, and said to be there.
  const held = heldNow();
  const kept = held && { ...held, lines: keptLines(view) };
  download(`${nameOf(shown)}.svg`, forcesSvg(shown.answer, shown.times, lines, size, kept), 'image/svg+xml');
}
