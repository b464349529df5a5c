// A uPlot that fills its host, follows light and dark, and knows nothing of forces.
//
// Next door: what is drawn (`forces`, `spectrum`, `paper`).

import uPlot from 'uplot';
import { ink } from './looks';

export const FONT = '12px system-ui, -apple-system, "Segoe UI", Roboto, Arial, sans-serif';

/** An axis with the page's colours; `label` with its unit. */
export function axis(label: string, more: Partial<uPlot.Axis> = {}): uPlot.Axis {
  return {
    label,
    labelFont: FONT,
    font: FONT,
    labelSize: 20,
    stroke: () => ink.soft,
    grid: { stroke: () => ink.line, width: 1 },
    ticks: { stroke: () => ink.line, width: 1, size: 5 },
    ...more,
  };
}

/** A tick as people read it. */
export const plain = (tick: number): string => String(Number(tick.toPrecision(10))).replace('-', '−');

export interface Chart {
  plot: uPlot;
  /** The same picture again: colours or overlays have changed. */
  redraw(): void;
}

/** The chart in its host, whose size it follows. `height` is that of plot and axes [CSS pixels]. */
export function chart(host: HTMLElement, options: Omit<uPlot.Options, 'width' | 'height'>, data: uPlot.AlignedData): Chart {
  const size = () => ({ width: Math.max(host.clientWidth, 120), height: Math.max(host.clientHeight, 120) });
  const plot = new uPlot({ legend: { show: false }, pxAlign: 0, ...options, ...size() }, data, host);
  let wide = 0;
  new ResizeObserver(() => {
    const next = size();
    if (next.width === wide || host.clientWidth === 0) return;
    wide = next.width;
    plot.setSize(next);
  }).observe(host);
  const redraw = () => plot.redraw(false, false);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => requestAnimationFrame(() => plot.redraw(false, true)));
  return { plot, redraw };
}
