// The spring on a canvas: its ends true to scale, its windings off the straight line by a factor, coloured by local strain; where windings
// touch or lie on each other, marked; the force at each end as an arrow.
//
// Next door: its ends (`walls`), which windings lie on each other (`closed`), when it is drawn, and how fast time runs (`player`).

import { clamp } from '../dom';
import { LARGER } from '../plots/chart';
import { ink } from '../plots/looks';
import type { Closed } from './closed';
import type { Coil, Scene } from './scene';
import { drawEnds, drawRuler } from './walls';

/** What is drawn at one moment. */
export interface Moment extends Scene {
  /** u1, x_1…x_N, u2 [m]. */
  positions: Float32Array;
  spring: Coil;
  /** Forces at the ends [N]. */
  forces: [number, number];
  /** What lies on what, where windings were asked to meet; else those count that would overlap. */
  closed: Closed | null;
}

export interface Plan {
  drawn: Float64Array;
  strain: Float64Array;
  touching: Uint8Array;
  /** Whether what touches lies on each other, and does not only overlap. */
  isHeld: boolean;
  margin: number;
  scale: number;
  radius: number;
  middle: number;
  wire: number;
}

const COLOUR_STEPS = 24;
let palette: string[] = [];
let paletteOf = '';

/** Strain as a colour: `part` from −1 (closer) to 1 (wider). */
function shade(part: number): string {
  const key = ink.low + ink.middle + ink.high;
  if (key !== paletteOf) {
    paletteOf = key;
    palette = Array.from({ length: 2 * COLOUR_STEPS + 1 }, (_, step) => {
      const at = step / COLOUR_STEPS - 1;
      return mix(ink.middle, at < 0 ? ink.low : ink.high, Math.abs(at));
    });
  }
  return palette[Math.round((clamp(part, -1, 1) + 1) * COLOUR_STEPS)] ?? ink.middle;
}

/** A colour between two, each written `#rrggbb`. */
export function mix(from: string, to: string, part: number): string {
  const read = (text: string) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));
  const [a, b] = [read(from), read(to)];
  return `rgb(${a.map((value, index) => Math.round(value + part * ((b[index] ?? value) - value))).join(',')})`;
}

/** Local strain of each gap between windings and of both half gaps at the ends [1]. */
export function strains(positions: Float32Array): Float64Array {
  const count = positions.length - 2;
  const mean = ((positions[count + 1] ?? 0) - (positions[0] ?? 0)) / count;
  return Float64Array.from({ length: count + 1 }, (_, gap) => {
    const usual = gap === 0 || gap === count ? 0.5 * mean : mean;
    return ((positions[gap + 1] ?? 0) - (positions[gap] ?? 0)) / usual - 1;
  });
}

/** What is drawn on, of a size in CSS pixels, with so many dots to each. */
export interface Sheet {
  context: CanvasRenderingContext2D;
  width: number;
  height: number;
  ratio: number;
}

/** A canvas without a picture, at the screen's own dots; null where it is not shown. */
export const emptied = (canvas: HTMLCanvasElement): Sheet | null =>
  sheet(canvas, canvas.clientWidth, canvas.clientHeight, devicePixelRatio || 1);

/** A canvas without a picture, of a size; null where it has none. */
export function sheet(canvas: HTMLCanvasElement, width: number, height: number, ratio: number): Sheet | null {
  const context = canvas.getContext('2d');
  if (!context || width === 0) return null;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return { context, width, height, ratio };
}

export function drawSpring(empty: Sheet | null, moment: Moment): void {
  if (!empty) return;
  const { context, width, height } = empty;
  const plan = layOut(moment, width, height);
  drawCoil(context, plan, moment.peak);
  drawEnds(context, plan, moment);
  drawRuler(context, plan, height);
}

