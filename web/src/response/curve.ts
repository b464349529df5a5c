// The forces of both ends over frequency, over the one at the driven end or over k times its motion, with a dot on each curve where it is looked at.
//
// Next door: what is looked at (`choice`), what it says in words (`words`).

import type uPlot from 'uplot';
import type { Answer, CurveFacts, PointFacts, Polar } from '../answer';
import { clamp, make, rich } from '../dom';
import { axis, chart, curve, decades, font, LARGER, plain } from '../plots/chart';
import { ink, look, sample, type Colour } from '../plots/looks';
import { names } from './words';

/** What the forces are divided by. */
export type Over = 'own' | 'motion';

/** The axis reaches at most from one to the other: undamped, a force has no limit, and where it vanishes there is no logarithm. */
const LEAST = 1e-3;
const MOST = 1e3;

interface Line {
  force: string;
  label: string;
  series: string;
  at: (facts: PointFacts) => Polar;
}

const linesOf = ({ driven, isMoved }: CurveFacts, over: Over): Line[] => {
  const { own, other } = names(driven);
  if (over === 'own')
    return [
      { force: other, label: `${other} / ${own}`, series: 'through', at: (facts) => facts.through },
      { force: 'F_x', label: `F_x / ${own}`, series: 'length', at: (facts) => facts.lengthOverOwn },
    ];
  const by = isMoved ? 'k × motion' : own;
  return [
    { force: own, label: `${own} / ${by}`, series: 'own', at: (facts) => facts.own },
    { force: other, label: `${other} / ${by}`, series: 'other', at: (facts) => facts.other },
    { force: 'F_x', label: `F_x / ${by}`, series: 'by length', at: (facts) => facts.byLength },
  ];
};

export class Curve {
  readonly element = make('figure', { class: 'response' });
  private drawn: uPlot | null = null;
  private lines: Line[] = [];
  private frequency = 0;
  /** What the engine has at that frequency; until it has, the dots are where the curves are drawn. */
  private point: PointFacts | null = null;
  private drawnAt: Float64Array[] = [];

  /** `pick` hears which frequency was pointed at [Hz], and whether the hand has let go. */
  constructor(private readonly pick: (frequency: number, isDone: boolean) => void) {}

  show({ facts, series }: Answer<CurveFacts>, over: Over): void {
    this.lines = linesOf(facts, over);
    [this.frequency, this.point] = [0, null];
    const legend = this.lines.map(({ force, label }) => make('span', {}, sample(force), make('span', {}, rich(label))));
    const title = `${this.lines.map(({ label }) => label).join(', ')} over frequency, both logarithmic`;
    const plot = make('div', { class: 'plot', role: 'img', 'aria-label': title });
    this.element.replaceChildren(make('figcaption', { class: 'keys' }, ...legend), plot);
    const values = this.lines.map((line) => series[line.series] ?? new Float64Array());
    this.drawnAt = [series['frequency'] ?? new Float64Array(), ...values];
    this.drawn = chart(
      plot,
      {
        scales: { x: { time: false, distr: 3, range: facts.range }, y: { distr: 3, range: reach(values) } },
        cursor: { drag: { x: false, y: false }, points: { show: false }, y: false, x: false },
        axes: [
          axis(
            'Frequency [Hz]',
            36,
            logarithmic((tick) => /^[125]/.test(tick.toExponential())),
          ),
          axis(
            'Size [1]',
            58,
            logarithmic((tick) => /^1e/.test(tick.toExponential())),
          ),
        ],
        series: [{}, ...this.lines.map(({ force, label }) => curve(force, label))],
        hooks: {
          drawAxes: [(drawn) => behind(drawn, facts)],
          draw: [(drawn) => this.dots(drawn)],
          ready: [(drawn) => this.listen(drawn)],
        },
      },
      // Beyond the axis is beyond it, whatever the number.
      [
        series['frequency'],
        ...values.map((each) => each.map((value) => clamp(value, 1e-9, 1e9))),
      ] as unknown as uPlot.AlignedData,
    );
  }

  /** Puts the dots at a frequency, at once: the engine may take as long as it takes to read a recorded motion. */
  follow(frequency: number): void {
    this.frequency = frequency;
    this.point = null;
    this.drawn?.redraw(false, false);
  }

  /** Puts the dots where the engine has them. */
  mark(point: PointFacts): void {
    // A newer frequency is on its way.
    if (point.frequency !== this.frequency) return;
    this.point = point;
    this.drawn?.redraw(false, false);
  }

