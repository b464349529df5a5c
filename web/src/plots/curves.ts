// A still chart of named curves with a legend, for pages that compute once.

import type uPlot from 'uplot';
import { make, rich } from '../dom';
import { axis, chart, curve, decades, font, plain } from './chart';
import { ink, look, sample, type Look } from './looks';

/** More dots than these are drawn small. */
const MANY = 500;

export interface Curves {
  title: string;
  x: { label: string; values: Float64Array; factor?: number };
  y: { label: string; logarithmic?: boolean; range?: [number, number] };
  /** Drawn in the look of a force or one of their own; as dots, hollow ones too, or across points without a value, where that is asked for. */
  curves: {
    look: string | Look;
    label: string;
    values: ArrayLike<number | null>;
    dots?: boolean | 'hollow';
    spans?: boolean;
  }[];
  /** Upright lines with a name. */
  marks?: { x: number; label: string }[];
}

export function curves(
  host: HTMLElement,
  { title, x, y, curves: lines, marks = [] }: Curves,
  ...plugins: uPlot.Plugin[]
): void {
  const legend = lines.map(({ look: name, label, dots }) =>
    make('span', {}, dots ? disc(name, dots) : sample(name), make('span', {}, rich(label))),
  );
  const plot = make('div', { class: 'plot', role: 'img', 'aria-label': title });
  host.append(
    make(
      'figure',
      {},
      make('figcaption', {}, make('b', {}, rich(title)), make('span', { class: 'keys' }, ...legend)),
      plot,
    ),
  );
  const factor = x.factor ?? 1;
  const scale: uPlot.Scale = { distr: y.logarithmic ? 3 : 1, ...(y.range ? { range: y.range } : {}) };
  const decade = (ticks: number[]) => ticks.map((tick) => (/^(0\.0*1|10*)$/.test(String(tick)) ? String(tick) : ''));
  chart(
    plot,
    {
      plugins,
      scales: { x: { time: false, ...(lines.some(({ dots }) => dots) ? { range: roomy } : {}) }, y: scale },
      hooks: { draw: [(drawn) => draw(drawn, marks)] },
      cursor: { drag: { x: false, y: false }, points: { show: false }, y: false },
      axes: [
        axis(x.label, 36, { values: (_, ticks) => ticks.map((tick) => plain(factor * tick)) }),
        axis(y.label, 60, {
          ...(y.logarithmic ? { splits: (_, __, low, high) => decades(low, high) } : {}),
          values: (_, ticks) => (y.logarithmic ? decade(ticks) : ticks.map(plain)),
        }),
      ],
      series: [
        {},
        ...lines.map(({ look: name, label, values, dots, spans = false }): uPlot.Series => {
          const stroke = () => ink[look(name).colour as keyof typeof ink];
          return dots
            ? {
                label,
                stroke,
                paths: () => null,
                points: {
                  show: true,
                  size: values.length > MANY ? 4 : 8,
                  width: values.length > MANY ? 1 : 2,
                  fill: dots === 'hollow' ? () => ink.ground : stroke,
                },
              }
            : { ...curve(name, label), spanGaps: spans };
        }),
      ],
    },
    [x.values, ...lines.map(({ values }) => values)] as unknown as uPlot.AlignedData,
  );
}

/** Dots at the ends are not to be cut. */
const roomy = (_: uPlot, low: number, high: number): [number, number] => {
  const room = 0.04 * (high - low || 1);
  return [low - room, high + room];
};

/** Marks with their names above each other where they would meet. */
function draw({ ctx, bbox, scales, valToPos }: uPlot, marks: { x: number; label: string }[]): void {
  const ratio = devicePixelRatio || 1;
  const { min = 0, max = 1 } = scales['x'] ?? {};
  ctx.save();
  ctx.font = font(11, ratio);
  ctx.textBaseline = 'top';
  ctx.textAlign = 'left';
  marks.forEach(({ x, label }, index) => {
    if (x < (min ?? 0) || x > (max ?? 0)) return;
    const at = valToPos(x, 'x', true);
    ctx.strokeStyle = ink.soft;
    ctx.setLineDash([3 * ratio, 3 * ratio]);
    ctx.beginPath();
    ctx.moveTo(at, bbox.top);
    ctx.lineTo(at, bbox.top + bbox.height);
    ctx.stroke();
    ctx.fillStyle = ink.ink;
    // To the left where there is no room to the right; what fits neither is named elsewhere.
    const [wide, gap] = [ctx.measureText(label).width, 3 * ratio];
    const left = at + gap + wide <= bbox.left + bbox.width ? at + gap : at - gap - wide;
    if (left >= bbox.left) ctx.fillText(label, left, bbox.top + (2 + 13 * (index % 3)) * ratio);
  });
  ctx.restore();
}

/** A dot, as in a legend. */
function disc(name: string | Look, dots: true | 'hollow'): HTMLElement {
  const dot = make('span', { class: 'disc', 'aria-hidden': 'true' });
  const colour = `var(--${look(name).colour})`;
  dot.style.border = `2px solid ${colour}`;
  if (dots !== 'hollow') dot.style.background = colour;
  return dot;
}
