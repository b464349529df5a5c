// The forces over the shown times as an SVG, in the paper's line styles, for a document.

import type { Answer, Facts } from '../answer';
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
const MARGIN = { left: 64, right: 12, top: 30, bottom: 44 };

export function forcesSvg(
  answer: Answer<Facts>,
  [from, to]: [number, number],
  lines: readonly Line[],
  size: { width: number; height: number },
): string {
  const { facts, series } = answer;
  const time = series['time'] ?? new Float64Array();
  const first = Math.max(
    0,
    time.findIndex((t) => t >= from),
  );
  const past = time.findIndex((t) => t > to);
  const count = past < 0 ? time.length : past;
  const values = lines.map((line) => (series[line.series] ?? new Float64Array()).subarray(first, count));
  const low = Math.min(...values.map((all) => all.reduce((a, b) => Math.min(a, b), Infinity)));
  const high = Math.max(...values.map((all) => all.reduce((a, b) => Math.max(a, b), -Infinity)));
  const [wide, tall] = [size.width - MARGIN.left - MARGIN.right, size.height - MARGIN.top - MARGIN.bottom];
  const x = (t: number) => MARGIN.left + ((t - from) / (to - from)) * wide;
  const y = (force: number) => MARGIN.top + (1 - (force - low) / (high - low || 1)) * tall;
  const tick = (at: number, text: string, anchor: string, dx: number, dy: number, line: string) =>
    `${line}<text x="${at + dx}" y="${dy}" text-anchor="${anchor}">${text}</text>`;
  const across = ticks(1e3 * from, 1e3 * to).map((ms) => {
    const at = x(ms / 1e3);
    return tick(
      at,
      String(ms),
      'middle',
      0,
      MARGIN.top + tall + 16,
      `<path d="M${at.toFixed(2)} ${MARGIN.top}v${tall}" stroke="#d9dce1"/>`,
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
  const curves = lines.map((line, index) => {
    const { colour, dash, width } = look(line.series);
    const points = [...(values[index] ?? [])]
      .map((force, at) => `${x(time[first + at] ?? 0).toFixed(2)},${y(force).toFixed(2)}`)
      .join(' ');
    return `<polyline points="${points}" fill="none" stroke="${COLOURS[colour]}" stroke-width="${width}" stroke-dasharray="${dash.join(' ')}"/>`;
  });
  let next = MARGIN.left;
  const legend = lines.map(({ series, name }) => {
    const { colour, dash, width } = look(series);
    const at = next;
    // Some 7 dots a letter, and room between.
    next += 58 + 7 * name.length;
    return `<path d="M${at} 14h34" stroke="${COLOURS[colour]}" stroke-width="${width}" stroke-dasharray="${dash.join(' ')}"/><text x="${at + 40}" y="18">${escape(name)}</text>`;
  });
  const title = escape(
    `${facts.spring.name}, ${facts.conditions[facts.condition]?.name ?? ''}, ${facts.dampings[facts.damping]?.label ?? ''}`,
  );
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size.width} ${size.height}" width="${size.width}" height="${size.height}" font-family="sans-serif" font-size="12">`,
    `<title>${title}</title><rect width="100%" height="100%" fill="#ffffff"/>`,
    ...across,
    ...up,
    ...curves,
    ...legend,
    `<text x="${MARGIN.left + wide}" y="18" text-anchor="end">${title}</text>`,
    `<text x="${MARGIN.left + wide / 2}" y="${size.height - 8}" text-anchor="middle">Time [ms]</text>`,
    `<text transform="translate(14 ${MARGIN.top + tall / 2}) rotate(-90)" text-anchor="middle">Force [N]</text>`,
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
