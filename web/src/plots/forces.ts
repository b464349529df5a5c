// The four forces over time, and the readings that are asked for: the user's limit as a band about the true one, the judged part shaded, zoom
// by dragging, a mark that moves along.
//
// Next door: their spectrum (`spectrum`), the bare chart (`chart`).

import uPlot from 'uplot';
import type { Answer, Facts } from '../answer';
import { clamp } from '../dom';
import { axis, chart, curve, font, LARGER, plain, type Chart } from './chart';
import type { Line } from './lines';
import { FORCE_NAMES, ink } from './looks';

/** Series before the first reading: time, both edges of the band, the forces. */
const FIRST_READING = 3 + FORCE_NAMES.length;

export interface ForceEvents {
  /** The user chose other times [s]. */
  zoom(times: [number, number]): void;
  /** The user points at a time [s]. */
  point(time: number): void;
}

export class ForcePlot {
  private readonly chart: Chart;
  private readonly mark = document.createElement('div');
  private facts: Facts | null = null;
  private times: [number, number] = [0, 1];
  private at = 0;
  /** Runs when a picture is complete. */
  onDrawn: () => void = () => {};

  constructor(
    private readonly host: HTMLElement,
    private readonly events: ForceEvents,
  ) {
    this.chart = chart(host, this.options(), [
      [0, 1],
      ...Array.from({ length: 6 }, () => [null, null]),
    ] as unknown as uPlot.AlignedData);
    this.mark.className = 'mark';
    this.chart.plot.over.append(this.mark);
    this.listen();
  }

  show(answer: Answer<Facts>, times: [number, number], hidden: readonly string[], readings: readonly Line[]): void {
    const { facts, series } = answer;
    [this.facts, this.times] = [facts, times];
    const truth = series[facts.truth] ?? series['F_x'] ?? new Float64Array();
    const band = facts.goal ?? 0;
    const data: unknown[] = [
      series['time'],
      truth.map((force) => force + band),
      truth.map((force) => force - band),
      // A single winding has no F_L.
      ...FORCE_NAMES.map((name) => series[name] ?? new Array<null>(truth.length).fill(null)),
    ];
    const { plot } = this.chart;
    plot.batch(() => {
      this.addLines(readings);
      // A preview knows no sensors.
      const none = plot.series.length > FIRST_READING ? new Array<null>(truth.length).fill(null) : [];
      for (let number = 0; number < plot.series.length - FIRST_READING; number++)
        data.push(readings.some((line) => line.number === number) ? (series[`reading ${number}`] ?? none) : none);
      FORCE_NAMES.forEach((name, index) => {
        const show = !hidden.includes(name);
        if (plot.series[index + 3]?.show !== show) plot.setSeries(index + 3, { show });
      });
      plot.setData(data as unknown as uPlot.AlignedData, false);
      plot.setScale('x', { min: times[0], max: times[1] });
    });
    this.moveMark(this.at);
  }

  /** Moves the mark to a time [s], without a new picture. */
  moveMark(time: number): void {
    this.at = time;
    const inside = time >= this.times[0] && time <= this.times[1];
    this.mark.hidden = !inside;
    if (inside) this.mark.style.transform = `translateX(${this.chart.plot.valToPos(time, 'x')}px)`;
  }

  /** A curve for each sensor up to the last that is asked for, stepped, since a sensor holds its value. uPlot can hide curves, not drop them. */
  private addLines(readings: readonly Line[]): void {
    const { plot } = this.chart;
    const last = Math.max(-1, ...readings.map(({ number }) => number));
    const paths = uPlot.paths.stepped?.({ align: 1 });
    while (plot.series.length <= FIRST_READING + last) {
      const name = `reading ${plot.series.length - FIRST_READING}`;
      plot.addSeries({ ...curve(name, name), ...(paths ? { paths } : {}) });
    }
    plot.series.slice(FIRST_READING).forEach((series, number) => {
      const show = readings.some((line) => line.number === number);
      if (series.show !== show) plot.setSeries(FIRST_READING + number, { show });
    });
  }

  /** Draws the same data again; how long that takes [ms], by which the time of all else can be judged. */
  redrawn(): Promise<number> {
    const begun = performance.now();
    const { plot } = this.chart;
    return new Promise((resolve) => {
      const usual = this.onDrawn;
      this.onDrawn = () => {
        this.onDrawn = usual;
        resolve(performance.now() - begun);
      };
      plot.setData(plot.data, false);
      plot.setScale('x', { min: this.times[0], max: this.times[1] });
    });
  }

