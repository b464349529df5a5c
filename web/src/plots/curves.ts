// A still chart of named curves with a legend, for pages that compute once.

import type uPlot from 'uplot';
import { make, rich } from '../dom';
import { axis, chart, curve, plain } from './chart';
import { sample } from './looks';

export interface Curves {
  title: string;
  x: { label: string; values: Float64Array; factor?: number };
  y: { label: string; logarithmic?: boolean; range?: [number, number] };
  /** Drawn in the look of a force. */
  curves: { look: string; label: string; values: Float64Array }[];
}

export function curves(host: HTMLElement, { title, x, y, curves: lines }: Curves): void {
  const legend = lines.map(({ look, label }) => make('span', {}, sample(look), make('span', {}, rich(label))));
  const plot = make('div', { class: 'plot', role: 'img', 'aria-label': title });
  host.append(make('figure', {}, make('figcaption', {}, make('b', {}, title), make('span', { class: 'keys' }, ...legend)), plot));
  const factor = x.factor ?? 1;
  const scale: uPlot.Scale = { distr: y.logarithmic ? 3 : 1, ...(y.range ? { range: y.range } : {}) };
  const decade = (ticks: number[]) => ticks.map((tick) => (/^(0\.0*1|10*)$/.test(String(tick)) ? String(tick) : ''));
  chart(
    plot,
    {
      scales: { x: { time: false }, y: scale },
      cursor: { drag: { x: false, y: false }, points: { show: false }, y: false },
      axes: [
        axis(x.label, 36, { values: (_, ticks) => ticks.map((tick) => plain(factor * tick)) }),
        axis(y.label, 60, { values: (_, ticks) => (y.logarithmic ? decade(ticks) : ticks.map(plain)) }),
      ],
      series: [
        {},
        ...lines.map(({ look, label }) => curve(look, label)),
      ],
    },
    [x.values, ...lines.map(({ values }) => values)] as unknown as uPlot.AlignedData,
  );
}
