// The four forces over time, and the readings that are asked for: the user's limit as a band about the true one, the judged part shaded.
//
// Next door: which times are shown, and the mark (`timeline`), their spectrum (`spectrum`).

import uPlot from 'uplot';
import type { Answer, Facts } from '../answer';
import { clamp } from '../dom';
import { axis, curve, font, LARGER, plain } from './chart';
import type { Line } from './lines';
import { FORCE_NAMES, ink } from './looks';
import { Timeline, type TimeEvents, type Times } from './timeline';

/** Series before the first reading: time, both edges of the band, the forces. */
const FIRST_READING = 3 + FORCE_NAMES.length;

export class ForcePlot {
  readonly plot: uPlot;
  readonly timeline: Timeline;
  private facts: Facts | null = null;
  /** Runs when a picture is complete. */
  onDrawn: () => void = () => {};

  constructor(host: HTMLElement, events: TimeEvents) {
    this.timeline = new Timeline(events);
    this.plot = this.timeline.add(host, this.options(), [
      [0, 1],
      ...Array.from({ length: 6 }, () => [null, null]),
    ] as unknown as uPlot.AlignedData);
  }

  show(answer: Answer<Facts>, times: Times, hidden: readonly string[], readings: readonly Line[]): void {
    const { facts, series } = answer;
    this.facts = facts;
    const truth = series[facts.truth] ?? series['F_x'] ?? new Float64Array();
    const band = facts.goal ?? 0;
    const data: unknown[] = [
      series['time'],
      truth.map((force) => force + band),
      truth.map((force) => force - band),
      // A single winding has no F_L.
      ...FORCE_NAMES.map((name) => series[name] ?? new Array<null>(truth.length).fill(null)),
    ];
    const { plot } = this;
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
      this.timeline.show(times, [0, facts.conditions[facts.condition]?.duration ?? times[1]]);
    });
  }

  /** A curve for each sensor up to the last that is asked for, stepped, since a sensor holds its value. uPlot can hide curves, not drop them. */
  private addLines(readings: readonly Line[]): void {
    const { plot } = this;
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
    const { plot } = this;
    return new Promise((resolve) => {
      const usual = this.onDrawn;
      this.onDrawn = () => {
        this.onDrawn = usual;
        resolve(performance.now() - begun);
      };
      plot.setData(plot.data, false);
      plot.setScale('x', { min: this.timeline.times[0], max: this.timeline.times[1] });
    });
  }

  private options(): Omit<uPlot.Options, 'width' | 'height'> {
    const edge = { stroke: () => 'transparent', points: { show: false }, width: 0 };
    return {
      scales: {
        y: { range: (_, low, high) => uPlot.rangeNum(low ?? 0, high ?? 1, 0.08, false) },
      },
      axes: [
        axis('Time [ms]', 36, { values: (_, ticks) => ticks.map((tick) => plain(1e3 * tick)), space: 60 * LARGER }),
        axis('Force [N]', 58, { space: 34 * LARGER, values: (_, ticks) => ticks.map(plain) }),
      ],
      series: [{}, edge, edge, ...FORCE_NAMES.map((name) => curve(name, name))],
      bands: [{ series: [1, 2], fill: () => ink.band }],
      hooks: {
        drawClear: [(plot) => this.shade(plot)],
        draw: [() => this.onDrawn()],
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
}
