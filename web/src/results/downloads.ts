// What may be downloaded: the spec that the command takes, the series as the command writes them, the picture of the forces, a film, the address.
//
// Next door: how the files are made (`take`), and films (`record/record`).

import type { Compute, Shown } from '../compute';
import { make } from '../dom';
import { part } from '../faults';
import type { Store } from '../store';

/** How long it is told that something was copied [ms]. */
const TOLD = 5000;

export class Downloads {
  private shown: Shown | null = null;
  private readonly told = make('span', { class: 'copied', role: 'status' });
  private readonly filmed = make('span', { class: 'filmed' });
  private timer = 0;

  constructor(
    private readonly store: Store,
    compute: Compute,
    host: HTMLElement,
    plot: () => { width: number; height: number },
  ) {
    const button = (label: string, title: string, act: () => void) =>
      make('button', { type: 'button', class: 'plain', title, onclick: act }, label);
    host.replaceChildren(
      button('Spec (TOML)', 'For the command: coilsense analyze', () =>
        this.take(({ takeSpec }) => takeSpec(store.state, this.shown)),
      ),
      button('Series (CSV)', 'Every signal and reading, as coilsense simulate writes them', () =>
        this.take(({ takeSeries }) => void takeSeries(store.state, this.shown, compute)),
      ),
      button('Forces (SVG)', 'The picture above', () =>
        this.take(({ takePicture }) => takePicture(store.state, this.shown, plot())),
      ),
      button('Film (WebM)', 'Spring, forces and wave over what is shown', () => this.film('webm')),
      button('Film (GIF)', 'The same, for slides and pages without video', () => this.film('gif')),
      button('Link', 'Copies the address, which holds the whole state', () => void this.link()),
      this.told,
      this.filmed,
    );
  }

  /** Few take anything along: what makes it is loaded when it is wanted. */
  private take(make: (how: typeof import('./take')) => void): void {
    void part('What writes files', () => import('./take')).then(make);
  }

  private film(kind: 'webm' | 'gif'): void {
    void part('What records films', () => import('../record/record')).then(({ record }) =>
      record(
        kind,
        this.filmed,
        () => this.store.state,
        () => this.shown,
      ),
    );
  }

  /** Copies the address of the state as it is now; where that is not allowed, shows it to be copied by hand. */
  private async link(): Promise<void> {
    const { address } = this.store;
    clearTimeout(this.timer);
    try {
      await navigator.clipboard.writeText(address);
      this.told.textContent = 'The link is copied.';
      this.timer = window.setTimeout(() => this.told.replaceChildren(), TOLD);
    } catch {
      const field = make('input', { type: 'text', readonly: true, value: address, 'aria-label': 'The link' });
      this.told.replaceChildren('Copy it: ', field);
      field.select();
    }
  }

  show(shown: Shown): void {
    this.shown = shown;
  }
}
