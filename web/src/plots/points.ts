// Points that can be picked: the nearest one to the pointer is named, a click picks it, the picked one has a ring.
//
// Next door: the chart they are in (`curves`).

import type uPlot from 'uplot';
import { clamp, make } from '../dom';
import { LARGER } from './chart';
import { ink } from './looks';

export interface Point {
  x: number;
  y: number;
  label: string;
}

/** How far from the pointer a point may be [pixels of a desk]. */
const REACH = 28;
const RING = 8;

export class Points {
  readonly plugin: uPlot.Plugin;
  private plot: uPlot | null = null;
  private chosen = -1;
  private near = -1;
  private readonly tip = make('div', { class: 'tip', hidden: true });

  constructor(
    private readonly points: readonly Point[],
    private readonly picked: (index: number) => void,
  ) {
    this.plugin = {
      hooks: {
        init: (plot) => {
          this.plot = plot;
          plot.over.append(this.tip);
          plot.over.addEventListener('click', () => this.near >= 0 && this.picked(this.near));
          plot.over.addEventListener('mouseleave', () => this.name(-1));
        },
        setCursor: ({ cursor }) => this.name(this.nearest(cursor.left ?? -1, cursor.top ?? -1)),
        draw: (plot) => this.ring(plot),
      },
    };
  }

  /** Rings this one; none where there is none of this number. */
  choose(index: number): void {
    this.chosen = index;
    this.plot?.redraw(false, false);
  }

  private at({ x, y }: Point, onCanvas = false): [number, number] {
    return [this.plot?.valToPos(x, 'x', onCanvas) ?? 0, this.plot?.valToPos(y, 'y', onCanvas) ?? 0];
  }

  private nearest(left: number, top: number): number {
    if (left < 0 || top < 0) return -1;
    const far = this.points.map((point) => {
      const [x, y] = this.at(point);
      return Math.hypot(x - left, y - top);
    });
    const least = Math.min(...far);
    return least <= REACH * LARGER ? far.indexOf(least) : -1;
  }

  /** Names a point beside it, where it stays within the plot. */
  private name(index: number): void {
    if (index === this.near) return;
    this.near = index;
    const point = this.points[index];
    this.tip.hidden = !point;
    if (!this.plot) return;
    this.plot.over.style.cursor = point ? 'pointer' : '';
    if (!point) return;
    this.tip.textContent = point.label;
    const [x, y] = this.at(point);
    const { clientWidth, clientHeight } = this.plot.over;
    const [wide, tall] = [this.tip.offsetWidth, this.tip.offsetHeight];
    this.tip.style.left = `${clamp(x - wide / 2, 0, Math.max(0, clientWidth - wide))}px`;
    const above = y - tall - 12;
    this.tip.style.top = `${above >= 0 ? above : Math.min(y + 12, clientHeight - tall)}px`;
  }

  private ring({ ctx }: uPlot): void {
    const point = this.points[this.chosen];
    if (!point) return;
    const ratio = devicePixelRatio || 1;
    const [x, y] = this.at(point, true);
    ctx.save();
    ctx.strokeStyle = ink.accent;
    ctx.lineWidth = 2.5 * LARGER * ratio;
    ctx.beginPath();
    ctx.arc(x, y, RING * LARGER * ratio, 0, 2 * Math.PI);
    ctx.stroke();
    ctx.restore();
  }
}
