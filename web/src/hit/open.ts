// The button that hits the spring, and the words below it; the rest (hands and keys on the coil, the strip, the sound) is loaded once there
// are curves.
//
// Next door: what is loaded (`hands`).

import type { Compute, Shown } from '../compute';
import { make } from '../dom';
import { part } from '../faults';
import type { Player } from '../spring/player';
import type { Store } from '../store';
import type { Part } from './hands';

/** What a hit has to do with. */
export interface Bench {
  store: Store;
  compute: Compute;
  player: Player;
  /** The card of the spring, its canvas, the card of the strip. */
  card: HTMLElement;
  canvas: HTMLCanvasElement;
  strip: HTMLElement;
  last(): Shown | null;
}

export class Hits {
  private part: Part | null = null;
  private loading: Promise<void> | null = null;
  private readonly button = make('button', { type: 'button', class: 'plain hit', disabled: true }, 'Hit');
  private readonly words = make('span', { class: 'struck', role: 'status' });

  constructor(private readonly bench: Bench) {
    const { card } = bench;
    card.querySelector('.play')?.after(this.button);
    card.querySelector('.legend')?.append(this.words);
    // A phone's first screen has no line for it.
    if (innerWidth >= 480) this.words.textContent = 'Click or flick the coil; pull an end and let go.';
    this.button.addEventListener('click', (event) => void this.load().then(() => this.part?.hit(event)));
  }

  /** There is a spring to be hit; its curves come first. */
  ready(): void {
    if (!this.button.disabled) return;
    this.button.disabled = false;
    requestAnimationFrame(() => setTimeout(() => void this.load()));
  }

  at(time: number): void {
    this.part?.at(time);
  }

  private load(): Promise<void> {
    return (this.loading ??= part('What hits the spring and shows its wave', () => import('./hands')).then(
      ({ Part }) => void (this.part = new Part(this.bench, this.words)),
    ));
  }
}