  /** A click or a drag says where it is looked at. */
  private listen({ over, posToVal }: uPlot): void {
    const at = ({ clientX }: PointerEvent, isDone: boolean) => {
      const { left, width } = over.getBoundingClientRect();
      this.pick(posToVal(clamp(clientX - left, 0, width), 'x'), isDone);
    };
    over.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      over.setPointerCapture(event.pointerId);
      at(event, false);
    });
    over.addEventListener('pointermove', (event) => over.hasPointerCapture(event.pointerId) && at(event, false));
    over.addEventListener('pointerup', (event) => over.hasPointerCapture(event.pointerId) && at(event, true));
  }

  /** Where a curve is drawn at the frequency: between samples along the straight line of logarithms. */
  private between(line: number): number {
    const [at = new Float64Array(), values = new Float64Array()] = [this.drawnAt[0], this.drawnAt[line + 1]];
    const found = at.findIndex((value) => value >= this.frequency);
    const next = found < 0 ? at.length - 1 : Math.max(1, found);
    const [from = 1, to = 2, low = 1, high = 1] = [at[next - 1], at[next], values[next - 1], values[next]];
    const part = clamp(Math.log(this.frequency / from) / Math.log(to / from), 0, 1);
    return low ** (1 - part) * high ** part;
  }

  /** A line at the frequency, and a dot on each curve; at the edge of the plot, hollow, where it is beyond. */
  private dots(plot: uPlot): void {
    const { ctx, bbox, scales } = plot;
    if (!this.frequency) return;
    const ratio = devicePixelRatio || 1;
    const x = plot.valToPos(this.frequency, 'x', true);
    const { min = LEAST, max = MOST } = scales['y'] ?? {};
    ctx.save();
    ctx.setLineDash([]);
    ctx.strokeStyle = ink.accent;
    ctx.lineWidth = 1.5 * LARGER * ratio;
    ctx.stroke(new Path2D(`M${x} ${bbox.top}v${bbox.height}`));
    // The first one last: it is what is told.
    for (const [number, { force, at }] of [...this.lines.entries()].reverse()) {
      const size = this.point ? (at(this.point)?.[0] ?? Infinity) : this.between(number);
      const isWithin = size >= (min ?? LEAST) && size <= (max ?? MOST);
      const y = plot.valToPos(clamp(size, min ?? LEAST, max ?? MOST), 'y', true);
      ctx.beginPath();
      ctx.arc(x, y, 6 * LARGER * ratio, 0, 2 * Math.PI);
      ctx.fillStyle = isWithin ? ink[look(force).colour as Colour] : ink.card;
      ctx.strokeStyle = isWithin ? ink.card : ink[look(force).colour as Colour];
      ctx.lineWidth = 2 * LARGER * ratio;
      ctx.fill();
      ctx.stroke();
    }
    ctx.restore();
  }
}

/** The axis: all of the curves, as far as their sizes can be drawn, and some room about 1. */
function reach(curves: Float64Array[]): [number, number] {
  let [low, high] = [0.5, 2];
  for (const values of curves)
    for (const value of values) if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
  return [Math.max(0.8 * low, LEAST), Math.min(1.25 * high, MOST)];
}

/** Ticks of an axis in decades, and which of them have a number and a line. */
const logarithmic = (isTold: (tick: number) => boolean): Partial<uPlot.Axis> => ({
  splits: (_, __, low, high) => decades(low, high),
  filter: (_, ticks) => ticks,
  values: (_, ticks) => ticks.map((tick) => (isTold(tick) ? plain(tick) : '')),
  grid: {
    stroke: () => ink.line,
    width: 1,
    filter: (_, ticks) => ticks.map((tick) => (isTold(tick) ? tick : null)),
  },
});

/** The line at 1, up to where one end may be taken for the other, and what drives the condition. */
function behind(plot: uPlot, { until, lines, within, range }: CurveFacts): void {
  const { ctx, bbox } = plot;
  const ratio = devicePixelRatio || 1;
  ctx.save();
  const one = plot.valToPos(1, 'y', true);
  if (until.through) {
    const right = plot.valToPos(until.through, 'x', true);
    ctx.fillStyle = ink.band;
    ctx.fillRect(bbox.left, bbox.top, right - bbox.left, bbox.height);
    ctx.fillStyle = ink.ink;
    ctx.font = font(11, ratio);
    [ctx.textAlign, ctx.textBaseline] = ['left', 'bottom'];
    const words = `within ${plain(100 * within)} %`;
    if (ctx.measureText(words).width + 8 * ratio < right - bbox.left)
      ctx.fillText(words, bbox.left + 5 * ratio, bbox.top + bbox.height - 4 * ratio);
  }
  ctx.strokeStyle = ink.soft;
  ctx.lineWidth = ratio;
  ctx.setLineDash([3 * ratio, 3 * ratio]);
  ctx.stroke(new Path2D(`M${bbox.left} ${one}h${bbox.width}`));
  for (const line of lines.filter((value) => value >= range[0] && value <= range[1]))
    ctx.stroke(new Path2D(`M${plot.valToPos(line, 'x', true)} ${bbox.top}v${bbox.height}`));
  ctx.restore();
}
