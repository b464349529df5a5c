// The interactive part of a report: a case is chosen; its spring moves, its signals and their errors are drawn and told.
//
// Next door: each of its parts (`choice`, `table`, `charts`, `spring/player`), what it is begun with (`main`).

import type uPlot from 'uplot';
import { byId, fixed, make } from '../dom';
import { readInk } from '../plots/looks';
import { Timeline, type Times } from '../plots/timeline';
import { Player } from '../spring/player';
import { GAINS, positionsAt } from '../spring/scene';
import { drawCharts, WIDE } from './charts';
import { Choice } from './choice';
import { unpack, type Case, type PackedCase, type Report, type Signal } from './data';
import { SignalTable } from './table';

/** Where there is little room, as many surges are shown at first as have so much each [pixels]. */
const SURGE = 60;
/** Width of a chart on paper [pixels]. */
const PAPER = 660;

export class Viewer {
  private shown: Case | null = null;
  private table: SignalTable | null = null;
  private plots: { plot: uPlot; signals: Signal[] }[] = [];
  private time = 0;
  private pointed: number | null = null;
  private readonly hidden = new Set<string>();
  private readonly timeline = new Timeline({ zoom: (times) => this.zoom(times), point: (time) => this.point(time) });
  private readonly choice: Choice;
  private readonly player: Player;
  private readonly refusal = make('p', { class: 'warning', role: 'alert', hidden: true });
  private readonly spring = make('div', { class: 'see' });
  private readonly closest = make('p', { class: 'note' });
  private readonly gain = make('input', { type: 'range', min: 0, max: GAINS.length - 1 });
  private readonly signals = make('div');
  private readonly scroll = make('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Signals' });
  private readonly reset = make('button', { type: 'button', class: 'plain' }, 'Reset zoom');
  private readonly charts = make('div');

  constructor(private readonly report: Report) {
    readInk();
    this.choice = new Choice(byId('coilsense-case'), report.cases, (one) => this.show(one));
    const canvas = make('canvas', { class: 'coil', role: 'img' });
    this.player = new Player({ slow: 0 }, this.spring, canvas, (time, told) => this.moveTo(time, told));
    this.gain.addEventListener('input', () => this.enlarge(Number(this.gain.value)));
    this.spring.querySelector('.player')?.append(make('label', { class: 'gain' }, 'Displacement ', this.gain));
    this.spring.append(this.closest);
    byId('coilsense-spring').replaceChildren(this.refusal, this.spring);
    const button = (text: string, title: string, factor: number) =>
      make(
        'button',
        { type: 'button', class: 'plain', 'aria-label': title, onclick: () => this.timeline.zoomBy(factor) },
        text,
      );
    this.reset.addEventListener('click', () => this.zoom(null));
    const hint = 'Drag to zoom, double-click to reset, click to move the mark; with a chart in focus: ← → + − Esc.';
    const tools = [button('+', 'Zoom in', 2), button('−', 'Zoom out', 0.5), this.reset];
    this.signals.append(
      this.scroll,
      make('div', { class: 'controls' }, ...tools, make('span', { class: 'soft' }, hint)),
      this.charts,
    );
    byId('coilsense-signals').replaceChildren(this.signals);
    this.listen();
    const [first] = report.cases;
    const begun = this.linked() ?? first;
    if (begun) this.show(begun);
  }

  /** Links to `#case-<id>` choose a case; light and dark are followed; paper is light, whatever the screen is. */
  private listen(): void {
    addEventListener('hashchange', () => {
      const linked = this.linked();
      if (linked) this.show(linked);
    });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', readInk);
    const print = (on: boolean) => {
      document.documentElement.classList.toggle('paper', on);
      readInk();
      this.player.draw();
      for (const { plot } of this.plots) {
        const width = on ? PAPER : (plot.root.parentElement?.clientWidth ?? PAPER);
        plot.setSize({ width, height: plot.height });
        plot.redraw(false, true);
      }
    };
    addEventListener('beforeprint', () => print(true));
    addEventListener('afterprint', () => print(false));
  }

  private linked(): PackedCase | undefined {
    return this.report.cases.find(({ id }) =>
      [id, encodeURIComponent(id)].includes(location.hash.replace('#case-', '')),
    );
  }

  private show(packed: PackedCase): void {
    this.choice.show(packed);
    let refusal = '';
    try {
      this.draw(unpack(this.report, packed));
    } catch (error) {
      refusal = `This case cannot be drawn: ${error instanceof Error ? error.message : String(error)}.`;
    }
    this.refusal.textContent = refusal;
    this.refusal.hidden = refusal === '';
    this.signals.hidden = refusal !== '';
    this.spring.hidden = refusal !== '' || !this.shown?.windings;
  }

  private draw(shown: Case): void {
    const isAlike = this.shown !== null && String(whole(this.shown)) === String(whole(shown));
    const times = isAlike ? this.timeline.times : this.first(shown);
    this.shown = shown;
    this.pointed = null;
    const { nominal_force_n: nominal } = this.report;
    this.table = new SignalTable(this.scroll, shown, nominal, this.hidden, (name) => this.toggle(name));
    this.timeline.clear();
    this.plots = drawCharts(this.charts, this.timeline, {
      report: this.report,
      shown,
      hidden: this.hidden,
      pointed: (time) => this.follow(time),
    });
    this.zoom(times);
    this.gain.value = String(GAINS.indexOf(this.player.enlarged));
    this.moveTo(this.time, true);
  }

  /** What is shown of a case at first. */
  private first(shown: Case): Times {
    const [start, end] = whole(shown);
    const { clientWidth } = byId('coilsense-signals');
    const [line] = shown.packed.surge_lines_hz;
    return [start, clientWidth < WIDE && line ? Math.min(end, start + Math.floor(clientWidth / SURGE) / line) : end];
  }

  private zoom(times: Times | null): void {
    const { shown } = this;
    if (!shown) return;
    const all = whole(shown);
    const [from, to] = times ?? all;
    this.timeline.show([from, to], all);
    this.reset.disabled = from <= all[0] && to >= all[1];
    this.table?.within([from, to]);
    if (this.time < from || this.time > to) this.moveTo(from, true);
    if (!shown.windings) return;
    const series = Object.fromEntries(shown.signals.map(({ name, values }) => [name, values]));
    const facts = { spring: shown.windings.coil, clash: { firstContact: shown.packed.first_contact_s } };
    const answer = { series: { ...series, time: shown.times }, facts };
    this.player.show({ frames: shown.windings.frames, times: [from, to], answer });
  }

  private toggle(name: string): boolean {
    const show = this.hidden.delete(name);
    if (!show) this.hidden.add(name);
    for (const { plot, signals } of this.plots)
      signals.forEach((signal, index) => signal.name === name && plot.setSeries(index + 1, { show }));
    return show;
  }

  private enlarge(step: number): void {
    this.player.enlarge(GAINS[step] ?? 1);
    this.player.draw();
  }

  private point(time: number): void {
    if (this.shown?.windings) this.player.goTo(time);
    else this.moveTo(time, true);
  }

  private follow(pointed: number | null): void {
    if (pointed === this.pointed) return;
    this.pointed = pointed;
    this.table?.at(pointed ?? this.time);
  }

  private moveTo(time: number, told: boolean): void {
    this.time = time;
    this.timeline.moveMark(time);
    if (!told || !this.shown) return;
    this.table?.at(this.pointed ?? time);
    const { windings } = this.shown;
    if (windings) this.closest.textContent = closest(windings, time);
  }
}

const whole = ({ times }: Case): Times => [times[0] ?? 0, times[times.length - 1] ?? 1];

/** How near windings are to each other at a time [s]. */
function closest({ frames, coil, gapsPerPitch }: NonNullable<Case['windings']>, time: number): string {
  const inner = positionsAt(frames, time).subarray(1, -1);
  const pitches = inner.subarray(1).map((place, index) => place - (inner[index] ?? 0));
  const pairs = pitches.filter((pitch) => pitch <= coil.contactPitch).length;
  const gap = (Math.min(...pitches) - coil.contactPitch) * gapsPerPitch;
  const mm = (value: number) => fixed(1e3 * value, 2);
  const touching = pairs === 0 ? 'no windings touch' : `${pairs} ${pairs > 1 ? 'pairs' : 'pair'} of windings touch`;
  return `Closest windings: gap ${mm(gap)} mm, pitch ${mm(coil.wireDiameter + gap)} mm, wire ${mm(coil.wireDiameter)} mm: ${touching}. Where displacements are enlarged, only what is marked ▲ touches.`;
}
