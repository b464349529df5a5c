// What the user may take along: the spec that the command takes, the series as the command writes them, the picture of the forces.

import type { Compute, Shown } from '../compute';
import { toToml } from '../document';
import { download, make } from '../dom';
import { FORCE_LINES, readings } from '../plots/lines';
import { preset } from '../presets';
import type { Store } from '../store';

/** How long it is told that something was copied [ms]. */
const TOLD = 5000;

export class Downloads {
  private shown: Shown | null = null;
  private readonly told = make('span', { class: 'copied', role: 'status' });
  private timer = 0;

  constructor(
    private readonly store: Store,
    private readonly compute: Compute,
    host: HTMLElement,
    private readonly plot: () => { width: number; height: number },
  ) {
    const button = (label: string, title: string, act: () => void) =>
      make('button', { type: 'button', class: 'plain', title, onclick: act }, label);
    host.replaceChildren(
      make('span', {}, 'Take along: '),
      button('Spec (TOML)', 'For the command: coilsense analyze', () => this.spec()),
      button('Series (CSV)', 'Every signal and reading, as coilsense simulate writes them', () => void this.csv()),
      button('Forces (SVG)', 'The picture above', () => void this.svg()),
      button('Link', 'Copies the address, which holds the whole state', () => void this.link()),
      this.told,
    );
  }

  /** Copies the address of the state as it is now; where that is not allowed, shows it to be copied by hand. */
  private async link(): Promise<void> {
    const { address } = this.store;
    try {
      await navigator.clipboard.writeText(address);
      this.told.textContent = 'The link is copied.';
    } catch {
      const field = make('input', { type: 'text', readonly: true, value: address, 'aria-label': 'The link' });
      this.told.replaceChildren('Copy it from here: ', field);
      field.select();
    }
    clearTimeout(this.timer);
    this.timer = window.setTimeout(
      () => this.told.contains(document.activeElement) || this.told.replaceChildren(),
      TOLD,
    );
  }

  show(shown: Shown): void {
    this.shown = shown;
  }

  private get name(): string {
    const { facts } = this.shown?.answer ?? {};
    const words = [facts?.spring.name ?? 'spring', facts?.conditions[facts.condition]?.name ?? ''];
    return words.join('-').replaceAll(/[^\w.-]+/g, '-');
  }

  private spec(): void {
    const { files, example } = preset(this.store.state.preset);
    const beside = Object.keys(files).map((file) => `# needs ${file} beside it, from examples/ of coilsense\n`);
    const heading = `# Made on the page of coilsense, from examples/${example}.toml\n${beside.join('')}\n`;
    download(`${this.name}.toml`, heading + toToml(this.store.state.spec).text, 'application/toml');
  }

  private async csv(): Promise<void> {
    const { text, condition, damping } = this.compute.question(this.store.state);
    const reply = await this.compute.ask({ kind: 'csv', text, condition, damping });
    if ('bytes' in reply) download(`${this.name}.csv`, reply.bytes, 'text/csv');
  }

  private async svg(): Promise<void> {
    if (!this.shown) return;
    const { answer, exact, times } = this.shown;
    const { hidden, sensors } = this.store.state.view;
    const { width, height } = this.plot();
    const forces = FORCE_LINES.filter(({ name }) => !hidden.includes(name));
    const lines = [...forces, ...readings(exact?.facts ?? null, sensors)];
    // Few take a picture along: what draws it is loaded when it is wanted.
    const { forcesSvg } = await import('./svg');
    download(`${this.name}.svg`, forcesSvg(answer, times, lines, { width, height }), 'image/svg+xml');
  }
}
