// The coil under a sine at one end, slowed down, and both forces over one turn of it; still where motion is not wanted.
//
// Next door: what goes round (`plots/turning`), how a coil is drawn (`spring/draw`), what is said of it (`words`).

import type { Answer, ExactFacts, PointFacts, Polar } from '../answer';
import { digits, make } from '../dom';
import { font } from '../plots/chart';
import { ink, look, type Colour } from '../plots/looks';
import { Turning } from '../plots/turning';
import { drawSpring, emptied, strains } from '../spring/draw';
import { brief, names } from './words';

/** One turn of the sine takes so long on the screen [s]. */
const TURN = 2;
/** The largest strain is drawn as so much of a pitch, and the largest motion of an end as so much of the length. */
const OPEN = 0.6;
const FAR = 0.06;
/** Moments of a turn at which strain is looked at. */
const LOOKS = 16;
/** Room below the waves [pixels]. */
const BELOW = 18;
const ROUND = 2 * Math.PI;

interface Scene {
  facts: ExactFacts;
  point: PointFacts;
  /** Motion of each node over that of the driven end, and metres on the screen to that. */
  real: Float64Array;
  imaginary: Float64Array;
  scale: number;
  peak: number;
}

export class Picture {
  private scene: Scene | null = null;
  private readonly coil = make('canvas', { class: 'moving', role: 'img', 'aria-label': 'The coil, not computed yet' });
  private readonly waves = make('canvas', { class: 'waves', role: 'img', 'aria-label': 'Both forces over one turn' });
  private readonly turning = new Turning({
    canvas: this.coil,
    sized: this.waves,
    turn: TURN,
    draw: (angle) => this.draw(angle),
    isThere: () => this.scene !== null,
  });
  private readonly scale = make('span', { class: 'soft' });
  readonly element = make(
    'div',
    { class: 'moved' },
    this.coil,
    this.waves,
    make('div', { class: 'player' }, this.turning.play, this.scale),
  );

  /** The coil at a frequency, and its places along it. */
  show({ facts: point, series }: Answer<PointFacts>, facts: ExactFacts): void {
    const [place, real, imaginary] = ['place', 'real', 'imaginary'].map((name) => series[name] ?? new Float64Array());
    if (!place || !real || !imaginary) return;
    const even = (values: Float64Array) => evenly(place, values);
    const scene = { facts, point, real: even(real), imaginary: even(imaginary), scale: 1, peak: 0 };
    // Undamped and exactly at a mode there is no steady motion.
    const isSteady = [...real, ...imaginary].every(Number.isFinite);
    this.scene = isSteady ? sized(scene) : null;
    const { own, other } = names(point.driven);
    this.coil.setAttribute('aria-label', `The coil of ${facts.spring.name} at ${brief(point)}`);
    this.waves.setAttribute('aria-label', `${own} and ${other} over one turn of ${brief(point)}`);
    this.scale.textContent = isSteady
      ? `Slowed down: one period in ${TURN} s. The motion is not to scale, forces are relative to the larger one.`
      : 'Exactly at a mode without damping the motion grows without end: there is no steady motion to draw.';
    // Where it stands still, as far apart as the forces come.
    if (!this.turning.playing) this.turning.angle = farthest(point);
    this.turning.show();
  }

  private draw(angle: number): void {
    const { scene } = this;
    if (!scene) {
      emptied(this.coil);
      emptied(this.waves);
      return;
    }
    drawMotion(this.coil, scene, angle);
    drawWaves(this.waves, scene.point, angle);
  }
}

/** Values at places along the coil as those of windings evenly spaced, half a step from the ends; between places along the straight line. */
function evenly(places: Float64Array, values: Float64Array): Float64Array {
  const count = places.length - 2;
  return Float64Array.from(values, (value, node) => {
    if (node === 0 || node > count) return value;
    const place = (node - 0.5) / count;
    const next = places.findIndex((other) => other >= place);
    const [from, to] = [places[next - 1] ?? 0, places[next] ?? 1];
    const part = to > from ? (place - from) / (to - from) : 0;
    return (values[next - 1] ?? value) * (1 - part) + (values[next] ?? value) * part;
  });
}

