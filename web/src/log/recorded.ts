// The log as it was dropped: each quantity over time, the hits marked; a part of it chosen by dragging or by buttons, the same for all.
//
// Next door: which channels there are (`coilsense-web`, `log/recorded`), what they say (`found`).

import uPlot from 'uplot';
import type { Series } from '../answer';
import { make, rich } from '../dom';
import { axis, chart, curve, LARGER, plain } from '../plots/chart';
import { ink, look, sample, type Look } from '../plots/looks';
import { button, card } from './found';
import type { Recorded } from './identification';

/** Times [s]; none for the whole log. */
export interface Range {
  min: number;
  max: number;
}

interface Curve {
  label: string;
  look: string | Look;
  values: Float64Array;
}

interface Quantity {
  title: string;
  label: string;
  curves: Curve[];
}

const U1: Look = { colour: 'blue', dash: [], width: 1.2 };
const U2: Look = { colour: 'red', dash: [], width: 1.2 };

const [least, most] = [Math.min, Math.max].map(
  (pick) => (values: Float64Array) => values.reduce((a, b) => pick(a, b), values[0] ?? 0),
) as [(values: Float64Array) => number, (values: Float64Array) => number];

/** What is drawn of a log, in the units of the page. */
function quantities(series: Series): Quantity[] {
  const of = (name: string, factor: number) => series[`recorded ${name}`]?.map((value) => factor * value);
  const positions = (['u1', 'u2'] as const).flatMap((name) => {
    const values = of(name, 1e3);
    return values ? [{ name, values, look: name === 'u1' ? U1 : U2 }] : [];
  });
  // Two ends are farther apart than either moves: each is then drawn about its middle.
  const spread = Math.max(...positions.map(({ values }) => most(values) - least(values)));
  const middles = positions.map(({ values }) => Math.round((most(values) + least(values)) / 2));
  const apart = positions.length === 2 && Math.abs((middles[0] ?? 0) - (middles[1] ?? 0)) > spread;
  const moved = positions.map(({ name, values, look }, index) => {
    const middle = apart ? (middles[index] ?? 0) : 0;
    const sign = middle < 0 ? '+' : '−';
    return {
      label: middle === 0 ? name : `${name} ${sign} ${Math.abs(middle)} mm`,
      look,
      values: values.map((value) => value - middle),
    };
  });
  const forces = ['F_i', 'F_o', 'F_x', 'F_L'].flatMap((name) => {
    const values = of(name, 1);
    return values ? [{ label: name, look: name, values }] : [];
  });
  const henries = of('L', 1e6);
  const all = [
    { title: 'Forces', label: 'Force [N]', curves: forces },
    { title: 'Positions', label: 'Position [mm]', curves: moved },
    { title: 'Inductance', label: 'L [µH]', curves: henries ? [{ label: 'L', look: 'F_x', values: henries }] : [] },
  ];
  return all.filter(({ curves }) => curves.length > 0);
}

