// What plots over one time share: which part of it is shown, chosen by dragging, buttons and keys, and a mark at a moment, chosen by a
// click and by keys.
//
// Next door: what is drawn (`forces`, `log/recorded`, `report/charts`), the bare chart (`chart`), fingers on it (`touch`).

import type uPlot from 'uplot';
import { clamp, make } from '../dom';
import { chart } from './chart';

/** From and to [s]. */
export type Times = [number, number];

export interface TimeEvents {
  /** The user chose other times [s], or those of the beginning (null): who hears it shows them. */
  zoom(times: Times | null): void;
  /** The user points at a time [s]. */
  point(time: number): void;
}

/** A selection narrower than this is a click [pixels]. */
const CLICK = 6;

export class Timeline {
  times: Times = [0, 1];
  private whole: Times = [0, 1];
  private least = 0;
  private at = NaN;
  private plots: { plot: uPlot; mark: HTMLElement }[] = [];

  constructor(private readonly events: TimeEvents) {}

  /** A plot over time [s] in its host, where keys are heard, too. */
  add(host: HTMLElement, options: Omit<uPlot.Options, 'width' | 'height'>, data: uPlot.AlignedData): uPlot {
    const mark = make('div', { class: 'mark', 'aria-hidden': 'true', hidden: true });
    const { scales, cursor, hooks = {} } = options;
    const plot = chart(
      host,
      {
        ...options,
        scales: { x: { time: false, auto: false }, ...scales },
        cursor: {
          drag: { x: true, y: false, dist: CLICK, setScale: false },
          points: { show: false },
          y: false,
          bind: { dblclick: () => () => (this.events.zoom(null), null) },
          ...cursor,
        },
        hooks: {
          ...hooks,
          setSelect: [(plot) => this.chosen(plot)],
          draw: [(plot) => this.place(plot, mark), ...(hooks.draw ?? [])],
        },
      },
      data,
    );
    const { over } = plot;
    over.append(mark);
    over.addEventListener('click', (event) => {
      const time = plot.posToVal(event.clientX - over.getBoundingClientRect().left, 'x');
      this.events.point(clamp(time, ...this.times));
    });
    host.addEventListener('keydown', (event) => this.key(event));
    const touched = {
      times: () => this.times,
      choose: (from: number, to: number) => this.choose(from, to),
      reset: () => this.events.zoom(null),
    };
    if (navigator.maxTouchPoints > 0) void import('./touch').then(({ follow }) => follow(over, touched));
    this.plots.push({ plot, mark });
    return plot;
  }

  /** Forgets its plots: their hosts go. */
  clear(): void {
    this.plots = [];
  }

  /** Shows these times of a whole, of which nobody can choose less than `least` [s]. */
  show(times: Times, whole: Times, least = 1e-3 * (whole[1] - whole[0])): void {
    [this.times, this.whole, this.least] = [times, whole, least];
    for (const { plot } of this.plots) plot.setScale('x', { min: times[0], max: times[1] });
  }

  /** Moves the mark to a time [s], without a new picture. */
  moveMark(time: number): void {
    this.at = time;
    for (const { plot, mark } of this.plots) this.place(plot, mark);
  }

  /** Zooms about the mark, or moves by a part of what is shown. */
  zoomBy(factor: number, shift = 0): void {
    const [from, to] = this.times;
    const centre = this.at >= from && this.at <= to ? this.at : (from + to) / 2;
    const moved = shift * (to - from);
    this.choose(centre - (centre - from) / factor + moved, centre + (to - centre) / factor + moved);
  }

  /** Asks for the times nearest to these that there are. */
  private choose(from: number, to: number): void {
    const [start, end] = this.whole;
    const width = clamp(to - from, Math.min(this.least, end - start), end - start);
    const first = clamp((from + to - width) / 2, start, end - width);
    this.events.zoom([first, first + width]);
  }

  private chosen(plot: uPlot): void {
    const { left, width } = plot.select;
    if (width < CLICK) return;
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.choose(plot.posToVal(left, 'x'), plot.posToVal(left + width, 'x'));
  }

  private place(plot: uPlot, mark: HTMLElement): void {
    mark.hidden = !(this.at >= this.times[0] && this.at <= this.times[1]);
    if (!mark.hidden) mark.style.transform = `translateX(${plot.valToPos(this.at, 'x')}px)`;
  }

  private key(event: KeyboardEvent): void {
    const [from, to] = this.times;
    const step = (event.shiftKey ? 0.1 : 0.01) * (to - from);
    const point = (time: number) => () => this.events.point(clamp(time, from, to));
    const moves: Record<string, () => void> = {
      ArrowLeft: point(this.at - step),
      ArrowRight: point(this.at + step),
      Home: point(from),
      End: point(to),
      '+': () => this.zoomBy(2),
      '=': () => this.zoomBy(2),
      '-': () => this.zoomBy(0.5),
      Escape: () => this.events.zoom(null),
    };
    const move = moves[event.key];
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    move();
  }
}
