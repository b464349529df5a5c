// Sensors side by side: the errors over time of those that are ticked in the table, in one plot with one scale, and their numbers. It is there while
// two or more are ticked, so that the choice is part of the address and can be undone.
//
// Next door: when it is loaded (`open`), the table in which they are ticked (`results/table`), what they read (`plots/forces`).

import uPlot from 'uplot';
import type { Answer, ExactFacts } from '../answer';
import type { Shown } from '../compute';
import { digits, fixed, make, rich } from '../dom';
import { axis, curve, LARGER, plain } from '../plots/chart';
import { readings, type Line } from '../plots/lines';
import { called, ink, sample } from '../plots/looks';
import { mark } from '../results/table';
import css from '../style/compare.css?inline';
import { wear } from '../style/wear';
import type { Compare } from './open';

const HEADS = ['Sensor', 'rms', 'most', 'judged', 'u [N]', 'lag [ms]', 'goal'];

/** Series before the first error: time, both edges of the user's limit. */
const FIRST = 3;

export class Pair {
  private readonly host = make('div', {
    class: 'plot',
    role: 'img',
    'aria-label': 'Error of each ticked sensor over time',
  });
  private readonly keys = make('p', { class: 'keys' });
  private readonly body = make('tbody');
  private readonly words = make('p', { class: 'facts' });
  private readonly element: HTMLElement;
  private plot: uPlot | null = null;
  private shown: Shown | null = null;