/** Where a canvas of a width has the ends [pixels, and of them to a metre]. */
export function ruled(
  { left, right }: Pick<Scene, 'left' | 'right'>,
  width: number,
): { margin: number; scale: number } {
  const margin = clamp(0.09 * width, 44, 110);
  return { margin, scale: (width - 2 * margin) / (right - left) };
}

function layOut({ positions, spring, closed, left, right, gain }: Moment, width: number, height: number): Plan {
  const { margin, scale } = ruled({ left, right }, width);
  const count = positions.length - 2;
  const [first, last] = [positions[0] ?? 0, positions[count + 1] ?? 0];
  const place = (position: number) => margin + (position - left) * scale;
  const drawn = Float64Array.from(positions, (position, node) => {
    if (node === 0 || node === count + 1) return place(position);
    const straight = first + ((node - 0.5) / count) * (last - first);
    return place(straight + gain * (position - straight));
  });
  const overlaps = (gap: number) =>
    gap > 0 && gap < count && (positions[gap + 1] ?? 0) - (positions[gap] ?? 0) <= spring.contactPitch;
  const touching = closed?.gaps ?? Uint8Array.from({ length: count + 1 }, (_, gap) => Number(overlaps(gap)));
  const radius = clamp(spring.coilRadius * scale, 18, height / 2 - 32);
  return {
    drawn,
    strain: strains(positions),
    touching,
    isHeld: closed !== null,
    margin,
    scale,
    radius,
    middle: (height - 28) / 2,
    wire: clamp(spring.wireDiameter * scale * 0.8, 1.3, 12 * LARGER),
  };
}

function drawCoil(context: CanvasRenderingContext2D, plan: Plan, peak: number): void {
  const { drawn, strain, touching, radius, middle, wire } = plan;
  const count = drawn.length - 2;
  const at = (node: number) => drawn[node] ?? 0;
  const between = (node: number) =>
    node === 0 ? at(0) : node === count ? at(count + 1) : (at(node) + at(node + 1)) / 2;
  const colour = (gap: number) => (touching[gap] ? ink.touch : shade(peak > 0 ? (strain[gap] ?? 0) / peak : 0));
  const half = (from: number, to: number, up: boolean) => {
    const [start, end] = up ? [middle + radius, middle - radius] : [middle - radius, middle + radius];
    // Control points of the cubic nearest to half a cosine wave.
    const [near, far] = [from + 0.3642 * (to - from), from + 0.6358 * (to - from)];
    context.moveTo(from, start);
    context.bezierCurveTo(near, start, far, end, to, end);
  };
  context.lineCap = 'round';
  context.globalAlpha = 0.5;
  context.lineWidth = 0.7 * wire;
  for (let node = 1; node <= count; node++) {
    context.beginPath();
    half(between(node - 1), at(node), true);
    context.strokeStyle = colour(node - 1);
    context.stroke();
  }
  context.globalAlpha = 1;
  for (let node = 1; node <= count; node++) {
    context.beginPath();
    half(at(node), between(node), false);
    context.strokeStyle = ink.card;
    context.lineWidth = wire + 1.6;
    context.stroke();
    context.strokeStyle = colour(node);
    context.lineWidth = wire;
    context.stroke();
  }
  markTouching(context, plan);
}

/** An arrowhead below each gap in which windings touch, and one above where they lie on each other. */
function markTouching(
  context: CanvasRenderingContext2D,
  { drawn, touching, isHeld, radius, middle, wire }: Plan,
): void {
  context.fillStyle = ink.touch;
  touching.forEach((touches, gap) => {
    if (!touches) return;
    const [middleOfGap, reach] = [((drawn[gap] ?? 0) + (drawn[gap + 1] ?? 0)) / 2, radius + wire + 1];
    context.fill(new Path2D(`M${middleOfGap} ${middle + reach}l3.5 7h-7z`));
    if (isHeld) context.fill(new Path2D(`M${middleOfGap} ${Math.max(8, middle - reach)}l3.5 -7h-7z`));
  });
}
