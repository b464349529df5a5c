// The arrow over the coil, and the figure beside it.
//
// Next door: what it tells (`gesture`).

import { clamp, make } from '../dom';

export class Arrow {
  private readonly words = make('span', { class: 'how', hidden: true });
  private readonly svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  private readonly path = document.createElementNS('http://www.w3.org/2000/svg', 'path');

  constructor(private readonly host: HTMLElement) {
    this.svg.setAttribute('aria-hidden', 'true');
    this.svg.append(this.path);
    host.append(this.svg, this.words);
  }

  /** From a place to another, across the middle [pixels]. */
  show(from: number, to: number, height: number, words: string): void {
    const [middle, back] = [(height - 28) / 2, Math.sign(from - to) * Math.min(12, Math.abs(to - from))];
    this.path.setAttribute('d', `M${from} ${middle}H${to}M${to + back} ${middle - 8}L${to} ${middle}l${back} 8`);
    this.words.textContent = words;
    this.words.hidden = false;
    this.svg.classList.add('shown');
    const half = this.words.offsetWidth / 2;
    this.words.style.left = `${clamp(to, half, Math.max(half, this.host.clientWidth - half))}px`;
  }

  hide(): void {
    this.words.hidden = true;
    this.svg.classList.remove('shown');
  }
}
