// A film's pictures: title and key numbers above, the spring with its end forces, the forces over time with a mark, the wave as a strip, the lines' names below.
//
// Next door: the spring (`spring/draw`), the strip (`hit/paint`), the forces (`plot`), who asks for pictures (`record`).

import type { Shown } from '../compute';
import { clamp, digits, fixed } from '../dom';
import type { Onset } from '../hit/act';
import { pageAt } from '../hit/pages';
import { paint, type Area } from '../hit/paint';
import { LARGER } from '../plots/chart';
import type { Line } from '../plots/lines';
import { ink, look } from '../plots/looks';
import { closedAt } from '../spring/closed';
import { drawSpring, sheet } from '../spring/draw';
import { firstContact, nearest, positionsAt, survey, type Scene } from '../spring/scene';
import { Plot, type Box } from './plot';
import { write, type Style } from './type';

/** What a film is of. */
export interface Take {
  shown: Shown;
  title: string;
  /** Curves that are drawn. */
  lines: readonly Line[];
  onset: Onset | null;
  /** How much slower than the spring it runs, in words. */
  pace: string;
}

/** Units of a picture, whatever its dots, and where its parts stand. */
const [WIDE, HIGH] = [960, 540];
const SPRING: Box = { left: 14, top: 96, width: 630, height: 160 };
const FORCES: Box = { left: 14, top: 264, width: 630, height: 232 };
const WAVE: Box = { left: 656, top: 96, width: 290, height: 400 };

export class Picture {
  private readonly canvas = document.createElement('canvas');
  private readonly spring = document.createElement('canvas');
  private readonly strip = document.createElement('canvas');
  /** What is the same in all pictures. */
  private still: HTMLCanvasElement | null = null;
  private readonly scene: Scene;
  private readonly plot: Plot;
  /** Colours of when the film was begun: evening may come meanwhile. */
  private readonly colours = { ...ink };
  private strips: { page: [number, number]; area: Area | null } | null = null;
  private dots = 0;

  constructor(private readonly take: Take) {
    const { answer, times } = take.shown;
    this.scene = survey(take.shown);
    this.plot = new Plot(FORCES, answer, times, take.lines);
  }

  /** At a share of the shown times; so many dots wide. */
  draw(share: number, width: number): HTMLCanvasElement {
    const now = { ...ink };
    Object.assign(ink, this.colours);
    try {
      return this.paint(share, width);
    } finally {
      Object.assign(ink, now);
    }
  }

  private paint(share: number, width: number): HTMLCanvasElement {
    const [from, to] = this.take.shown.times;
    const time = from + share * (to - from);
    if (width !== this.dots) this.begin(width);
    const context = fresh(this.canvas, width);
    context.setTransform(1, 0, 0, 1, 0, 0);
    if (this.still) context.drawImage(this.still, 0, 0);
    context.setTransform(width / WIDE, 0, 0, width / WIDE, 0, 0);
    this.clock(context, time);
    this.ends(context, time);
    this.coil(context, time);
    this.wave(context, time);
    this.plot.mark(context, time);
    this.keys(context, time);
    return this.canvas;
  }

  private begin(width: number): void {
    this.dots = width;
    this.strips = null;
    this.still = document.createElement('canvas');
    const context = fresh(this.still, width);
    context.fillStyle = ink.ground;
    context.fillRect(0, 0, WIDE, HIGH);
    for (const { left, top, width, height } of [SPRING, FORCES, WAVE]) {
      context.fillStyle = ink.card;
      context.strokeStyle = ink.line;
      context.beginPath();
      context.roundRect(left, top, width, height, 8);
      context.fill();
      context.stroke();
    }
    write(context, this.take.title, 16, 30, { size: 21, weight: 700, colour: ink.ink, room: 740 });
    write(context, keyNumbers(this.take.shown), 16, 53, { size: 14, colour: ink.soft, room: 740 });
    write(context, 'coilsense', WIDE - 14, HIGH - 14, { size: 13, colour: ink.soft, align: 'right' });
    const way = digits(1e3 * this.take.shown.answer.facts.spring.transitTime);
    const foot = `One way ${way} ms${this.take.onset ? '; dashed: there and back' : ''}`;
    write(context, foot, WAVE.left + 10, WAVE.top + 18, { size: 12, colour: ink.soft, room: WAVE.width - 20 });
    this.plot.draw(context);
  }

  private clock(context: CanvasRenderingContext2D, time: number): void {
    const right = { align: 'right' } as const;
    write(context, `${fixed(1e3 * time, 1)} ms`, WIDE - 14, 30, { size: 21, weight: 700, colour: ink.ink, ...right });
    write(context, this.take.pace, WIDE - 14, 53, { size: 14, colour: ink.soft, ...right });
  }

  /** The force at either end, and how far they are apart. */
  private ends(context: CanvasRenderingContext2D, time: number): void {
    const { facts } = this.take.shown.answer;
    const [one, two] = [this.value('F_i', time) ?? 0, this.value('F_o', time) ?? 0];
    const { nominalForce } = facts.spring;
    const decimals = clamp(3 - Math.floor(Math.log10(nominalForce)), 0, 3);
    const style = { size: 15, weight: 600 };
    const y = SPRING.top - 12;
    write(context, `End 1  F_i ${fixed(one, decimals)} N`, SPRING.left + 2, y, { ...style, colour: ink.blue });
    const apart = `${fixed(Math.abs(two - one), decimals)} N apart: ${fixed((100 * Math.abs(two - one)) / nominalForce, 1)} % of F_nom`;
    const middle: Style = { ...style, colour: ink.ink, align: 'center' };
    write(context, apart, SPRING.left + SPRING.width / 2, y, middle);
    const end: Style = { ...style, colour: ink.red, align: 'right' };
    write(context, `End 2  F_o ${fixed(two, decimals)} N`, SPRING.left + SPRING.width - 2, y, end);
  }

