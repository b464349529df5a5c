// The forces over frequency, with the surge lines marked.
//
// Next door: over time (`forces`), the bare chart (`chart`).

import uPlot from 'uplot';
import type { Answer, Facts } from '../answer';
import { axis, chart, curve, decades, font, LARGER } from './chart';
import { FORCE_NAMES, ink } from './looks';

/** Shown up to so many surge frequencies. */
const LINES = 8.5;
/** What is shown below the largest line [1]. */
const RANGE = 1e-4;

/**
 * Where an axis over decades may begin, a little below a value. uPlot 1.6.32 seeks the marks of one that begins from 9.5 to 10 times a power of
 * ten without end.
 */
const begin = (value: number): number => Math.min(value, 9.4 * 10 ** Math.floor(Math.log10(value)));

export class SpectrumPlot {
  readonly plot: uPlot;
  private facts: Facts | null = null;
  /** So much fits in, whatever is shown [N]. */
  least = 1e-12;

  constructor(host: HTMLElement) {
    this.plot = chart(host, this.options(), [
      [0, 1],
      ...FORCE_NAMES.map(() => [null, null]),
    ] as unknown as uPlot.AlignedData);
  }

  show(answer: Answer<Facts>, hidden: readonly string[]): void {
    const { facts, series } = answer;
    this.facts = facts;
    const frequency = series['frequency'] ?? new Float64Array();
    const last = LINES * (facts.lines[0] ?? 1);
    const end = frequency.findIndex((line) => line > last);
    const count = end < 0 ? frequency.length : end;
    // The mean is no line; nothing below the lowest decade, which a logarithm cannot show.
    const lines = FORCE_NAMES.map((name) => series[`spectrum ${name}`]?.subarray(1, count));
    const most = Math.max(
      this.least,
      ...lines.flatMap((values) => (values ? [values.reduce((a, b) => Math.max(a, b), 0)] : [])),
    );
    const data = [
      frequency.subarray(1, count),
      ...lines.map(
        (values) =>
          values?.map((value) => Math.max(value, most * RANGE)) ?? new Array(Math.max(0, count - 1)).fill(null),
      ),
    ];
    const { plot } = this;
    plot.batch(() => {
      FORCE_NAMES.forEach((name, index) => {
        const show = !hidden.includes(name);
        if (plot.series[index + 1]?.show !== show) plot.setSeries(index + 1, { show });
      });
      plot.setData(data as unknown as uPlot.AlignedData, false);
      plot.setScale('x', { min: 0, max: Math.min(last, frequency[frequency.length - 1] ?? last) });
      plot.setScale('y', { min: begin(most * RANGE), max: most * 2 });
    });
  }

  private options(): Omit<uPlot.Options, 'width' | 'height'> {
    return {
      // Room for the names of the lines.
      padding: [16 * LARGER, null, null, null],
      scales: { x: { time: false, auto: false }, y: { distr: 3, auto: false } },
      cursor: { drag: { x: false, y: false }, points: { show: false }, y: false },
      axes: [
        axis('Frequency [Hz]', 36, { space: 60 * LARGER }),
        axis('Amplitude [N]', 62, {
          // A line for each decade: nine of them, and peaks between, would be a thicket.
          splits: (_, __, low, high) => decades(low, high).filter((tick) => /^(1e|0\.0*1$|10*$)/.test(String(tick))),
          values: (_, ticks) =>
            ticks.map((tick) =>
              tick === null || (!/^1(0*$|e|\.?0*e)/.test(String(tick)) && !/^0\.0*1$/.test(String(tick)))
                ? ''
                : String(tick),
            ),
        }),
      ],
      series: [{}, ...FORCE_NAMES.map((name) => curve(name, name))],
      hooks: { drawClear: [(plot) => this.markLines(plot)] },
    };
  }

  private markLines(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const ratio = devicePixelRatio || 1;
    ctx.save();
    ctx.strokeStyle = ctx.fillStyle = ink.soft;
    ctx.lineWidth = ratio;
    ctx.setLineDash([3 * ratio, 4 * ratio]);
    ctx.font = font(11, ratio);
    ctx.textBaseline = 'bottom';
    ctx.textAlign = 'center';
    let free = 0;
    this.facts?.lines.forEach((line, index) => {
      const x = plot.valToPos(line, 'x', true);
      if (x > bbox.left + bbox.width) return;
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      const next = plot.valToPos(this.facts?.lines[1] ?? 2 * line, 'x', true);
      const long = `f1 = ${line.toPrecision(3)} Hz`;
      const words = index === 0 && x + ctx.measureText(long).width + 8 * ratio < next ? long : `f${index + 1}`;
      const half = ctx.measureText(words).width / 2;
      // Above the frame, where no curve strikes it out; neither beyond the plot nor into the name before.
      const middle = Math.max(x, bbox.left + half);
      if (middle - half < free || middle + half > bbox.left + bbox.width) return;
      ctx.fillText(words, middle, bbox.top - 2 * ratio);
      free = middle + half + 4 * ratio;
    });
    ctx.restore();
  }
}
