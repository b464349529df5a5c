// The wire moving in one mode, turned by hand; and what its ends feel, in words.
//
// Next door: how it is drawn (`draw`), which mode it is (`choice`).

import type { ShapeFacts } from '../answer';
import { clamp, digits, make } from '../dom';
import { ink, type Colour } from '../plots/looks';
import { drawWire } from './draw';
import { LOOKS, MEANING } from './kinds';
import { survey, type Scene, type View } from './scene';

/** One swing takes so long on the screen [s]. */
const SWING = 1.6;
/** A key turns by so much, a pixel of a drag by so much [rad]. */
const STEP = Math.PI / 24;
const PER_PIXEL = 0.01;

export interface Shown {
  facts: ShapeFacts;
  positions: Float32Array;
  number: number;
  name: string;
}

export class Wire {
  private scene: Scene | null = null;
  private kind: ShapeFacts['mode']['kind'] = 'axial';
  private view: View = { yaw: 0.35, pitch: 0.3 };
  private playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  private running = false;
  private inSight = false;
  private phase = 0;
  private before = 0;
  private readonly canvas = make('canvas', { role: 'img', 'aria-label': 'The wire, not computed yet' });
  private readonly turntable = make(
    'div',
    { class: 'turntable', tabindex: 0, role: 'group', 'aria-label': 'The wire in space; drag or arrows turn it' },
    this.canvas,
  );
  private readonly play = make('button', { type: 'button', class: 'play' });
  private readonly scale = make('span', { class: 'soft' });
  private readonly words = make('p', {});
  private readonly body = make('tbody');
  private readonly refusal = make('p', { class: 'refusal', role: 'status', hidden: true });
  private readonly seen = make(
    'div',
    {},
    this.turntable,
    make('div', { class: 'player' }, this.play, this.scale),
    this.words,
    make(
      'div',
      { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'What the ends feel' },
      make(
        'table',
        { class: 'reactions' },
        make('caption', {}, 'Force and couples on what holds an end, with one newton of axial force there'),
        make('thead', {}, make('tr', {}, ...['', 'Side force', 'Tilting', 'About the axis'].map(head))),
        this.body,
      ),
    ),
  );
  readonly element = make('div', { class: 'wire' }, this.refusal, this.seen);

  constructor() {
    this.play.addEventListener('click', () => this.setPlaying(!this.playing));
    this.turntable.addEventListener('keydown', (event) => this.key(event));
    this.canvas.addEventListener('pointerdown', (event) => this.canvas.setPointerCapture(event.pointerId));
    this.canvas.addEventListener('pointermove', ({ pointerId, movementX, movementY }) => {
      if (this.canvas.hasPointerCapture(pointerId)) this.turn(PER_PIXEL * movementX, PER_PIXEL * movementY);
    });
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    new IntersectionObserver((entries) => {
      this.inSight = entries[entries.length - 1]?.isIntersecting ?? false;
      this.run();
    }).observe(this.canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () =>
      requestAnimationFrame(() => this.draw()),
    );
    this.setPlaying(this.playing);
  }

  show({ facts, positions, number, name }: Shown): void {
    const { mode, under, ends, windings, wireDiameter, length } = facts;
    this.seen.hidden = false;
    this.refusal.hidden = true;
    this.scene = survey({ positions, windings, wireDiameter });
    this.kind = mode.kind;
    const place = `${(1e3 * length).toFixed(1)} mm`;
    const what = `Mode ${number}, ${mode.frequency_hz.toFixed(1)} Hz, ${mode.kind}: ${MEANING[mode.kind]}.`;
    this.canvas.setAttribute('aria-label', `The wire of ${name} at ${place}, ${under.ends}. ${what}`);
    this.words.replaceChildren(make('b', {}, what), ` ${strength(mode)}`);
    const farthest = digits(1e3 * this.scene.amplitude, 2);
    this.scale.textContent = `Enlarged: the farthest point moves ${farthest} mm here; slowed down to one swing in ${SWING} s.`;
    this.body.replaceChildren(...ends.map(row));
    this.draw();
    this.run();
  }

  /** Nothing is drawn; why. */
  refuse(text: string): void {
    this.scene = null;
    this.seen.hidden = true;
    this.refusal.hidden = false;
    this.refusal.textContent = `The wire cannot be drawn: ${text}`;
  }

  private setPlaying(playing: boolean): void {
    this.playing = playing;
    this.play.textContent = playing ? 'Hold still' : 'Move';
    this.play.setAttribute('aria-pressed', String(playing));
    this.run();
  }

  private turn(yaw: number, pitch: number): void {
    this.view = { yaw: this.view.yaw + yaw, pitch: clamp(this.view.pitch + pitch, -Math.PI / 2, Math.PI / 2) };
    if (!this.running) this.draw();
  }

  private key(event: KeyboardEvent): void {
    const turns: Record<string, [number, number]> = {
      ArrowLeft: [-STEP, 0],
      ArrowRight: [STEP, 0],
      ArrowUp: [0, -STEP],
      ArrowDown: [0, STEP],
    };
    const by = turns[event.key];
    if (!by || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.turn(...by);
  }

  private draw(): void {
    if (!this.scene) return;
    drawWire(this.canvas, this.scene, this.view, Math.cos(this.phase), ink[LOOKS[this.kind].colour as Colour]);
  }

  private run(): void {
    if (this.running || !this.playing || !this.inSight || !this.scene) return;
    this.running = true;
    this.before = performance.now();
    requestAnimationFrame((now) => this.step(now));
  }

  private step(now: number): void {
    this.running = this.playing && this.inSight && this.scene !== null;
    if (!this.running) return;
    this.phase = (this.phase + (2 * Math.PI * clamp(now - this.before, 0, 100)) / 1e3 / SWING) % (2 * Math.PI);
    this.before = now;
    this.draw();
    requestAnimationFrame((next) => this.step(next));
  }
}

const head = (text: string): HTMLElement => (text ? make('th', { scope: 'col' }, text) : make('td'));

/** How strong its line is where the axial force is read. */
const strength = ({ axial_strength }: ShapeFacts['mode']): string =>
  `Its line stands in the axial force with ${digits(100 * axial_strength)} % of an axial mode of a bar.`;

function row(end: ShapeFacts['ends'][number], index: number): HTMLElement {
  const cell = (value: number | null, scale: number, unit: string) =>
    make('td', {}, value === null ? 'no axial force' : `${digits(scale * value)} ${unit}`);
  return make(
    'tr',
    {},
    make('th', { scope: 'row' }, `End ${index + 1}`),
    cell(end.side_force_n_per_n, 1, 'N'),
    cell(end.tilting_couple_m, 1e3, 'N mm'),
    cell(end.axis_couple_m, 1e3, 'N mm'),
  );
}