  private coil(context: CanvasRenderingContext2D, time: number): void {
    const { shown } = this.take;
    const { frames, answer, times } = shown;
    const { spring } = answer.facts;
    const { left, top, width, height } = SPRING;
    const inside = { left: left + 6, top: top + 8, width: width - 12, height: height - 12 };
    const dots = this.dots / WIDE / LARGER;
    drawSpring(sheet(this.spring, inside.width * LARGER, inside.height * LARGER, dots), {
      ...this.scene,
      positions: positionsAt(frames, time),
      spring,
      forces: [this.value('F_i', time) ?? 0, this.value('F_o', time) ?? 0],
      closed: closedAt(answer.series, time, spring.masses, times),
    });
    context.drawImage(this.spring, inside.left, inside.top, inside.width, inside.height);
    const { gain } = this.scene;
    const drawn = gain === 1 ? 'Drawn true to scale' : `Displacements ${gain} times larger`;
    write(context, drawn, left + width - 10, top + height - 9, { size: 12, colour: ink.soft, align: 'right' });
    const contact = firstContact(answer.facts);
    // What a real coil would not do is said in every picture from there on.
    if (contact !== null && !answer.facts.contact && time >= contact)
      write(context, 'Windings touch: a real coil would do something else', left + width / 2, top + 17, {
        ...{ size: 13, weight: 600, colour: ink.touch, align: 'center' },
      });
  }

  private wave(context: CanvasRenderingContext2D, time: number): void {
    const { shown, onset } = this.take;
    const page = pageAt(time, shown.times, shown.answer.facts.spring.transitTime);
    const { left, top, width, height } = { ...WAVE, top: WAVE.top + 24, height: WAVE.height - 26 };
    if (this.strips?.page[0] !== page[0] || this.strips?.page[1] !== page[1]) {
      const on = sheet(this.strip, width * LARGER, height * LARGER, this.dots / WIDE / LARGER);
      this.strips = { page, area: paint(on, shown, page, this.scene.peak, onset) };
    }
    context.drawImage(this.strip, left, top, width, height);
    const { area } = this.strips;
    if (!area) return;
    const y = top + (area.top + ((time - page[0]) / (page[1] - page[0])) * area.height) / LARGER;
    context.fillStyle = ink.card;
    context.fillRect(left + area.left / LARGER, y - 2, area.width / LARGER, 4);
    context.fillStyle = ink.ink;
    context.fillRect(left + area.left / LARGER, y - 1, area.width / LARGER, 2);
  }

  /** Which line is which, and its value at the mark. */
  private keys(context: CanvasRenderingContext2D, time: number): void {
    const { lines, shown } = this.take;
    const decimals = clamp(3 - Math.floor(Math.log10(shown.answer.facts.spring.nominalForce)), 0, 3);
    const room = (WIDE - 110) / Math.max(4, lines.length);
    lines.forEach(({ series, name }, number) => {
      const [at, y] = [16 + number * room, HIGH - 14];
      const { colour, dash, width } = look(series);
      context.beginPath();
      context.moveTo(at, y - 5);
      context.lineTo(at + 30, y - 5);
      context.setLineDash(dash);
      context.lineWidth = width + 0.4;
      context.strokeStyle = ink[colour as keyof typeof ink];
      context.stroke();
      context.setLineDash([]);
      const value = this.value(series, time);
      const told = value === undefined ? '' : ` ${fixed(value, decimals)} N`;
      const style = { size: 14, colour: ink.ink };
      // A long name is cut, its value never.
      const figure = 0.6 * style.size * told.length;
      const wide = write(context, name, at + 36, y, { ...style, room: room - 40 - figure });
      write(context, told, at + 36 + wide, y, style);
    });
  }

  private value(series: string, time: number): number | undefined {
    const { series: all } = this.take.shown.answer;
    return all[series]?.[nearest(all['time'] ?? new Float64Array(1), time)];
  }
}

/** A canvas of so many dots, empty; drawn on in units of a picture. */
function fresh(canvas: HTMLCanvasElement, width: number): CanvasRenderingContext2D {
  // Pictures are read again and again where they become a GIF.
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('this browser draws no pictures');
  const height = Math.round((width * HIGH) / WIDE);
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  context.setTransform(width / WIDE, 0, 0, width / WIDE, 0, 0);
  return context;
}

/** What of the spec decides on what is seen. */
function keyNumbers({ answer: { facts } }: Shown): string {
  const { stiffness, mass, transitTime, nominalForce } = facts.spring;
  return `k ${digits(stiffness)} N/m · m ${digits(1e3 * mass)} g · f1 ${digits(facts.lines[0] ?? 0)} Hz · one way ${digits(1e3 * transitTime)} ms · F_nom ${digits(nominalForce, 4)} N`;
}
