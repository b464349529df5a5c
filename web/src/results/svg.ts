// The forces over the shown times as an SVG, in the paper's line styles, for a document.

import type { Answer, Facts } from '../answer';
import { PALE, WIDER } from '../compare/held';
import type { Line } from '../plots/lines';
import { look } from '../plots/looks';

const COLOURS: Record<string, string> = {
  blue: '#005aaa',
  red: '#c82810',
  green: '#007d5c',
  ink: '#000000',
  orange: '#b25a00',
  purple: '#7a3fb0',
  teal: '#00808c',
  pink: '#c2267a',
  olive: '#6b6f00',
  brown: '#7d4e2d',
};
/** What is kept to compare: its curves, which of them are drawn, and what they are of. */
export interface Kept {
  answer: Answer<Facts>;
  lines: readonly Line[];
  words: string;
}

const MARGIN = { left: 64, right: 12, top: 30, bottom: 44 };

type Scale = (value: number) => number;

/** Times and forces of some lines between two times. */
function between({ series }: Answer<Facts>, lines: readonly Line[], [from, to]: [number, number]) {
  const time = series['time'] ?? new Float64Array();
  const first = Math.max(
    0,
    time.findIndex((t) => t >= from),
  );
  const past = time.findIndex((t) => t > to);
  const count = past < 0 ? time.length : past;
  const values = lines.map((line) => (series[line.series] ?? new Float64Array()).subarray(first, count));
  return { lines, time: time.subarray(first, count), values };
}

/** The curves; `wider` and `opacity` as of what is kept. */
function traced(
  { lines, time, values }: ReturnType<typeof between>,
  x: Scale,
  y: Scale,
  wider = 1,
  opacity = 1,
): string[] {
  return lines.map((line, index) => {
    const { colour, dash, width } = look(line.series);
    const points = [...(values[index] ?? [])]
      .map((force, at) => `${x(time[at] ?? 0).toFixed(2)},${y(force).toFixed(2)}`)
      .join(' ');
    const pale = opacity < 1 ? ` opacity="${opacity}"` : '';
    return `<polyline points="${points}" fill="none" stroke="${COLOURS[colour]}" stroke-width="${wider * width}" stroke-dasharray="${dash.join(' ')}"${pale}/>`;
  });
}

/** What is named above the curves: each line, then what is kept. */
function legendOf(lines: readonly Line[], kept: Kept | null): string[] {
  let next = MARGIN.left;
  const named = lines.map(({ series, name }) => {
    const { colour, dash, width } = look(series);
    const at = next;
    // Some 7 dots a letter, and room between.
    next += 58 + 7 * name.length;
    return `<path d="M${at} 14h34" stroke="${COLOURS[colour]}" stroke-width="${width}" stroke-dasharray="${dash.join(' ')}"/><text x="${at + 40}" y="18">${escape(name)}</text>`;
  });
  if (!kept) return named;
  const words = `<text x="${MARGIN.left + 40}" y="34">${escape(`kept: ${kept.words}`)}</text>`;
  return [
    ...named,
    `<path d="M${MARGIN.left} 30h34" stroke="#000000" stroke-width="${1.4 * WIDER}" opacity="${PALE}"/>${words}`,
  ];
}

export function forcesSvg(
  answer: Answer<Facts>,
  times: [number, number],
  lines: readonly Line[],
  size: { width: number; height: number },
  kept: Kept | null = null,
): string {
  const { facts } = answer;
  const [from, to] = times;
  const now = between(answer, lines, times);
  const then = kept && between(kept.answer, kept.lines, times);
  const all = [...now.values, ...(then?.values ?? [])];
  const low = Math.min(...all.map((one) => one.reduce((a, b) => Math.min(a, b), Infinity)));
  const high = Math.max(...all.map((one) => one.reduce((a, b) => Math.max(a, b), -Infinity)));
  // A second line of the legend where something is kept.
  const top = MARGIN.top + (kept ? 16 : 0);
  const [wide, tall] = [size.width - MARGIN.left - MARGIN.right, size.height - top - MARGIN.bottom];
  const x = (t: number) => MARGIN.left + ((t - from) / (to - from)) * wide;
  const y = (force: number) => top + (1 - (force - low) / (high - low || 1)) * tall;
  const tick = (at: number, text: string, anchor: string, dx: number, dy: number, line: string) =>
    `${line}<text x="${at + dx}" y="${dy}" text-anchor="${anchor}">${text}</text>`;
  const across = ticks(1e3 * from, 1e3 * to).map((ms) => {
    const at = x(ms / 1e3);
    return tick(
      at,
      String(ms),
      'middle',
      0,
      top + tall + 16,
      `<path d="M${at.toFixed(2)} ${top}v${tall}" stroke="#d9dce1"/>`,
    );
  });
  const up = ticks(low, high).map((force) => {
    const at = y(force);
    return tick(
      MARGIN.left - 6,
      String(force),
      'end',
      0,
      at + 4,
      `<path d="M${MARGIN.left} ${at.toFixed(2)}h${wide}" stroke="#d9dce1"/>`,
    );
  });
  const title = escape(
    `${facts.spring.name}, ${facts.conditions[facts.condition]?.name ?? ''}, ${facts.dampings[facts.damping]?.label ?? ''}`,
  );
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size.width} ${size.height}" width="${size.width}" height="${size.height}" font-family="sans-serif" font-size="12">`,
    `<title>${title}</title><rect width="100%" height="100%" fill="#ffffff"/>`,
    ...across,
    ...up,
    ...(then ? traced(then, x, y, WIDER, PALE) : []),
    ...traced(now, x, y),
    ...legendOf(lines, kept),
    `<text x="${MARGIN.left + wide}" y="18" text-anchor="end">${title}</text>`,
    `<text x="${MARGIN.left + wide / 2}" y="${size.height - 8}" text-anchor="middle">Time [ms]</text>`,
    `<text transform="translate(14 ${top + tall / 2}) rotate(-90)" text-anchor="middle">Force [N]</text>`,
    '</svg>\n',
  ].join('\n');
}

/** Round numbers from one to the other, some five of them. */
export function ticks(low: number, high: number): number[] {
  const room = (high - low) / 5 || 1;
  const power = 10 ** Math.floor(Math.log10(room));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= room) ?? 10);
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, index) =>
    Number(((first + index) * step).toPrecision(12)),
  );
}

const escape = (text: string): string => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
