// The main tab: the spring in slow motion, its forces and their spectrum, what may be dragged, and how far each force is off.
//
// Next door: each of its parts (`inputs`, `plots`, `spring`, `results`), what is computed (`compute`).

import type { Facts } from '../answer';
import type { Shown } from '../compute';
import { make } from '../dom';
import { Choose } from '../inputs/choose';
import { Panels } from '../inputs/panels';
import { ForcePlot } from '../plots/forces';
import { readInk } from '../plots/looks';
import { ReadOut } from '../plots/readout';
import { SpectrumPlot } from '../plots/spectrum';
import { Downloads } from '../results/downloads';
import { sentence } from '../results/sentence';
import { Table } from '../results/table';
import { showWarnings, springLine } from '../results/warnings';
import { Player } from '../spring/player';
import type { Store } from '../state';
import type { Open } from './tab';

export const open: Open = (panel, store, compute) => {
  const parts = layOut(panel);
  readInk();
  const clock = (event: Event) => compute.mark(event);
  const choose = new Choose(store, parts.choose, parts.first);
  const panels = new Panels(store, parts.first, parts.fields, clock);
  const table = new Table(store, parts.table);
  const spectrum = new SpectrumPlot(parts.spectrum);
  const forces = new ForcePlot(parts.forces, {
    zoom: (times) => store.setView({ times }),
    point: (time) => player.goTo(time),
  });
  const readOut = new ReadOut(parts.keys);
  const player = new Player(store, parts.spring, parts.canvas, (time, inMotion) => {
    forces.moveMark(time);
    readOut.at(time, inMotion);
  });
  const downloads = new Downloads(store, compute, parts.downloads, () => forces.plot);
  const views = new Views(store, parts.views, forces);
  let facts: Facts | null = null;

  const inputs = () => {
    choose.show(store.state);
    panels.show(store.state, facts);
  };
  const curves = (shown: Shown) => {
    const { hidden } = store.state.view;
    forces.show(shown.answer, shown.times, shown.answer.facts.goal, hidden);
    spectrum.show(shown.answer, hidden);
  };
  let last: Shown | null = null;
  let clocked = 0;
  forces.onDrawn = () => {
    if (last && performance.getEntriesByName('first curves').length === 0) performance.mark('first curves');
    if (!last?.since || last.since === clocked) return;
    clocked = last.since;
    performance.measure('slider to plots', { start: clocked, end: performance.now() });
  };
  store.subscribe((state, before) => {
    inputs();
    if (last && state.view.hidden !== before.view.hidden) {
      curves(last);
      table.show(last.answer.facts, last.exact);
    }
  });
  compute.listen({
    shown: (shown) => {
      [last, facts] = [shown, shown.answer.facts];
      curves(shown);
      readOut.show(shown);
      player.show(shown);
      document
        .getElementById('sentence')
        ?.replaceChildren(
          ...sentence(shown.answer).filter((part) => part !== null && part !== undefined && part !== false),
        );
      table.show(facts, shown.exact);
      showWarnings(parts.warnings, facts, shown.exact?.facts ?? null);
      parts.facts.textContent = springLine(facts);
      parts.status.textContent = shown.exact ? 'exact' : 'preview …';
      parts.status.classList.toggle('preview', !shown.exact);
      panels.show(store.state, facts);
      views.show(shown);
      downloads.show(shown);
      document.body.dataset['exact'] = String(shown.exact !== null);
    },
    refused: (refusal) => {
      const beside = panels.refuse(refusal);
      parts.refusal.hidden = refusal === null;
      const words = [
        beside ? '' : (refusal?.text ?? ''),
        refusal && last ? 'What is shown is the last state that could be computed.' : '',
      ];
      parts.refusal.textContent = words.filter(Boolean).join(' ');
      if (refusal && !last) document.getElementById('sentence')?.replaceChildren('Nothing is computed yet.');
    },
    busy: () => {},
  });
  addEventListener('keydown', (event) => {
    if (event.key === ' ' && event.target === document.body) {
      event.preventDefault();
      player.setPlaying(parts.canvas.closest('.see')?.querySelector('.play')?.textContent === 'Play');
    }
  });
  Object.assign(window, { coilsense: { framesPerSecond: () => player.framesPerSecond, last: () => last } });
  inputs();
};

/** Which times are shown, by buttons. */
class Views {
  private shown: Shown | null = null;

  constructor(
    private readonly store: Store,
    host: HTMLElement,
    forces: ForcePlot,
  ) {
    const button = (label: string, title: string, act: () => void) =>
      make('button', { type: 'button', class: 'plain', title, onclick: act }, label);
    const condition = () => this.shown?.answer.facts.conditions[this.shown.answer.facts.condition];
    host.replaceChildren(
      button('First ringing', 'The first six surge periods', () => this.store.setView({ times: null })),
      button('Judged', 'The part that the table is about', () =>
        this.store.setView({ times: condition()?.window ?? null }),
      ),
      button('All', 'All that was simulated', () => this.store.setView({ times: [0, condition()?.duration ?? 1] })),
      button('+', 'Zoom in', () => forces.zoomBy(2)),
      button('−', 'Zoom out', () => forces.zoomBy(0.5)),
    );
  }

  show(shown: Shown): void {
    this.shown = shown;
  }
}

function layOut(panel: HTMLElement) {
  const canvas = make('canvas', { class: 'coil', role: 'img' });
  const parts = {
    canvas,
    choose: make('section', { class: 'choose', 'aria-label': 'Which spring, and what happens to it' }),
    first: make('div', { class: 'first' }),
    refusal: make('p', { class: 'refusal', role: 'status', hidden: true }),
    fields: make('section', { class: 'fields', 'aria-label': 'Values' }),
    spring: make('div', { class: 'card see' }),
    status: make('span', { class: 'status' }, '…'),
    views: make('div', { class: 'views' }),
    forces: make('div', {
      class: 'plot forces',
      tabindex: 0,
      role: 'group',
      'aria-label': 'Forces over time; arrows move the mark, plus and minus zoom',
    }),
    spectrum: make('div', {
      class: 'plot spectrum',
      role: 'img',
      'aria-label': 'Amplitude of each force over frequency, with the surge lines marked',
    }),
    keys: make('p', { class: 'keys' }),
    table: make('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'How far each force is off' }),
    warnings: make('ul', { class: 'warnings' }),
    facts: make('p', { class: 'facts' }),
    downloads: make('div', { class: 'downloads' }),
  };
  panel.classList.add('workbench');
  panel.replaceChildren(
    parts.choose,
    make(
      'div',
      { class: 'stage' },
      parts.spring,
      make(
        'section',
        { class: 'card', 'aria-label': 'Forces over time' },
        make('div', { class: 'head' }, make('h2', {}, 'Forces'), parts.status, parts.views),
        parts.forces,
        parts.keys,
      ),
    ),
    make('div', { class: 'controls' }, parts.refusal, parts.fields),
    make(
      'div',
      { class: 'results' },
      make('section', { class: 'card' }, make('div', { class: 'head' }, make('h2', {}, 'How far off')), parts.table),
      make('section', { class: 'card' }, make('div', { class: 'head' }, make('h2', {}, 'Spectrum')), parts.spectrum),
      make(
        'section',
        { class: 'card' },
        make('div', { class: 'head' }, make('h2', {}, 'Mind')),
        parts.warnings,
        parts.facts,
        parts.downloads,
      ),
    ),
  );
  return parts;
}