  get plot(): uPlot {
    return this.chart.plot;
  }

  private options(): Omit<uPlot.Options, 'width' | 'height'> {
    const edge = { stroke: () => 'transparent', points: { show: false }, width: 0 };
    return {
      scales: {
        x: { time: false, auto: false },
        y: { range: (_, low, high) => uPlot.rangeNum(low ?? 0, high ?? 1, 0.08, false) },
      },
      cursor: { drag: { x: true, y: false, dist: 6 }, points: { show: false }, y: false },
      axes: [
        axis('Time [ms]', 36, { values: (_, ticks) => ticks.map((tick) => plain(1e3 * tick)), space: 60 * LARGER }),
        axis('Force [N]', 58, { space: 34 * LARGER, values: (_, ticks) => ticks.map(plain) }),
      ],
      series: [{}, edge, edge, ...FORCE_NAMES.map((name) => curve(name, name))],
      bands: [{ series: [1, 2], fill: () => ink.band }],
      hooks: {
        drawClear: [(plot) => this.shade(plot)],
        draw: [() => this.onDrawn()],
        setSelect: [
          (plot) => {
            if (plot.select.width < 6) return;
            const [from, to] = [
              plot.posToVal(plot.select.left, 'x'),
              plot.posToVal(plot.select.left + plot.select.width, 'x'),
            ];
            plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
            this.events.zoom([from, to]);
          },
        ],
        setSize: [() => this.moveMark(this.at)],
      },
    };
  }

  /** The judged part, and where windings touch. */
  private shade(plot: uPlot): void {
    const { facts } = this;
    const condition = facts?.conditions[facts.condition];
    if (!facts || !condition) return;
    const { ctx, bbox } = plot;
    const ratio = devicePixelRatio || 1;
    const x = (time: number) => clamp(plot.valToPos(time, 'x', true), bbox.left, bbox.left + bbox.width);
    const area = (from: number, to: number, colour: string, words: string) => {
      if (x(to) - x(from) < 1) return;
      ctx.fillStyle = colour;
      ctx.fillRect(x(from), bbox.top, x(to) - x(from), bbox.height);
      ctx.fillStyle = ink.soft;
      ctx.font = font(11, ratio);
      ctx.textBaseline = 'top';
      ctx.textAlign = 'left';
      if (x(to) - x(from) > ctx.measureText(words).width + 12 * ratio)
        ctx.fillText(words, x(from) + 6 * ratio, bbox.top + 4 * ratio);
    };
    ctx.save();
    area(condition.window[0], condition.window[1], ink.judged, 'judged');
    ctx.restore();
  }

  private listen(): void {
    const { over } = this.chart.plot;
    const timeAt = (event: MouseEvent) =>
      this.chart.plot.posToVal(event.clientX - over.getBoundingClientRect().left, 'x');
    over.addEventListener('click', (event) => this.events.point(clamp(timeAt(event), ...this.times)));
    over.addEventListener('dblclick', () => this.zoomBy(0.5));
    this.host.addEventListener('keydown', (event) => {
      const width = this.times[1] - this.times[0];
      const step = event.shiftKey ? width / 10 : width / 100;
      const moves: Record<string, () => void> = {
        ArrowLeft: () => this.events.point(clamp(this.at - step, ...this.times)),
        ArrowRight: () => this.events.point(clamp(this.at + step, ...this.times)),
        '+': () => this.zoomBy(2),
        '=': () => this.zoomBy(2),
        '-': () => this.zoomBy(0.5),
      };
      const move = moves[event.key];
      if (!move || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      move();
    });
  }

  /** Zooms about the mark. */
  zoomBy(factor: number): void {
    const [from, to] = this.times;
    const duration = this.facts?.conditions[this.facts.condition]?.duration ?? to;
    const centre = this.at >= from && this.at <= to ? this.at : (from + to) / 2;
    const width = clamp((to - from) / factor, 1e-3, duration);
    const first = clamp(centre - ((centre - from) / (to - from)) * width, 0, duration - width);
    this.events.zoom([first, first + width]);
  }
}
