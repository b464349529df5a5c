// Error against lag: one point a candidate; one of them is picked.
//
// Next door: the same as a table (`table`), points that can be picked (`plots/points`).

import { digits } from '../dom';
import { curves, type Curves } from '../plots/curves';
import { Points } from '../plots/points';
import { lag, mostLag, share, those, told, type Judged } from './ranking';

/** In whose look candidates of an origin are drawn. */
const LOOKS = [
  ['raw', 'F_L', true],
  ['textbook', 'F_i', 'hollow'],
  ['fitted', 'F_o', true],
] as const;

export class Scatter {
  readonly drawing: Curves;
  private readonly points: Points;
  private readonly numbers: number[];

  constructor(host: HTMLElement, judged: Judged, truth: string, title: string, picked: (number: number) => void) {
    const { facts } = judged.answer;
    const each = those(judged, truth).sort((a, b) => lag(a.one) - lag(b.one));
    const best = each.find(({ number }) => facts.best.includes(number));
    const error = (index: number) => share(judged, each[index]?.one.worst_rms_error_n ?? NaN);
    this.numbers = each.map(({ number }) => number);
    const places = each.map(({ one }, index) => ({ x: lag(one), y: error(index), label: told(judged, one) }));
    this.points = new Points(places, (index) => picked(this.numbers[index] ?? 0));
    this.drawing = {
      title: `${title}: error against lag`,
      x: {
        label: `Lag at ${digits(judged.ranking.bandwidth_hz)} Hz [°]`,
        values: Float64Array.from(each, ({ one }) => lag(one)),
      },
      y: { label: 'Worst error [% of F_nom]', logarithmic: true },
      curves: LOOKS.map(([origin, look, dots]) => ({
        look,
        label: origin,
        dots,
        values: each.map(({ one }, index) => (one.origin === origin ? error(index) : null)),
      })),
      marks: [{ x: mostLag(judged), label: 'most lag' }, ...(best ? [{ x: lag(best.one), label: best.one.name }] : [])],
    };
    curves(host, this.drawing, this.points.plugin);
  }

  /** Rings the point of a candidate, where it is one of these. */
  pick(number: number): void {
    this.points.choose(this.numbers.indexOf(number));
  }
}
