// The log as it was dropped: each quantity over time, the hits marked; a part of it chosen by dragging or by buttons, the same for all.
//
// Next door: which channels there are (`coilsense-web`, `log/recorded`), what they say (`found`).

import type uPlot from 'uplot';
import type { Series } from '../answer';
import { make, rich } from '../dom';
import { Told } from '../told';
import { axis, curve, LARGER, plain } from '../plots/chart';
import { ink, look, sample } from '../plots/looks';
import { Timeline, type Times } from '../plots/timeline';
import { button, card } from './found';
import type { Recorded } from './identification';

interface Curve {
  label: string;
  look: string;
  values: Float64Array;
}

interface Quantity {
  title: string;
  label: string;
  curves: Curve[];
}

const [least, most] = [Math.min, Math.max].map(
  (pick) => (values: Float64Array) => values.reduce((a, b) => pick(a, b), values[0] ?? 0),
) as [(values: Float64Array) => number, (values: Float64Array) => number];

/** What is drawn of a log, in the units of the page. */
function quantities(series: Series): Quantity[] {
  const of = (name: string, factor: number) => series[`recorded ${name}`]?.map((value) => factor * value);
  const positions = (['u1', 'u2'] as const).flatMap((name) => {
    const values = of(name, 1e3);
    return values ? [{ name, values }] : [];
  });
  // Two ends are farther apart than either moves: each is then drawn about its middle.
  const spread = Math.max(...positions.map(({ values }) => most(values) - least(values)));
  const middles = positions.map(({ values }) => Math.round((most(values) + least(values)) / 2));
  const apart = positions.length === 2 && Math.abs((middles[0] ?? 0) - (middles[1] ?? 0)) > spread;
  const moved = positions.map(({ name, values }, index) => {
    const middle = apart ? (middles[index] ?? 0) : 0;
    const sign = middle < 0 ? '+' : '−';
    return {
      label: middle === 0 ? name : `${name} ${sign} ${Math.abs(middle)} mm`,
      look: name,
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

/** The smallest part that can be shown, of all of it [1]. */
const LEAST = 1e-4;

/** `kept` is the part that was shown before, none for the whole log; `keep` hears of another. */
export function showRecorded(
  host: HTMLElement,
  facts: Recorded,
  series: Series,
  kept: Times | null,
  keep: (times: Times | null) => void,
): void {
  const time = series['recorded time'] ?? new Float64Array();
  const whole: Times = [time[0] ?? 0, time[time.length - 1] ?? 1];
  const said = make('span', { class: 'hint', 'aria-live': 'polite' });
  const told = new Told(said);
  const show = (times: Times | null) => {
    const [from, to] = times ?? whole;
    timeline.show([from, to], whole, LEAST * (whole[1] - whole[0]));
    keep(to - from < whole[1] - whole[0] ? [from, to] : null);
    const short = (value: number) => plain(Number(value.toFixed(4)));
    told.tell(`${short(from)} s to ${short(to)} s`);
  };
  const timeline = new Timeline({ zoom: show, point: () => {} });
  const by = (label: string, title: string, factor: number, shift: number) => {
    const one = button(label, () => timeline.zoomBy(factor, shift));
    one.setAttribute('aria-label', title);
    return one;
  };
  const tools = make(
    'div',
    { class: 'downloads', role: 'group', 'aria-label': 'Which part is shown' },
    button('Whole log', () => show(null)),
    by('+', 'Zoom in', 2, 0),
    by('−', 'Zoom out', 0.5, 0),
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
    if (plotHost) draw(timeline, plotHost, label, time, curves, hits, index === all.length - 1);
  });
  show(kept);
}

function draw(
  timeline: Timeline,
  host: HTMLElement,
  label: string,
  time: Float64Array,
  curves: Curve[],
  hits: number[],
  isLast: boolean,
): void {
  const forces = label.startsWith('Force');
  timeline.add(
    host,
    {
      hooks: { draw: [(plot) => mark(plot, hits, forces)] },
      axes: [
        axis('Time [s]', isLast ? 36 : 22, { space: 60 * LARGER, ...(isLast ? {} : { labelSize: 0, label: '' }) }),
        axis(label, 60, { space: 22 * LARGER, values: (_, ticks) => ticks.map(plain) }),
      ],
      series: [{}, ...curves.map(({ look, label }) => ({ ...curve(look, label), dash: [], width: LARGER }))],
    },
    [time, ...curves.map(({ values }) => values)] as unknown as uPlot.AlignedData,
  );
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
