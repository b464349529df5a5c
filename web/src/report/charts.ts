// The charts of a case: forces, their errors with the goal as a band, and how far the ends move. Each has a sentence that says what it shows.
//
// Next door: which times they show, and the mark (`plots/timeline`), the numbers (`table`).

import uPlot from 'uplot';
import { clamp, digits, fixed, make, rich } from '../dom';
import { axis, curve, LARGER, plain } from '../plots/chart';
import { ink } from '../plots/looks';
import type { Timeline } from '../plots/timeline';
import { extent, type Case, type Report, type Signal } from './data';

interface Chart {
  title: string;
  unit: string;
  sentence: string;
  lines: { signal: Signal; values: Float64Array }[];
  /** Of errors, which are drawn about zero and told in percent, too: what is allowed [N]. */
  goal?: number | null;
}

/** From so many pixels on there is room for the errors in percent at the right. */
export const WIDE = 560;
const RIGHT = 62;

const list = (parts: string[]): string =>
  parts.length < 2 ? parts.join('') : `${parts.slice(0, -1).join(', ')} and ${parts[parts.length - 1]}`;

/** `condition, damping`. */
export const caseName = ({ packed }: Case): string => `${packed.condition}, ${packed.damping}`;

/** What of a report is drawn, and who hears of it. */
export interface Drawn {
  report: Report;
  shown: Case;
  /** Names of what is not drawn. */
  hidden: ReadonlySet<string>;
  /** Hears where the pointer is [s], null beside all plots. */
  pointed(time: number | null): void;
}

/** Draws the charts into a host and a timeline; each plot comes with the signals of its lines. */
export function drawCharts(host: HTMLElement, timeline: Timeline, drawn: Drawn): { plot: uPlot; signals: Signal[] }[] {
  const { report, shown } = drawn;
  const charts = [...forces(shown), ...errors(report, shown), ...positions(shown)];
  const left = Math.max(...charts.flatMap(({ lines }) => lines.map(({ values }) => room(values))));
  host.replaceChildren();
  return charts.flatMap((chart) => {
    const { title, sentence, lines, goal } = chart;
    if (lines.length === 0) {
      host.append(make('p', { class: 'note' }, rich(sentence)));
      return [];
    }
    const place = make('div', { class: 'plot', tabindex: 0, role: 'group', 'aria-roledescription': 'chart' });
    place.setAttribute('aria-label', `${sentence} Arrows move the mark, plus and minus zoom, Escape shows all.`);
    const limit = goal ? make('span', {}, make('i', { class: 'limit' }), `goal ±${digits(goal, 4)} N`) : null;
    const percent = goal === undefined ? null : make('span', { class: 'percent' }, rich('[% of F_nom]'));
    host.append(
      make(
        'figure',
        { class: 'chart' },
        make('div', { class: 'head' }, make('b', {}, rich(title)), limit, percent),
        place,
        make('figcaption', {}, rich(sentence)),
      ),
    );
    const data = [shown.times, ...lines.map(({ values }) => gaps(values))] as unknown as uPlot.AlignedData;
    return [
      { plot: timeline.add(place, options(chart, left, drawn), data), signals: lines.map(({ signal }) => signal) },
    ];
  });
}

/** A gap is nothing at all for the plot. */
const gaps = (values: Float64Array): ArrayLike<number | null> =>
  values.some(Number.isNaN) ? Array.from(values, (value) => (Number.isNaN(value) ? null : value)) : values;

/** How wide the numbers of an axis are that shows these [pixels]. */
function room(values: Float64Array): number {
  const [low, high] = extent(values) ?? [0, 1];
  const decimals = high > low ? clamp(1 - Math.floor(Math.log10(high - low)), 0, 9) : 2;
  return clamp(32 + 7 * Math.max(fixed(low, decimals).length, fixed(high, decimals).length), 58, 118);
}

function forces(shown: Case): Chart[] {
  const those = shown.signals.filter(({ kind, values }) => kind === 'force' && extent(values));
  if (those.length === 0) return [];
  const bounds = those.flatMap(({ values }) => extent(values) ?? []);
  const decimals = those[0]?.decimals ?? 0;
  const [low, high] = [fixed(Math.min(...bounds), decimals), fixed(Math.max(...bounds), decimals)];
  const { times } = shown;
  const when = `from ${plain(1e3 * (times[0] ?? 0))} to ${plain(1e3 * (times[times.length - 1] ?? 0))} ms`;
  return [
    {
      title: 'Forces',
      unit: 'Force [N]',
      sentence: `Forces, ${caseName(shown)}: between ${low} and ${high} N ${when}.`,
      lines: those.map((signal) => ({ signal, values: signal.values })),
    },
  ];
}

