// A chart of curves or dots as an SVG, for a document.
//
// Next door: the same on the screen (`curves`), the forces of the tab Spring (`results/svg`).

import { ticks } from '../results/svg';
import type { Curves } from './curves';
import { look, type Look } from './looks';

const COLOURS: Record<string, string> = { blue: '#005aaa', red: '#c82810', green: '#007d5c', ink: '#000000' };
const MARGIN = { left: 64, right: 14, top: 44, bottom: 46 };

/** `title` stands above, the legend below it. */
export function picture(drawn: Curves, size: { width: number; height: number }): string {
  const { title, x, y, marks = [] } = drawn;
  const times = Array.from(x.values);
  const all = drawn.curves.flatMap(({ values }) => Array.from(values)).filter((value) => value !== null);
  const scale = y.logarithmic ? Math.log10 : (value: number) => value;
  const [left, right] = wider(
    [...times, ...marks.map((mark) => mark.x)],
    drawn.curves.some(({ dots }) => dots),
  );
  const [low, high] = wider(all.map(scale), true);
  const [wide, tall] = [size.width - MARGIN.left - MARGIN.right, size.height - MARGIN.top - MARGIN.bottom];
  const across = (value: number) => (MARGIN.left + ((value - left) / (right - left || 1)) * wide).toFixed(2);
  const up = (value: number) => (MARGIN.top + (1 - (scale(value) - low) / (high - low || 1)) * tall).toFixed(2);
  const levels = y.logarithmic ? decades(low, high) : ticks(low, high);
  const grid = [
    ...ticks(left, right).map(
      (at) =>
        `<path d="M${across(at)} ${MARGIN.top}v${tall}" stroke="#d9dce1"/><text x="${across(at)}" y="${MARGIN.top + tall + 16}" text-anchor="middle">${at}</text>`,
    ),
    ...levels.map(
      (at) =>
        `<path d="M${MARGIN.left} ${up(at)}h${wide}" stroke="#d9dce1"/><text x="${MARGIN.left - 6}" y="${Number(up(at)) + 4}" text-anchor="end">${at}</text>`,
    ),
  ];
  const named = marks.map(
    ({ x: at, label }, index) =>
      `<path d="M${across(at)} ${MARGIN.top}v${tall}" stroke="#555b65" stroke-dasharray="3 3"/><text x="${Number(across(at)) + 4}" y="${MARGIN.top + 12 + 14 * index}" fill="#555b65">${escape(label)}</text>`,
  );
  const legend = drawn.curves.map(
    ({ look: name, label, dots }, index) =>
      sample(name, dots, MARGIN.left + 170 * index) +
      `<text x="${MARGIN.left + 170 * index + 40}" y="36">${escape(label)}</text>`,
  );
  const lines = drawn.curves.map(({ look: name, values, dots }) => {
    const points = times.flatMap((at, index) => {
      const value = values[index];
      return value === null || value === undefined ? [] : [[across(at), up(value)] as const];
    });
    return dots
      ? points.map(([cx, cy]) => disc(name, dots, cx, cy)).join('')
      : `<polyline points="${points.map((point) => point.join()).join(' ')}" fill="none" ${stroke(name)}/>`;
  });
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size.width} ${size.height}" width="${size.width}" height="${size.height}" font-family="sans-serif" font-size="12">`,
    `<rect width="100%" height="100%" fill="#ffffff"/><text x="${MARGIN.left}" y="18" font-weight="bold">${escape(title)}</text>`,
    ...grid,
    ...named,
    ...lines,
    ...legend,
    `<text x="${MARGIN.left + wide / 2}" y="${size.height - 8}" text-anchor="middle">${escape(x.label)}</text>`,
    `<text transform="translate(14 ${MARGIN.top + tall / 2}) rotate(-90)" text-anchor="middle">${escape(y.label)}</text>`,
    '</svg>\n',
  ].join('\n');
}

/** From the least to the most, with some room where dots would be cut. */
function wider(values: number[], room: boolean): [number, number] {
  const low = values.reduce((a, b) => Math.min(a, b), Infinity);
  const high = values.reduce((a, b) => Math.max(a, b), -Infinity);
  const part = room ? 0.05 * (high - low || 1) : 0;
  return [low - part, high + part];
}

/** 1, 2 and 5 of each decade from one power of ten to the other. */
const decades = (low: number, high: number): number[] =>
  Array.from({ length: Math.ceil(high) - Math.floor(low) + 1 }, (_, index) => 10 ** (Math.floor(low) + index))
    .flatMap((power) => [power, 2 * power, 5 * power])
    .map((value) => Number(value.toPrecision(3)))
    .filter((value) => Math.log10(value) >= low && Math.log10(value) <= high);

const colour = (name: string | Look): string => COLOURS[look(name).colour] ?? '#000000';
const stroke = (name: string | Look): string =>
  `stroke="${colour(name)}" stroke-width="${look(name).width}" stroke-dasharray="${look(name).dash.join(' ')}"`;
const disc = (name: string | Look, dots: true | 'hollow', cx: string | number, cy: string | number): string =>
  `<circle cx="${cx}" cy="${cy}" r="4" stroke="${colour(name)}" stroke-width="2" fill="${dots === 'hollow' ? '#ffffff' : colour(name)}"/>`;
const sample = (name: string | Look, dots: boolean | 'hollow' | undefined, at: number): string =>
  dots ? disc(name, dots, at + 20, 32) : `<path d="M${at} 32h34" ${stroke(name)}/>`;

const escape = (text: string): string => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
