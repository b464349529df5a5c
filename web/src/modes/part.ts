// The modes of the coil: lines against length, all modes at one of the lengths, and the wire as it moves in one of them.
//
// Next door: each of its parts (`chart`, `table`, `wire`), what it says (`words`), what opens it (`results/folded`).

import type { Answer, LinesFacts, ShapeFacts } from '../answer';
import type { Compute } from '../compute';
import { clamp, make, word } from '../dom';
import type { Reply } from '../lane';
import type { Case } from '../results/folded';
import css from '../style/modes.css?inline';
import { wear } from '../style/wear';
import { drawLines, type LinesChart } from './chart';
import { Choice } from './choice';
import { lines, type Lines } from './lines';
import { Table } from './table';
import { Wire } from './wire';
import { about } from './words';

/** Lengths of the chart: the shortest, the middle and the longest in use are among them. */
const LENGTHS = 49;
/** Points of the wire for each winding: some hundreds in all, and of few windings so many that they look round. */
const points = (windings: number): number => Math.round(clamp(800 / windings, 12, 32));

export class Part {
  private asked = '';
  private shown: Case | null = null;
  private lines: Lines | null = null;
  private drawn: LinesChart | null = null;
  private readonly refusal = make('p', { class: 'refusal', role: 'status', hidden: true });
  private readonly figure = make('figure', { class: 'lines' });
  private readonly words = make('div', { class: 'about' });
  private readonly choice = new Choice((moved) => this.choose(moved));
  private readonly table = new Table((number) => this.choice.pick(number));
  private readonly wire = new Wire();
  private readonly body = make(
    'div',
    { class: 'every-mode', hidden: true },
    make('div', {}, word('modes'), this.figure, this.words),
    make('div', {}, this.choice.element, this.wire.element),
    this.table.element,
  );

  constructor(
    host: HTMLElement,
    private readonly compute: Compute,
  ) {
    wear(css);
    host.append(this.refusal, this.body);
  }

  /** An exact case; while there is none, the last one in grey. */
  show(shown: Case | null): void {
    if (!shown) return this.mark(true);
    const isNew = shown.text !== this.asked;
    const before = this.shown;
    this.shown = shown;
    if (isNew) {
      this.mark(true);
      this.asked = shown.text;
      this.compute.beside({ kind: 'modes', text: shown.text, lengths: LENGTHS }, (reply) => this.take(reply));
    } else if (this.lines && before?.meanLength !== shown.meanLength) this.fill();
    else if (this.lines) this.mark(false);
  }

  /** Whether what is shown is of an earlier state. */
  private mark(isStale: boolean): void {
    this.body.classList.toggle('stale', isStale);
    this.body.setAttribute('aria-busy', String(isStale));
  }

  private take(reply: Reply): void {
    clock('modes', reply);
    const refusal = 'error' in reply ? reply.error : '';
    this.refusal.textContent =
      refusal && `The coil cannot be followed as a helix, so that nothing is drawn: ${refusal}`;
    this.refusal.hidden = refusal === '';
    this.body.hidden = refusal !== '';
    this.lines = 'answer' in reply ? lines(reply.answer as Answer<LinesFacts>) : null;
    if (this.lines) this.fill();
  }

  private fill(): void {
    if (!this.lines || !this.shown) return;
    this.choice.show(this.lines, this.shown);
    this.draw();
    this.askShape();
  }

  private draw(): void {
    if (!this.lines || !this.shown) return;
    const { way } = this.choice;
    this.drawn = drawLines(this.figure, this.lines, this.shown, this.choice);
    this.words.replaceChildren(...about(this.lines, this.shown, way));
  }

  /** The user chose another length, another way of the ends, or another mode. */
  private choose(moved: 'way' | 'length' | 'number'): void {
    if (moved === 'way') this.draw();
    this.drawn?.point(this.choice);
    this.askShape();
  }

  private askShape(): void {
    const { length, way, number } = this.choice;
    const { asked: text } = this;
    this.compute.beside(
      { kind: 'shape', text, length, loosest: way > 0, number, points: points(this.shown?.spring.windings ?? 0) },
      (reply) => text === this.asked && this.takeShape(reply),
    );
  }

  private takeShape(reply: Reply): void {
    clock('shape', reply);
    if ('error' in reply) {
      this.table.clear();
      this.wire.refuse(reply.error);
    } else if ('answer' in reply) {
      const { facts, positions } = reply.answer as Answer<ShapeFacts>;
      this.table.show(facts.under, this.choice.number);
      this.wire.show({ facts, positions, number: this.choice.number, name: this.shown?.spring.name ?? '' });
    }
    this.mark(false);
  }
}

/** How long the engine took, for whoever measures the page. */
const clock = (name: string, { milliseconds }: Reply): void => {
  performance.measure(`engine ${name}`, { start: performance.now() - milliseconds, duration: milliseconds });
};