function errors({ reference }: Report, shown: Case): Chart[] {
  const lines = shown.signals.flatMap((signal) => (signal.error ? [{ signal, values: signal.error }] : []));
  if (lines.length === 0) return [];
  const goal = shown.packed.goal_n;
  const judged = lines.map(({ signal }) => signal);
  const worst = list(judged.map(({ name, worst }) => `${name} ${fixed(worst, shown.decimals)} N`));
  const good = judged.filter(({ worst }) => goal !== null && worst <= goal).map(({ name }) => name);
  const met = good.length === 0 ? 'none of them' : good.length === judged.length ? 'all of them' : list(good);
  const said =
    goal === null
      ? ''
      : `; every moment lies within ±${digits(goal, 4)} N for ${met} (the goal itself counts only what falls into the wanted band)`;
  return [
    {
      title: `Error against ${reference}`,
      unit: 'Error [N]',
      sentence: `Largest error against ${reference}: ${worst}${said}.`,
      lines,
      goal,
    },
  ];
}

function positions(shown: Case): Chart[] {
  const those = shown.signals.filter(({ kind }) => kind === 'position');
  if (those.length === 0) return [];
  const moved = those.map(({ name, values }) => {
    const [low, high] = extent(values) ?? [0, 0];
    return { name, by: high - low };
  });
  const title = 'Change of position';
  const still = moved.every(({ by }) => by < 1e-9);
  const lines = those.map((signal) => {
    const first = signal.values.find((value) => !Number.isNaN(value)) ?? 0;
    return { signal, values: signal.values.map((value) => value - first) };
  });
  const spans = list(moved.map(({ name, by }) => `${name} by ${digits(by, 4)} mm`));
  const said = still
    ? `${list(moved.map(({ name }) => name))} ${moved.length > 1 ? 'do' : 'does'} not change`
    : `from lowest to highest, ${spans}`;
  return [{ title, unit: 'Change [mm]', sentence: `${title}: ${said}.`, lines: still ? [] : lines }];
}

function options(
  { lines, unit, goal }: Chart,
  left: number,
  { report: { nominal_force_n: nominal }, hidden, pointed }: Drawn,
): Omit<uPlot.Options, 'width' | 'height'> {
  const right = ({ width }: uPlot) => (width < WIDE ? 12 : RIGHT);
  const percent = axis('', 0, {
    scale: 'percent',
    side: 1,
    labelSize: 0,
    size: right,
    grid: { show: false },
    ticks: { show: false },
    values: ({ width }, ticks) => (width < WIDE ? [] : ticks.map(plain)),
  });
  const isError = goal !== undefined;
  const ofNominal: uPlot.Scale = {
    from: 'y',
    range: (_, low, high) => [(100 * (low ?? 0)) / nominal, (100 * (high ?? 0)) / nominal],
  };
  return {
    // All plots stand below each other, those without percent, too.
    padding: [8, isError ? 0 : right, 0, 0],
    scales: {
      y: { range: (_, low, high) => uPlot.rangeNum(...withGoal(low ?? 0, high ?? 1, goal ?? 0), 0.06, false) },
      ...(isError ? { percent: ofNominal } : {}),
    },
    axes: [
      axis('Time [ms]', 36, { values: (_, ticks) => ticks.map((tick) => plain(1e3 * tick)), space: 60 * LARGER }),
      axis(unit, left, { space: 34 * LARGER, values: (_, ticks) => ticks.map(plain) }),
      ...(isError ? [percent] : []),
    ],
    series: [{}, ...lines.map(({ signal: { name, look } }) => ({ ...curve(look, name), show: !hidden.has(name) }))],
    cursor: { sync: { key: 'coilsense', scales: ['x', null] }, points: { size: 6 } },
    hooks: {
      drawClear: [(plot) => drawGoal(plot, goal ?? 0)],
      setCursor: [({ cursor, data }) => pointed((cursor.left ?? -1) < 0 ? null : (data[0][cursor.idx ?? 0] ?? null))],
    },
  };
}

/** The goal's limits belong to the picture unless they would flatten what is in it. */
function withGoal(low: number, high: number, goal: number): [number, number] {
  if (goal === 0) return [low, high];
  const most = Math.max(-low, high, 0);
  const shown = most > 0 ? Math.min(goal * 1.05, 4 * most) : goal * 1.05;
  return [Math.min(low, -shown), Math.max(high, shown)];
}

function drawGoal(plot: uPlot, goal: number): void {
  if (goal === 0) return;
  const { ctx, bbox } = plot;
  const place = (value: number) => clamp(plot.valToPos(value, 'y', true), bbox.top, bbox.top + bbox.height);
  ctx.save();
  ctx.fillStyle = ink.band;
  ctx.fillRect(bbox.left, place(goal), bbox.width, place(-goal) - place(goal));
  ctx.fillStyle = ink.accent;
  for (const value of [-goal, goal]) ctx.fillRect(bbox.left, place(value) - 0.5, bbox.width, devicePixelRatio);
  ctx.restore();
}