/** `kept` is the part that was shown before, `keep` hears of another. */
export function showRecorded(
  host: HTMLElement,
  facts: Recorded,
  series: Series,
  kept: Range | null,
  keep: (range: Range | null) => void,
): void {
  const time = series['recorded time'] ?? new Float64Array();
  const whole = { min: time[0] ?? 0, max: time[time.length - 1] ?? 1 };
  let shown = whole;
  const plots: uPlot[] = [];
  const said = make('span', { class: 'hint', 'aria-live': 'polite' });
  const show = (min: number, max: number) => {
    const wide = Math.min(Math.max(max - min, 1e-4 * (whole.max - whole.min)), whole.max - whole.min);
    const from = Math.min(Math.max(min, whole.min), whole.max - wide);
    shown = { min: from, max: from + wide };
    keep(wide < whole.max - whole.min ? shown : null);
    for (const plot of plots) plot.setScale('x', shown);
    const short = (value: number) => plain(Number(value.toFixed(4)));
    said.textContent = `${short(shown.min)} s to ${short(shown.max)} s`;
  };
  const by = (label: string, title: string, factor: number, shift: number) => {
    const one = button(label, () => {
      const half = (factor * (shown.max - shown.min)) / 2;
      const middle = (shown.max + shown.min) / 2 + shift * (shown.max - shown.min);
      show(middle - half, middle + half);
    });
    one.setAttribute('aria-label', title);
    return one;
  };
  const tools = make(
    'div',
    { class: 'downloads', role: 'group', 'aria-label': 'Which part is shown' },
    button('Whole log', () => show(whole.min, whole.max)),
    by('+', 'Zoom in', 0.5, 0),
    by('−', 'Zoom out', 2, 0),
    by('←', 'Earlier', 1, -0.4),
    by('→', 'Later', 1, 0.4),
    said,
  );
  const hits = facts.hits ?? [];
  const all = quantities(series);
  const hosts = all.map(() => make('div', { class: 'plot recorded', role: 'img' }));
  const figures = all.map(({ title, curves }, index) => {
    hosts[index]?.setAttribute('aria-label', `${title} over time`);
    const keys = curves.map(({ label, look: name }) =>
      make('span', {}, sample({ ...look(name), dash: [] }), make('span', {}, rich(label))),
    );
    return make(
      'figure',
      {},
      make('figcaption', {}, make('b', {}, title), make('span', { class: 'keys' }, ...keys)),
      hosts[index],
    );
  });
  const thinned = facts.group > 1 ? ` Of each ${facts.group} rows the smallest and the largest value are drawn.` : '';
  const struck = hits.length > 0 ? `${hits.length} hits were found, ▾ above the forces. ` : '';
  const hint = `${struck}Drag across a plot to zoom, double-click to go back.${thinned}`;
  host.replaceChildren(card('What was recorded', tools, make('p', { class: 'hint' }, hint), ...figures));
  all.forEach(({ label, curves }, index) => {
    const plotHost = hosts[index];
    if (plotHost) {
      const back = () => show(whole.min, whole.max);
      plots.push(draw(plotHost, label, time, curves, hits, index === all.length - 1, show, back));
    }
  });
  show(kept?.min ?? whole.min, kept?.max ?? whole.max);
}

function draw(
  host: HTMLElement,
  label: string,
  time: Float64Array,
  curves: Curve[],
  hits: number[],
  isLast: boolean,
  show: (min: number, max: number) => void,
  back: () => void,
): uPlot {
  const chosen = (plot: uPlot) => {
    const { left, width } = plot.select;
    if (width < 4) return;
    show(plot.posToVal(left, 'x'), plot.posToVal(left + width, 'x'));
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  };
  const forces = label.startsWith('Force');
  return chart(
    host,
    {
      scales: { x: { time: false, auto: false } },
      hooks: { setSelect: [chosen], draw: [(plot) => mark(plot, hits, forces)] },
      cursor: {
        drag: { x: true, y: false, setScale: false },
        points: { show: false },
        y: false,
        bind: { dblclick: () => () => (back(), null) },
      },
      axes: [
        axis('Time [s]', isLast ? 36 : 22, { space: 60 * LARGER, ...(isLast ? {} : { labelSize: 0, label: '' }) }),
        axis(label, 60, { space: 22 * LARGER, values: (_, ticks) => ticks.map(plain) }),
      ],
      series: [{}, ...curves.map(({ look, label }) => ({ ...curve(look, label), dash: [], width: LARGER }))],
    },
    [time, ...curves.map(({ values }) => values)] as unknown as uPlot.AlignedData,
  ).plot;
}

/** Where it was struck: a thin line through all plots, an arrow head above the forces. */
function mark(plot: uPlot, hits: number[], heads: boolean): void {
  const { ctx, bbox, scales } = plot;
  const ratio = devicePixelRatio || 1;
  const { min = 0, max = 1 } = scales['x'] ?? {};
  ctx.save();
  ctx.strokeStyle = ink.soft;
  ctx.fillStyle = ink.ink;
  ctx.lineWidth = ratio;
  ctx.setLineDash([2 * ratio, 4 * ratio]);
  for (const hit of hits) {
    if (hit < (min ?? 0) || hit > (max ?? 0)) continue;
    const x = plot.valToPos(hit, 'x', true);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    if (!heads) continue;
    const size = 5 * ratio * LARGER;
    ctx.beginPath();
    ctx.moveTo(x - size, bbox.top);
    ctx.lineTo(x + size, bbox.top);
    ctx.lineTo(x, bbox.top + 1.4 * size);
    ctx.fill();
  }
  ctx.restore();
}
