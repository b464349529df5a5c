// What the spring hangs between: two walls, the force at each as an arrow, and a ruler.
//
// Next door: the coil (`draw`).

import { font } from '../plots/chart';
import { ink } from '../plots/looks';
import type { Moment, Plan } from './draw';

/** Of the room beside a wall, what the mean force takes, and what its largest departure, which would not be seen to scale. */
export const STEADY = 0.55;
export const VARYING = 0.4;

/** Both walls, hollow where the spring has left them, and at each the force: an arrow out of the spring for tension, into it for compression. */
export function drawEnds(context: CanvasRenderingContext2D, plan: Plan, moment: Moment): void {
  const { forces, mean, departure, closed } = moment;
  const { drawn, radius, middle, margin } = plan;
  const colours = [ink.blue, ink.red];
  [drawn[0] ?? 0, drawn[drawn.length - 1] ?? 0].forEach((at, end) => {
    const outward = end ? 1 : -1;
    const wall = [at + (end ? 0 : -5), middle - radius - 8, 5, 2 * radius + 16] as const;
    context.fillStyle = context.strokeStyle = ink.soft;
    context.lineWidth = 1;
    if (closed?.off.includes(end + 1)) context.strokeRect(...wall);
    else context.fillRect(...wall);
    const varying = departure > 0 ? (VARYING * ((forces[end] ?? 0) - mean)) / departure : 0;
    const length = (margin - 16) * (Math.sign(mean) * STEADY + varying);
    arrow(context, at + outward * 6, middle, length, outward, colours[end] ?? ink.ink);
  });
}

function arrow(
  context: CanvasRenderingContext2D,
  at: number,
  middle: number,
  length: number,
  outward: number,
  colour: string,
): void {
  const size = Math.abs(length);
  if (size < 3) return;
  const [tail, tip] = length > 0 ? [at, at + outward * size] : [at + outward * size, at];
  const back = Math.sign(tail - tip) * Math.min(11, size);
  context.fillStyle = context.strokeStyle = colour;
  context.lineCap = 'butt';
  context.lineWidth = 4;
  context.stroke(new Path2D(`M${tail} ${middle}H${tip + back * 0.8}`));
  context.fill(new Path2D(`M${tip} ${middle}l${back} -7v14z`));
}

export function drawRuler(context: CanvasRenderingContext2D, { margin, scale }: Plan, height: number): void {
  const room = 90 / scale;
  const power = 10 ** Math.floor(Math.log10(room));
  const length = power * ([5, 2, 1].find((step) => step * power <= room) ?? 1);
  const [y, pixels] = [height - 8.5, length * scale];
  context.strokeStyle = context.fillStyle = ink.soft;
  context.lineWidth = 1;
  context.stroke(new Path2D(`M${margin + 0.5} ${y - 4}v8m0 -4h${pixels}m0 -4v8`));
  context.font = font();
  context.textBaseline = 'middle';
  context.fillText(`${Number((length * 1e3).toPrecision(3))} mm`, margin + pixels + 8, y);
}
