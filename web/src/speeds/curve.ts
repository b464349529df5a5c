// How far each force is off over the speed of the recorded motion, with a line at the speed that is shown; a click takes another.
//
// Next door: what is computed when (`points`), what it says (`words`).

import type uPlot from 'uplot';
import { clamp, make, rich } from '../dom';
import { axis, chart, curve } from '../plots/chart';
import { ink, sample } from '../plots/looks';
import { FROM, TO, type At } from './points';

export class Curve {
  readonly element = make('figure', { class: 'speeds' });
  private drawn: uPlot | null = null;
  private speed = 1;
  private points: readonly At[] = [];
  private goal: number | null = null;

  /** `pick` hears which speed was clicked, as a share of the recorded one. */
  constructor(private readonly pick: (speed: number) => void) {}

  /** Points in the order of their speed; the goal over F_nom. */
  show(points: readonly At[], forces: readonly string[], goal: number | null, truth: string): void {
    [this.points, this.goal] = [points, goal];
    const plot = make('div', {
      class: 'plot',
      role: 'img',
      'aria-label': `How far ${forces.join(', ')} are off from ${truth} over the speed of the recorded motion`,
    });
    const legend = forces.map((force) =>
      make('span', {}, sample(force), make('span', {}, rich(`${force} off from ${truth}, rms`))),
    );
    this.element.replaceChildren(make('figcaption', { class: 'keys' }, ...legend), plot);
    const values = forces.map((force) => points.map(({ off }) => 100 * (off[force] ?? 0)));
    const top = 1.1 * Math.max(1e-6, ...values.flat(), 200 * (goal ?? 0));
    this.drawn = chart(
      plot,
      {
        scales: { x: { time: false, range: [100 * FROM, 100 * TO] }, y: { range: [0, top] } },
        cursor: { drag: { x: false, y: false }, points: { show: false }, y: false },
        axes: [axis('Speed [% of the recorded]', 36), axis('Off, rms [% of F_nom]', 58)],
        series: [{}, ...forces.map((force) => curve(force, force))],
        hooks: {
          drawAxes: [(drawn) => this.behind(drawn)],
          draw: [(drawn) => this.mark(drawn)],
          ready: [(drawn) => this.listen(drawn)],
        },
      },
      [points.map(({ speed }) => 100 * speed), ...values] as uPlot.AlignedData,
    );
  }

  /** The speed that is shown. */
  at(speed: number): void {
    this.speed = speed;
    this.drawn?.redraw(false, false);
  }

  private listen({ over, posToVal }: uPlot): void {
    over.addEventListener('click', ({ clientX }) => {
      const { left, width } = over.getBoundingClientRect();
      this.pick(clamp(posToVal(clamp(clientX - left, 0, width), 'x') / 100, FROM, TO));
    });
  }

  /** Where windings would touch, and the goal. */
  private behind(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const x = (speed: number) => plot.valToPos(100 * speed, 'x', true);
    ctx.save();
    ctx.fillStyle = ink.line;
    this.points.forEach(({ speed, touch }, index) => {
      if (!touch) return;
      const from = Math.sqrt(speed * (this.points[index - 1]?.speed ?? speed));
      const to = Math.sqrt(speed * (this.points[index + 1]?.speed ?? speed));
      // Whole pixels: neighbours leave no seam.
      const left = Math.floor(x(from));
      ctx.fillRect(left, bbox.top, Math.max(1, Math.ceil(x(to)) - left), bbox.height);
    });
    if (this.goal !== null) {
      const ratio = devicePixelRatio || 1;
      const y = plot.valToPos(100 * this.goal, 'y', true);
      ctx.strokeStyle = ink.soft;
      ctx.lineWidth = ratio;
      ctx.setLineDash([4 * ratio, 4 * ratio]);
      ctx.stroke(new Path2D(`M${bbox.left} ${y}h${bbox.width}`));
    }
    ctx.restore();
  }

  private mark(plot: uPlot): void {
    const { ctx, bbox } = plot;
    if (this.speed < FROM || this.speed > TO) return;
    const ratio = devicePixelRatio || 1;
    ctx.save();
    ctx.setLineDash([]);
    ctx.strokeStyle = ink.accent;
    ctx.lineWidth = 1.5 * ratio;
    ctx.stroke(new Path2D(`M${plot.valToPos(100 * this.speed, 'x', true)} ${bbox.top}v${bbox.height}`));
    ctx.restore();
  }
}
