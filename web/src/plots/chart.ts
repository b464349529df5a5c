// A uPlot that fills its host, follows light and dark, goes with its host, and knows nothing of forces.
//
// Next door: what is drawn (`forces`, `spectrum`, `curves`).

import uPlot from 'uplot';
import { ink, look, type Look } from './looks';

/** How much larger than on a desk things are drawn: on a wall, words are larger, too. */
export const LARGER = parseFloat(getComputedStyle(document.documentElement).fontSize) / 16 || 1;

/** Words on a canvas of so many dots per pixel. */
export const font = (size = 12, ratio = 1): string => `${size * LARGER * ratio}px system-ui, sans-serif`;

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

/** Ticks of a logarithmic axis: 1 to 9 of each power of ten. uPlot's own never end where the lowest value is no such number. */
export function decades(low: number, high: number): number[] {
  const ticks: number[] = [];
  for (let power = Math.floor(Math.log10(low)); 10 ** power <= high; power++)
    for (let digit = 1; digit < 10; digit++) ticks.push(Number(`${digit}e${power}`));
  return ticks.filter((tick) => low <= tick && tick <= high);
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

/** The chart in its host, whose size it follows. `height` is that of plot and axes [CSS pixels]. */
export function chart(
  host: HTMLElement,
  options: Omit<uPlot.Options, 'width' | 'height'>,
  data: uPlot.AlignedData,
): uPlot {
  const size = () => ({ width: Math.max(host.clientWidth, 120), height: Math.max(host.clientHeight, 120) });
  const plot = new uPlot({ legend: { show: false }, pxAlign: 0, ...options, ...size() }, data, host);
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const repaint = () => requestAnimationFrame(() => plot.redraw(false, true));
  dark.addEventListener('change', repaint);
  let wide = 0;
  const sizes = new ResizeObserver(() => {
    const next = size();
    // Its host is gone: nothing may keep the chart and its data.
    if (!host.isConnected) {
      sizes.disconnect();
      dark.removeEventListener('change', repaint);
      return plot.destroy();
    }
    if (next.width === wide || host.clientWidth === 0) return;
    wide = next.width;
    plot.setSize(next);
  });
  sizes.observe(host);
  return plot;
}
