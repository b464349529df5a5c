// A uPlot that fills its host, follows light and dark, and knows nothing of forces.
//
// Next door: what is drawn (`forces`, `spectrum`, `paper`).

import uPlot from 'uplot';
import { ink, look, type Look } from './looks';

/** How much larger than on a desk things are drawn: on a wall, words are larger, too. */
export const LARGER = parseFloat(getComputedStyle(document.documentElement).fontSize) / 16 || 1;

/** Words on a canvas of so many dots per pixel. */
export const font = (size = 12, ratio = 1): string =>
  `${size * LARGER * ratio}px system-ui, -apple-system, "Segoe UI", Roboto, Arial, sans-serif`;

/** An axis with the page's colours; `label` with its unit, `size` its width beside the plot [pixels of a desk]. */
export function axis(label: string, size: number, more: Partial<uPlot.Axis> = {}): uPlot.Axis {
  return {
    label,
    labelFont: font(),
    font: font(),
    size: size * LARGER,
    labelSize: 18 * LARGER,
    stroke: () => ink.soft,
    grid: { stroke: () => ink.line, width: 1 },
    ticks: { stroke: () => ink.line, width: 1, size: 5 },
    ...more,
  };
}

/** A tick as people read it. */
export const plain = (tick: number): string => String(Number(tick.toPrecision(10))).replace('-', '−');

/** A curve in the look of a name. */
export function curve(name: string | Look, label: string): uPlot.Series {
  const { colour, dash, width } = look(name);
  return {
    label,
    stroke: () => ink[colour as keyof typeof ink],
    width: width * LARGER,
    dash: dash.map((part) => part * LARGER),
    points: { show: false },
  };
}

export interface Chart {
  plot: uPlot;
  /** The same picture again: colours or overlays have changed. */
  redraw(): void;
}

/** The chart in its host, whose size it follows. `height` is that of plot and axes [CSS pixels]. */
export function chart(
  host: HTMLElement,
  options: Omit<uPlot.Options, 'width' | 'height'>,
  data: uPlot.AlignedData,
): Chart {
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
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () =>
    requestAnimationFrame(() => plot.redraw(false, true)),
  );
  return { plot, redraw };
}
