// The kept curves behind those of now, on the plots' own canvases: broad and pale, in the dashes of their forces. They have times of their own, are
// thinned to what the screen can show, and are thinned once for each view, so that a slider waits for nothing.
//
// Next door: which curves (`held`), what is in front of them (`plots/forces`, `plots/spectrum`).

import type uPlot from 'uplot';
import type { Series } from '../answer';
import { font, LARGER } from '../plots/chart';
import type { ForcePlot } from '../plots/forces';
import { ink, look } from '../plots/looks';
import type { SpectrumPlot } from '../plots/spectrum';
import type { View } from '../state';
import { ring } from './case';
import { heldNow, keptLines, PALE, WIDER } from './held';

type Curve = { name: string; x: number[]; y: number[] };

/** The first number of a sorted list whose value is not below this one. */
function from(values: Float64Array, least: number): number {
  let [low, high] = [0, values.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((values[middle] ?? 0) < least) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** A part of a series with the least and the most of each of so many columns; all of it where that is no more. */
export function thinned(
  x: Float64Array,
  y: Float64Array,
  [low, high]: [number, number],
  columns: number,
): Omit<Curve, 'name'> {
  const [first, last] = [Math.max(0, from(x, low) - 1), Math.min(x.length, y.length, from(x, high) + 1)];
  const each = Math.ceil((last - first) / columns);
  if (each <= 4) return { x: [...x.subarray(first, last)], y: [...y.subarray(first, last)] };
  const thin: Omit<Curve, 'name'> = { x: [], y: [] };
  for (let at = first; at < last; at += each) {
    let [least, most] = [at, at];
    for (let next = at; next < Math.min(at + each, last); next++) {
      if ((y[next] ?? 0) < (y[least] ?? 0)) least = next;
      if ((y[next] ?? 0) > (y[most] ?? 0)) most = next;
    }
    for (const one of least < most ? [least, most] : [most, least]) {
      thin.x.push(x[one] ?? 0);
      thin.y.push(y[one] ?? 0);
    }
  }
  return thin;
}

export class Ghost {
  private known = { of: null as unknown, key: '', curves: [] as Curve[], least: Infinity, most: -Infinity };

  constructor(
    private readonly forces: ForcePlot,
    private readonly spectrum: SpectrumPlot,
    private readonly view: () => View,
  ) {
    const { scales, hooks } = forces.plot;
    const scale = scales['y'];
    const usual = scale?.range;
    // What is kept is in sight as what is now.
    if (scale && typeof usual === 'function')
      scale.range = (plot, low, high, key) => usual(plot, ...this.wider(low, high), key);
    hooks.drawClear?.push((plot) => this.drawForces(plot));
    spectrum.plot.hooks.drawClear?.push((plot) => this.drawSpectrum(plot));
  }

  /** Another state is kept, or none: the plots are drawn anew with the same curves in front. */
  changed(): void {
    const { plot, timeline } = this.forces;
    plot.setData(plot.data, false);
    const [min, max] = timeline.times;
    plot.setScale('x', { min, max });
    const series: Series = heldNow()?.answer.series ?? {};
    const most = Object.entries(series).flatMap(([name, values]) =>
      name.startsWith('spectrum ') ? [values.subarray(1).reduce((a, b) => Math.max(a, b), 0)] : [],
    );
    this.spectrum.least = Math.max(1e-12, ...most);
  }

  /** Kept curves over the shown times. */
  private curves(): Curve[] {
    const held = heldNow();
    if (!held) return [];
    const { times } = this.forces.timeline;
    const columns = Math.ceil(this.forces.plot.over.clientWidth) || 300;
    const { hidden, sensors } = this.view();
    const key = JSON.stringify([times, columns, hidden, sensors]);
    if (this.known.of === held && this.known.key === key) return this.known.curves;
    const { series } = held.answer;
    const time = series['time'] ?? new Float64Array();
    const curves = keptLines(this.view()).map((line) => ({
      name: line.series,
      ...thinned(time, series[line.series] ?? new Float64Array(), times, columns),
    }));
    const all = curves.flatMap(({ y }) => y);
    const least = all.reduce((a, b) => Math.min(a, b), Infinity);
    const most = all.reduce((a, b) => Math.max(a, b), -Infinity);
    this.known = { of: held, key, curves, least, most };
    return curves;
  }

  private wider(low: number | null, high: number | null): [number, number] {
    if (this.curves().length === 0) return [low ?? 0, high ?? 1];
    const { least, most } = this.known;
    const [a, b] = [Math.min(low ?? Infinity, least), Math.max(high ?? -Infinity, most)];
    return a < b ? [a, b] : [low ?? 0, high ?? 1];
  }

  private drawForces(plot: uPlot): void {
    if (!heldNow()) return;
    draw(plot, this.curves(), (force) => force);
  }

  private drawSpectrum(plot: uPlot): void {
    const held = heldNow();
    if (!held) return;
    const { series, facts } = held.answer;
    const frequency = series['frequency'] ?? new Float64Array();
    const end = from(frequency, plot.scales['x']?.max ?? Infinity) + 1;
    const least = plot.scales['y']?.min ?? 0;
    const curves = keptLines(this.view()).flatMap(({ series: name }) => {
      const y = series[`spectrum ${name}`];
      // The mean is no line.
      return y ? [{ name, x: [...frequency.subarray(1, end)], y: [...y.subarray(1, end)] }] : [];
    });
    draw(plot, curves, (amplitude) => Math.max(amplitude, least));
    markRing(plot, ring(facts));
  }
}

/** Where a value lies on the canvas: one line through two of uPlot's own places, which it finds slowly for thousands of points. */
function place(plot: uPlot, key: string): (value: number) => number {
  const { min, max, distr } = plot.scales[key] ?? {};
  const flat = distr === 3 ? Math.log10 : (value: number) => value;
  const [low, high] = [min ?? 0, max ?? 1];
  const [first, last] = [plot.valToPos(low, key, true), plot.valToPos(high, key, true)];
  const slope = (last - first) / (flat(high) - flat(low) || 1);
  const start = flat(low);
  return (value) => first + slope * (flat(value) - start);
}

function draw(plot: uPlot, curves: Curve[], fit: (value: number) => number): void {
  const { ctx, bbox } = plot;
  const ratio = (devicePixelRatio || 1) * LARGER;
  const [across, up] = [place(plot, 'x'), place(plot, 'y')];
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.globalAlpha = PALE;
  ctx.lineJoin = 'round';
  for (const { name, x, y } of curves) {
    const { colour, dash, width } = look(name);
    ctx.strokeStyle = ink[colour as keyof typeof ink];
    ctx.lineWidth = WIDER * width * ratio;
    ctx.setLineDash(dash.map((part) => 1.5 * part * ratio));
    ctx.beginPath();
    x.forEach((at, index) => ctx.lineTo(across(at), up(fit(y[index] ?? 0))));
    ctx.stroke();
  }
  ctx.restore();
}

/** Where the kept coil rings by itself, named below the names of now's lines. */
function markRing(plot: uPlot, line: number): void {
  const { ctx, bbox } = plot;
  const x = plot.valToPos(line, 'x', true);
  const words = 'kept f1';
  ctx.save();
  ctx.font = font(11, devicePixelRatio || 1);
  const wide = ctx.measureText(words).width;
  if (x > bbox.left && x + wide < bbox.left + bbox.width) {
    ctx.strokeStyle = ctx.fillStyle = ink.soft;
    ctx.lineWidth = 3 * (devicePixelRatio || 1);
    ctx.globalAlpha = PALE;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top + 16 * (devicePixelRatio || 1));
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.globalAlpha = 1;
    ctx.textBaseline = 'top';
    ctx.textAlign = 'left';
    ctx.fillText(words, x + 4 * (devicePixelRatio || 1), bbox.top + 16 * (devicePixelRatio || 1));
  }
  ctx.restore();
}
