// The strip's picture: a row of dots for each time, coloured by the strain of the gap that they are in, axes, and the way of a wave.
//
// Next door: what goes over it and which times it is of (`strip`).

import type { Shown } from '../compute';
import { clamp } from '../dom';
import { font, LARGER } from '../plots/chart';
import { ink } from '../plots/looks';
import { mix, strains, type Sheet } from '../spring/draw';
import { nearest } from '../spring/scene';
import type { Onset } from './act';

/** Where positions and times are in the canvas [CSS pixels]. */
export interface Area {
  left: number;
  top: number;
  width: number;
  height: number;
}

const STEPS = 32;
/** Between ticks at least [pixels]. */
const APART = 34;

/** Draws a page of what is shown; null where there is no room. */
export function paint(
  empty: Sheet | null,
  { frames, answer }: Shown,
  page: [number, number],
  peak: number,
  onset: Onset | null,
): Area | null {
  if (!empty) return null;
  const { context, width, height } = empty;
  const [left, top, right, foot] = [46, 18, 8, 40].map((size) => size * LARGER) as [number, number, number, number];
  const area = { left, top, width: width - left - right, height: height - top - foot };
  if (area.width < 20 || area.height < 20 || frames.times.length === 0) return null;
  dots(empty, area, frames, page, peak);
  axes(context, area, page, 1e3 * answer.facts.meanLength);
  if (onset) ways(context, area, page, onset, answer.facts.spring.transitTime, answer.facts.contact?.first ?? Infinity);
  return area;
}

/** Colours from closer to wider as 32-bit dots, as the coil has them. */
function palette(): Uint32Array {
  return Uint32Array.from({ length: 2 * STEPS + 1 }, (_, step) => {
    const at = step / STEPS - 1;
    const parts = mix(ink.middle, at < 0 ? ink.low : ink.high, Math.abs(at)).match(/\d+/g) ?? [];
    const [red = 0, green = 0, blue = 0] = parts.map(Number);
    return ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0;
  });
}

function dots(
  { context, ratio }: Sheet,
  area: Area,
  { times, positions, columns }: Shown['frames'],
  [from, to]: [number, number],
  peak: number,
): void {
  const [wide, high] = [Math.round(area.width * ratio), Math.round(area.height * ratio)];
  const image = context.createImageData(wide, high);
  const dots = new Uint32Array(image.data.buffer);
  const colours = palette();
  // Half a gap at either end.
  const gaps = Uint32Array.from({ length: wide }, (_, column) => Math.round(((column + 0.5) / wide) * (columns - 2)));
  let drawn = -1;
  for (let row = 0; row < high; row++) {
    const time = from + ((row + 0.5) / high) * (to - from);
    if (time > (times[times.length - 1] ?? 0) + (to - from) / high) break;
    const frame = nearest(times, time);
    const start = row * wide;
    if (frame === drawn) {
      dots.copyWithin(start, start - wide, start);
      continue;
    }
    drawn = frame;
    const strain = strains(positions.subarray(frame * columns, (frame + 1) * columns));
    const shades = Uint32Array.from(strain, (value) => {
      const part = peak > 0 ? clamp(value / peak, -1, 1) : 0;
      return colours[Math.round((part + 1) * STEPS)] ?? 0;
    });
    for (let column = 0; column < wide; column++) dots[start + column] = shades[gaps[column] ?? 0] ?? 0;
  }
  context.putImageData(image, Math.round(area.left * ratio), Math.round(area.top * ratio));
}

/** Round steps, so that ticks are not too close. */
function ticks(from: number, to: number, pixels: number): number[] {
  const room = ((to - from) * APART * LARGER) / pixels;
  const power = 10 ** Math.floor(Math.log10(room));
  const step = power * ([1, 2, 5, 10].find((one) => one * power >= room) ?? 10);
  const first = Math.ceil(from / step - 1e-9);
  return Array.from({ length: Math.floor(to / step + 1e-9) - first + 1 }, (_, number) => (first + number) * step);
}

function axes(context: CanvasRenderingContext2D, area: Area, page: [number, number], length: number): void {
  const { left, top, width, height } = area;
  const [bottom, tick] = [top + height, 4 * LARGER];
  context.strokeStyle = context.fillStyle = ink.soft;
  context.lineWidth = 1;
  context.font = font(11);
  context.strokeRect(left - 0.5, top - 0.5, width + 1, height + 1);
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  const written = (value: number) => String(Number(value.toPrecision(6)));
  for (const at of ticks(1e3 * page[0], 1e3 * page[1], height)) {
    const y = top + (height * (at - 1e3 * page[0])) / (1e3 * (page[1] - page[0]));
    context.fillRect(left - tick, y - 0.5, tick, 1);
    context.fillText(written(at), left - tick - 2, y);
  }
  context.textBaseline = 'top';
  for (const at of ticks(0, length, width)) {
    const x = left + (width * at) / length;
    context.fillRect(x - 0.5, bottom, 1, tick);
    context.textAlign = x > left + width - 8 ? 'right' : 'center';
    context.fillText(written(at), Math.min(x, left + width + 6), bottom + tick + 1);
  }
  context.textAlign = 'center';
  context.textBaseline = 'bottom';
  context.fillText('Position [mm]', left + width / 2, bottom + 36 * LARGER);
  context.save();
  context.translate(11 * LARGER, top + height / 2);
  context.rotate(-Math.PI / 2);
  context.textBaseline = 'middle';
  context.fillText('Time [ms]', 0, 0);
  context.restore();
  context.textBaseline = 'bottom';
  context.textAlign = 'left';
  context.fillStyle = ink.blue;
  context.fillText('End 1', left, top - 3);
  context.textAlign = 'right';
  context.fillStyle = ink.red;
  context.fillText('End 2', left + width, top - 3);
}

/** Dashed: to the far end and back, again and again, as fast as a wave; where windings meet, it is another one from then on. */
function ways(
  context: CanvasRenderingContext2D,
  { left, top, width, height }: Area,
  [from, to]: [number, number],
  { time, end }: Onset,
  oneWay: number,
  until: number,
): void {
  const y = (at: number) => top + (height * (at - from)) / (to - from);
  const near = end === 1 ? left : left + width;
  const far = end === 1 ? left + width : left;
  context.save();
  context.beginPath();
  context.rect(left, top, width, height);
  context.clip();
  context.beginPath();
  const last = Math.min(to, until);
  for (let turn = Math.max(0, Math.floor((from - time) / oneWay)); time + turn * oneWay < last; turn++) {
    const [out, back] = turn % 2 ? [far, near] : [near, far];
    const part = Math.min(1, (until - time) / oneWay - turn);
    context.moveTo(out, y(time + turn * oneWay));
    context.lineTo(out + part * (back - out), y(time + (turn + part) * oneWay));
  }
  // Dark between two pale edges: seen on every colour of the strip.
  context.lineWidth = 5 * LARGER;
  context.strokeStyle = ink.card;
  context.stroke();
  context.setLineDash([7 * LARGER, 4 * LARGER]);
  context.lineWidth = 2 * LARGER;
  context.strokeStyle = ink.ink;
  context.stroke();
  context.restore();
}