  constructor(private readonly compare: Compare) {
    const { parts, store, compute, last } = compare.around;
    wear(css);
    this.element = make(
      'section',
      { class: 'card pair', 'aria-label': 'Sensors side by side', hidden: true },
      make('div', { class: 'head' }, make('h2', {}, 'Sensors side by side')),
      this.host,
      this.keys,
      make(
        'div',
        { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Numbers of the ticked sensors' },
        make(
          'table',
          {},
          make('thead', {}, make('tr', {}, ...HEADS.map((text) => make('th', { scope: 'col' }, text)))),
          this.body,
        ),
      ),
      this.words,
    );
    parts.table.closest('.card')?.after(this.element);
    store.subscribe(({ view }, before) => {
      if (view.sensors !== before.view.sensors) this.draw();
      // Readings are known of an exact case only.
      else if (store.state.spec !== before.spec) this.body.classList.add('stale');
    });
    compute.listen({ shown: (shown) => this.take(shown), refused: () => {}, busy: () => {} });
    compare.hearers.push(() => this.numbers());
    const shown = last();
    if (shown) this.take(shown);
  }

  private take(shown: Shown): void {
    const before = this.shown;
    this.shown = shown;
    // A preview has no readings: what stands there is marked once, and no picture is made for it.
    if (shown.exact) this.draw(before?.exact !== shown.exact);
    else this.wait();
  }

  private wait(): void {
    this.body.classList.add('stale');
    if (!this.element.hidden && this.plot && this.plot.data[0]?.length !== 0)
      this.plot.setData([[], ...Array.from({ length: this.plot.series.length - 1 }, () => [])] as uPlot.AlignedData);
  }

  private get lines(): Line[] {
    return readings(this.shown?.exact?.facts ?? null, this.compare.around.store.state.view.sensors);
  }

  private draw(isNew = true): void {
    const { exact, times } = this.shown ?? {};
    if (!exact || !times) return;
    const { lines } = this;
    this.element.hidden = lines.length < 2;
    if (this.element.hidden) return;
    this.plot ??= this.chart();
    if (isNew || this.plot.data[0]?.length === 0 || this.drawn !== names(lines)) this.curves(exact, lines);
    this.plot.setScale('x', { min: times[0], max: times[1] });
    this.numbers();
  }

  private drawn = '';

  private curves(exact: Answer<ExactFacts>, lines: readonly Line[]): void {
    const { plot } = this;
    if (!plot) return;
    this.drawn = names(lines);
    const { facts, series } = exact;
    const time = series['time'] ?? new Float64Array();
    const truth = series[facts.truth] ?? new Float64Array(time.length);
    const band = facts.goal;
    const edge = (value: number | null) => time.map(() => value ?? NaN);
    plot.batch(() => {
      this.addLines(plot, lines);
      const errors = Array.from({ length: plot.series.length - FIRST }, (_, number) => {
        const read = lines.some((line) => line.number === number) ? series[`reading ${number}`] : undefined;
        return truth.map((force, at) => (read?.[at] ?? NaN) - force);
      });
      const limits = [edge(band), edge(band === null ? null : -band)];
      plot.setData([time, ...limits, ...errors] as unknown as uPlot.AlignedData, false);
    });
    const limit = make('span', {}, make('i', { class: 'limit' }), 'within your limit');
    const key = ({ series: name, name: words }: Line) => make('span', {}, sample(name), make('span', {}, words));
    this.keys.replaceChildren(...lines.map(key), ...(band === null ? [] : [limit]));
  }

  /** A curve for each sensor up to the last that is ticked, as in the plot of forces: uPlot can hide curves, not drop them. */
  private addLines(plot: uPlot, lines: readonly Line[]): void {
    const last = Math.max(...lines.map(({ number }) => number));
    const paths = uPlot.paths.stepped?.({ align: 1 });
    while (plot.series.length <= FIRST + last) {
      const name = `reading ${plot.series.length - FIRST}`;
      plot.addSeries({ ...curve(name, name), width: 1.5 * LARGER, ...(paths ? { paths } : {}) });
    }
    plot.series.slice(FIRST).forEach((series, number) => {
      const show = lines.some((line) => line.number === number);
      if (series.show !== show) plot.setSeries(FIRST + number, { show });
    });
  }

  /** Over the shown times, as the plot; the judged part and the verdict beside it. */
  private numbers(): void {
    const { exact, times } = this.shown ?? {};
    const { lines } = this;
    if (!exact || !times || lines.length < 2) return;
    const { facts } = exact;
    const { outcome, failed } = this.compare.judgement;
    const percent = (force = NaN) => fixed((100 * force) / facts.spring.nominalForce, 3);
    const unknown = outcome || failed ? '–' : '…';
    const row = ({ number, name, series }: Line) => {
      const seen = errors(exact, series, times);
      // Of the verdict nothing is told before it is there.
      const ranked = outcome?.ranking.find(({ sensor }) => sensor === name);
      const cells = [
        [percent(seen.rms)],
        [percent(seen.most)],
        [percent(facts.sensors[number]?.deviation.rmsd)],
        [ranked ? digits(ranked.combined_n) : unknown],
        [ranked ? fixed(1e3 * ranked.lag_s, 2) : unknown],
        ranked ? mark(ranked.meets_goal) : [unknown],
      ];
      const heading = make('th', { scope: 'row' }, sample(series), name);
      return make('tr', { 'data-sensor': name }, heading, ...cells.map((cell) => make('td', {}, ...cell)));
    };
    this.body.classList.remove('stale');
    this.body.replaceChildren(...lines.map(row));
    const [from, to] = times.map((time) => fixed(1e3 * time, 0));
    this.words.replaceChildren(
      rich(
        `What each reads less ${called(facts.truth)}, on one scale: in % of F_nom = ${fixed(facts.spring.nominalForce, 1)} N from ${from} to ${to} ms as shown, and judged. u, lag and goal are the verdict’s, over all cases.`,
      ),
    );
  }

  private chart(): uPlot {
    const edge = { stroke: () => 'transparent', points: { show: false }, width: 0 };
    const { timeline } = this.compare.around.forces;
    return timeline.add(
      this.host,
      {
        scales: { y: { range: (_, low, high) => uPlot.rangeNum(low ?? -1, high ?? 1, 0.08, false) } },
        axes: [
          axis('Time [ms]', 36, { values: (_, ticks) => ticks.map((tick) => plain(1e3 * tick)), space: 60 * LARGER }),
          axis('Error [N]', 62, { space: 34 * LARGER, values: (_, ticks) => ticks.map(plain) }),
        ],
        series: [{}, edge, edge],
        bands: [{ series: [1, 2], fill: () => ink.band }],
      },
      [[], [], []] as unknown as uPlot.AlignedData,
    );
  }
}

const names = (lines: readonly Line[]): string => JSON.stringify(lines.map(({ series }) => series));

/** How far a reading is off between two times, rms and at most [N]. */
export function errors({ facts, series }: Answer<ExactFacts>, reading: string, [from, to]: [number, number]) {
  const [time, truth, read] = ['time', facts.truth, reading].map((name) => series[name] ?? new Float64Array());
  let [sum, most, count] = [0, 0, 0];
  time?.forEach((at, index) => {
    if (at < from || at > to) return;
    const error = (read?.[index] ?? NaN) - (truth?.[index] ?? NaN);
    sum += error * error;
    most = Math.max(most, Math.abs(error));
    count++;
  });
  return { rms: Math.sqrt(sum / count), most };
}
