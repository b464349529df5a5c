// The forces over the shown times on a film's pictures: axes, the judged part, the user's limit, a curve for each line. The mark goes over it.
//
// Next door: the same on the screen (`plots/forces`) and as an SVG (`results/svg`), where it stands (`picture`).

import type { Answer, Facts } from '../answer';
import type { Line } from '../plots/lines';
import { ink, look } from '../plots/looks';
import { ticks } from '../results/svg';
import { write } from './type';

export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Room of the axes, and for the largest force [units of the picture]. */
const AXES = { left: 62, top: 10, right: 12, bottom: 36 };
const AIR = 0.08;

export class Plot {
  private readonly area: Box;
  private readonly low: number;
  private readonly high: number;
  private readonly first: number;
  private readonly past: number;

  constructor(
    { left, top, width, height }: Box,
    private readonly answer: Answer<Facts>,
    private readonly times: [number, number],
    private readonly lines: readonly Line[],
  ) {
    this.area = {
      left: left + AXES.left,
      top: top + AXES.top,
      width: width - AXES.left - AXES.right,
      height: height - AXES.top - AXES.bottom,
    };
    const time = answer.series['time'] ?? new Float64Array();
    // One sample beyond either edge, so that curves reach it.
    const past = time.findIndex((t) => t > times[1]);
    this.first = Math.max(
      0,
      time.findLastIndex((t) => t <= times[0]),
    );
    this.past = past < 0 ? time.length : past + 1;
    const all = lines.map((line) => this.values(line.series));
    const low = Math.min(...all.map((values) => values.reduce((a, b) => Math.min(a, b), Infinity)));
    const high = Math.max(...all.map((values) => values.reduce((a, b) => Math.max(a, b), -Infinity)));
    const air = AIR * (high - low || Math.abs(high) || 1);
    [this.low, this.high] = Number.isFinite(low) ? [low - air, high + air] : [0, 1];
  }

  x(time: number): number {
    const [from, to] = this.times;
    return this.area.left + ((time - from) / (to - from)) * this.area.width;
  }

  private y(force: number): number {
    return this.area.top + (1 - (force - this.low) / (this.high - this.low)) * this.area.height;
  }

  private values(series: string): Float64Array {
    return (this.answer.series[series] ?? new Float64Array()).subarray(this.first, this.past);
  }

  draw(context: CanvasRenderingContext2D): void {
    const { area, answer } = this;
    this.axes(context);
    context.save();
    context.beginPath();
    context.rect(area.left, area.top, area.width, area.height);
    context.clip();
    this.shade(context);
    if (answer.facts.goal) this.band(context, answer.facts.goal);
    for (const line of this.lines) this.curve(context, line);
    context.restore();
  }

  /** Where the player is. */
  mark(context: CanvasRenderingContext2D, time: number): void {
    context.fillStyle = ink.accent;
    context.fillRect(this.x(time) - 1, this.area.top, 2, this.area.height);
  }

  private axes(context: CanvasRenderingContext2D): void {
    const { left, top, width, height } = this.area;
    const style = { size: 12, colour: ink.soft };
    context.fillStyle = ink.line;
    for (const force of ticks(this.low, this.high)) context.fillRect(left, this.y(force) - 0.5, width, 1);
    const across = ticks(1e3 * this.times[0], 1e3 * this.times[1]);
    for (const ms of across) context.fillRect(this.x(ms / 1e3) - 0.5, top, 1, height);
    const written = (value: number) => String(value).replace('-', '−');
    for (const force of ticks(this.low, this.high))
      write(context, written(force), left - 6, this.y(force) + 4, { ...style, align: 'right' });
    for (const ms of across)
      write(context, written(ms), Math.min(this.x(ms / 1e3), left + width - 8), top + height + 15, {
        ...style,
        align: 'center',
      });
    write(context, 'Time [ms]', left + width / 2, top + height + 31, { ...style, align: 'center' });
    context.save();
    context.translate(left - 52, top + height / 2);
    context.rotate(-Math.PI / 2);
    write(context, 'Force [N]', 0, 4, { ...style, align: 'center' });
    context.restore();
  }

  /** The judged part. */
  private shade(context: CanvasRenderingContext2D): void {
    const { facts } = this.answer;
    const [from, to] = facts.conditions[facts.condition]?.window ?? this.times;
    const [left, right] = [
      Math.max(this.x(from), this.area.left),
      Math.min(this.x(to), this.area.left + this.area.width),
    ];
    if (right - left < 1) return;
    context.fillStyle = ink.judged;
    context.fillRect(left, this.area.top, right - left, this.area.height);
    if (right - left > 50) write(context, 'judged', left + 5, this.area.top + 14, { size: 11, colour: ink.soft });
  }

  private band(context: CanvasRenderingContext2D, goal: number): void {
    const { facts, series } = this.answer;
    const truth = this.values(series[facts.truth] ? facts.truth : 'F_x');
    const at = (index: number) => this.x(this.answer.series['time']?.[this.first + index] ?? 0);
    context.beginPath();
    truth.forEach((force, index) => context.lineTo(at(index), this.y(force + goal)));
    for (let index = truth.length - 1; index >= 0; index--)
      context.lineTo(at(index), this.y((truth[index] ?? 0) - goal));
    context.fillStyle = ink.band;
    context.fill();
  }

  private curve(context: CanvasRenderingContext2D, { series }: Line): void {
    const { colour, dash, width } = look(series);
    const time = this.answer.series['time'] ?? new Float64Array();
    // A sensor holds its value.
    const isHeld = series.startsWith('reading');
    context.beginPath();
    let before = 0;
    this.values(series).forEach((force, index) => {
      const x = this.x(time[this.first + index] ?? 0);
      if (isHeld && index > 0) context.lineTo(x, before);
      before = this.y(force);
      context.lineTo(x, before);
    });
    context.setLineDash(dash);
    context.lineWidth = width;
    context.lineJoin = 'round';
    context.strokeStyle = ink[colour as keyof typeof ink];
    context.stroke();
    context.setLineDash([]);
  }
}
