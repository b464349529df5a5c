// The wire of a mode on a canvas: at rest in grey, in motion in the colour of its kind, nearer parts brighter, a ring at each end.
//
// Next door: where its points are (`scene`), which moment (`wire`).

import { clamp } from '../dom';
import { font } from '../plots/chart';
import { ink } from '../plots/looks';
import { emptied, mix } from '../spring/draw';
import { projector, type Scene, type View } from './scene';

/** Steps of brightness from the back to the front. */
const SHADES = 24;
/** The back is mixed with the ground by so much. */
const DIM = 0.62;

type Placed = { x: Float64Array; y: Float64Array; depth: Float64Array };

/** `part` is how far the motion is out: 1 to −1. */
export function drawWire(canvas: HTMLCanvasElement, scene: Scene, view: View, part: number, colour: string): void {
  const empty = emptied(canvas);
  if (!empty) return;
  const { context, width, height } = empty;
  const reach = scene.radius + scene.amplitude;
  const scale = Math.min((0.86 * width) / (Math.abs(scene.length) + scene.radius), (0.8 * height) / (2 * reach));
  const project = projector(scene, view);
  const place = (x: number, y: number, z: number): [number, number, number] => {
    const [right, down, depth] = project(x, y, z);
    return [width / 2 + scale * right, height / 2 + scale * down, depth];
  };
  const wire = clamp(scene.wireDiameter * scale, 1.4, 16);
  context.lineCap = context.lineJoin = 'round';
  ends(context, scene, place, height);
  const rest = placed(scene, 0, place);
  context.strokeStyle = ink.line;
  context.lineWidth = Math.max(1, 0.35 * wire);
  context.beginPath();
  for (let point = 0; point < scene.count; point++) context.lineTo(rest.x[point] ?? 0, rest.y[point] ?? 0);
  context.stroke();
  moving(context, scene, placed(scene, part * scene.amplitude, place), wire, colour);
}

function placed(
  { positions, count }: Scene,
  by: number,
  place: (x: number, y: number, z: number) => [number, number, number],
): Placed {
  const found: Placed = { x: new Float64Array(count), y: new Float64Array(count), depth: new Float64Array(count) };
  for (let point = 0; point < count; point++) {
    const at = (axis: number) => (positions[6 * point + axis] ?? 0) + by * (positions[6 * point + axis + 3] ?? 0);
    [found.x[point], found.y[point], found.depth[point]] = place(at(0), at(1), at(2));
  }
  return found;
}

/** Piece by piece from the back to the front, each with the card's colour about it, so that what crosses is told apart. */
function moving(
  context: CanvasRenderingContext2D,
  { count, radius }: Scene,
  { x, y, depth }: Placed,
  wire: number,
  colour: string,
): void {
  const middle = (piece: number) => (depth[piece] ?? 0) + (depth[piece + 1] ?? 0);
  const order = Array.from({ length: count - 1 }, (_, piece) => piece).sort((a, b) => middle(b) - middle(a));
  const [near, far] = [middle(order[order.length - 1] ?? 0), middle(order[0] ?? 0)];
  const shades = Array.from({ length: SHADES + 1 }, (_, step) => mix(colour, ink.card, (DIM * step) / SHADES));
  const deep = far - near || radius;
  for (const piece of order) {
    const at = Math.round((SHADES * (middle(piece) - near)) / deep);
    context.beginPath();
    context.moveTo(x[piece] ?? 0, y[piece] ?? 0);
    context.lineTo(x[piece + 1] ?? 0, y[piece + 1] ?? 0);
    if (wire > 2.5) {
      context.strokeStyle = ink.card;
      context.lineWidth = wire + 1.6;
      context.lineCap = 'butt';
      context.stroke();
      context.lineCap = 'round';
    }
    context.strokeStyle = shades[at] ?? colour;
    context.lineWidth = wire;
    context.stroke();
  }
}

/** A ring where each end is held, and its number below. */
function ends(
  context: CanvasRenderingContext2D,
  { length, radius }: Scene,
  place: (x: number, y: number, z: number) => [number, number, number],
  height: number,
): void {
  context.strokeStyle = ink.soft;
  context.fillStyle = ink.soft;
  context.lineWidth = 1.5;
  context.font = font(11);
  context.textAlign = 'center';
  [0, length].forEach((z, end) => {
    context.beginPath();
    for (let step = 0; step <= 48; step++) {
      const angle = (step / 24) * Math.PI;
      const [x, y] = place(1.25 * radius * Math.cos(angle), 1.25 * radius * Math.sin(angle), z);
      context.lineTo(x, y);
    }
    context.stroke();
    const [x, y] = place(-1.25 * radius, 0, z);
    context.fillText(`end ${end + 1}`, x, Math.min(height - 4, y + 16));
  });
}