/** Where each node is at an angle of the turn [m]; nodes are drawn evenly over the mean length. */
function positions({ facts, real, imaginary, scale }: Scene, angle: number): Float32Array {
  const count = real.length - 2;
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  return Float32Array.from(real, (part, node) => {
    const place = node === 0 ? 0 : node > count ? 1 : (node - 0.5) / count;
    return place * facts.meanLength + scale * (part * cosine - (imaginary[node] ?? 0) * sine);
  });
}

/** With the motion enlarged or made smaller so that it can be seen, and no winding passes another. */
function sized(scene: Scene): Scene {
  const { facts, real, imaginary } = scene;
  const small = { ...scene, scale: 1e-4 * facts.meanLength };
  const over = (of: (angle: number) => number) =>
    Array.from({ length: LOOKS }, (_, look) => of((ROUND * look) / LOOKS)).reduce(
      (most, one) => Math.max(most, one),
      0,
    );
  const strain = over((angle) => Math.max(...strains(positions(small, angle)).map(Math.abs))) / small.scale;
  const last = real.length - 1;
  const ends = Math.max(
    Math.hypot(real[0] ?? 0, imaginary[0] ?? 0),
    Math.hypot(real[last] ?? 0, imaginary[last] ?? 0),
    1e-30,
  );
  const scale = Math.min(OPEN / (strain || 1e-30), (FAR * facts.meanLength) / ends);
  return { ...scene, scale, peak: scale * strain };
}

/** A force at an angle of the turn. */
const now = (value: Polar, angle: number): number => (value ? value[0] * Math.cos(angle + value[1]) : 0);

/** Forces at ends 1 and 2 over the larger of both. */
function forces({ driven, own, other }: PointFacts, angle: number): [number, number] {
  const most = Math.max(own?.[0] ?? 0, other?.[0] ?? 0, 1e-30);
  const [near, far] = [now(own, angle) / most, now(other, angle) / most];
  return driven === 1 ? [near, far] : [far, near];
}

/** The angle at which both forces are farthest apart. */
function farthest(point: PointFacts): number {
  const apart = (angle: number) => {
    const [one, two] = forces(point, angle);
    return Math.abs(one - two);
  };
  const angles = Array.from({ length: 360 }, (_, degree) => (ROUND * degree) / 360);
  return angles.reduce((best, angle) => (apart(angle) > apart(best) ? angle : best), 0);
}

function drawMotion(canvas: HTMLCanvasElement, scene: Scene, angle: number): void {
  const { facts, real, peak } = scene;
  const room = FAR * facts.meanLength;
  const [one, two] = forces(scene.point, angle);
  // Arrows show the mean force, and about it what the sine adds.
  const mean = Math.sign(facts.staticForce) || 1;
  drawSpring(emptied(canvas), {
    positions: positions(scene, angle),
    spring: { ...facts.spring, masses: real.length - 2 },
    forces: [mean + one, mean + two],
    closed: null,
    left: -room,
    right: facts.meanLength + room,
    peak,
    gain: 1,
    mean,
    departure: 1,
  });
}

/** Both forces over a turn, and where in it the coil is. */
function drawWaves(canvas: HTMLCanvasElement, point: PointFacts, angle: number): void {
  const empty = emptied(canvas);
  if (!empty) return;
  const { context, width, height } = empty;
  // Below it stands how long the turn is.
  const [left, middle] = [8, (height - BELOW) / 2];
  const tall = middle - 8;
  const across = width - 2 * left;
  context.strokeStyle = ink.line;
  context.lineWidth = 1;
  context.stroke(new Path2D(`M${left} ${middle}h${across}`));
  ['F_i', 'F_o'].forEach((name, end) => {
    const { colour, dash } = look(name);
    context.strokeStyle = context.fillStyle = ink[colour as Colour];
    context.lineWidth = 2;
    context.setLineDash(dash);
    context.beginPath();
    for (let step = 0; step <= 120; step++)
      context.lineTo(left + (across * step) / 120, middle - tall * (forces(point, (ROUND * step) / 120)[end] ?? 0));
    context.stroke();
    context.setLineDash([]);
    context.beginPath();
    context.arc(left + (across * angle) / ROUND, middle - tall * (forces(point, angle)[end] ?? 0), 5, 0, ROUND);
    context.fill();
  });
  context.font = font(11);
  context.fillStyle = ink.soft;
  context.textBaseline = 'bottom';
  context.fillText(`one turn, ${digits(1e3 / point.frequency)} ms`, left, height);
}
