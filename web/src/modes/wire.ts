// The wire moving in one mode, turned by hand; and what its ends feel, in words.
//
// Next door: how it moves on (`plots/turning`), how it is drawn (`draw`), which mode it is (`choice`).

import type { ShapeFacts } from '../answer';
import { clamp, digits, make } from '../dom';
import { ink, type Colour } from '../plots/looks';
import { Turning } from '../plots/turning';
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
  private readonly canvas = make('canvas', { role: 'img', 'aria-label': 'The wire, not computed yet' });
  private readonly turntable = make(
    'div',
    { class: 'turntable', tabindex: 0, role: 'group', 'aria-label': 'The wire in space; drag or arrows turn it' },
    this.canvas,
  );
  private readonly turning = new Turning({
    canvas: this.canvas,
    sized: this.canvas,
    turn: SWING,
    draw: (angle) => this.draw(angle),
    isThere: () => this.scene !== null,
  });
  private readonly scale = make('span', { class: 'soft' });
  private readonly words = make('p', {});
  private readonly body = make('tbody');
  private readonly refusal = make('p', { class: 'refusal', role: 'status', hidden: true });
  private readonly seen = make(
    'div',
    {},
    this.turntable,
    make('div', { class: 'player' }, this.turning.play, this.scale),
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
    this.turntable.addEventListener('keydown', (event) => this.key(event));
    this.canvas.addEventListener('pointerdown', (event) => this.canvas.setPointerCapture(event.pointerId));
    this.canvas.addEventListener('pointermove', ({ pointerId, movementX, movementY }) => {
      if (this.canvas.hasPointerCapture(pointerId)) this.turn(PER_PIXEL * movementX, PER_PIXEL * movementY);
    });
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
    this.turning.show();
  }

  /** Nothing is drawn; why. */
  refuse(text: string): void {
    this.scene = null;
    this.seen.hidden = true;
    this.refusal.hidden = false;
    this.refusal.textContent = `The wire cannot be drawn: ${text}`;
  }

  private turn(yaw: number, pitch: number): void {
    this.view = { yaw: this.view.yaw + yaw, pitch: clamp(this.view.pitch + pitch, -Math.PI / 2, Math.PI / 2) };
    this.turning.again();
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

  private draw(angle: number): void {
    if (!this.scene) return;
    drawWire(this.canvas, this.scene, this.view, Math.cos(angle), ink[LOOKS[this.kind].colour as Colour]);
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
