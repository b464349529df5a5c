// The main tab: the spring in slow motion, its forces and their spectrum, what may be dragged, and how far each force is off.
//
// Next door: each of its parts (`inputs`, `plots`, `spring`, `results`), what is computed (`compute`).

import type { ExactFacts, Facts } from '../answer';
import { refusals, type Refusal, type Shown } from '../compute';
import { Compare } from '../compare/open';
import { part } from '../faults';
import { Hits } from '../hit/open';
import { Choose } from '../inputs/choose';
import { Panels } from '../inputs/panels';
import { Patience } from '../inputs/patience';
import type { Shelf } from '../inputs/shelf';
import { load as loadTyping } from '../inputs/typing';
import { ForcePlot } from '../plots/forces';
import { FORCE_LINES, readings } from '../plots/lines';
import { readInk } from '../plots/looks';
import { ReadOut } from '../plots/readout';
import { SpectrumPlot } from '../plots/spectrum';
import { Views } from '../plots/views';
import { Folded } from '../results/folded';
import { Judged } from '../results/judged';
import { Later } from '../results/later';
import { Meetings } from '../results/meetings';
import type { Outcome } from '../results/outcome';
import { say, sentence } from '../results/sentence';
import { Why } from '../results/why';
import { Player } from '../spring/player';
import { layOut } from './layout';
import { isOther } from '../state';
import { Told } from '../told';
import type { Open } from './tab';

/** So long after the first exact case what typing needs is fetched, so that it waits for nothing [ms]. */
const REST = 1500;

export const open: Open = (panel, store, compute) => {
  const parts = layOut(panel);
  readInk();
  const clock = (event: Event) => {
    compute.mark(event);
    patience.heard(event);
  };
  const choose = new Choose(store, parts.choose, parts.first);
  let shelf: Promise<Shelf> | null = null;
  const catalogue = () =>
    (shelf ??= part('The catalogue', () => import('../inputs/shelf')).then(({ Shelf }) => new Shelf(compute, facts)));
  const panels = new Panels(store, parts.first, parts.fields, clock, catalogue);
  let outcome: Outcome | null = null;
  const judged = new Judged(parts.verdict, compute, (found, failed) => {
    outcome = found;
    later.judge(found);
    compare.judged(found, failed);
  });
  const meetings = new Meetings(parts.meetings);
  const modes = new Folded(parts.modes, 'Every mode of the coil', async (element, title) => {
    const { Part } = await part(title, () => import('../modes/part'));
    return new Part(element, compute);
  });
  const response = new Folded(parts.response, 'The two ends over frequency', async (element, title) => {
    const { Part } = await part(title, () => import('../response/part'));
    return new Part(element, compute, store);
  });
  const spectrum = new SpectrumPlot(parts.spectrum);
  const forces = new ForcePlot(parts.forces, {
    zoom: (times) => store.setView({ times }),
    point: (time) => {
      player.goTo(time);
      said.tell(readOut.words);
    },
  });
  const readOut = new ReadOut(parts.keys);
  const said = new Told(parts.said);
  const speed = {
    get slow() {
      return store.state.view.slow;
    },
    set slow(slow) {
      store.setView({ slow });
    },
  };
  const moved = (time: number, told: boolean) => {
    forces.timeline.moveMark(time);
    if (told) readOut.at(time);
    hits.at(time);
  };
  // A surge period around it, as slowly as fits.
  const meet = (time: number) => {
    const { lines, conditions, condition } = last?.answer.facts ?? {};
    const period = 1 / (lines?.[0] ?? 54);
    const end = conditions?.[condition ?? 0]?.duration ?? Infinity;
    player.playFrom(time);
    store.setView({ times: [Math.max(0, time - 0.25 * period), Math.min(end, time + 0.75 * period)], slow: 0 });
  };
  const closed = () => part('What marks windings that meet', () => import('../spring/closed'));
  const player = new Player(speed, parts.spring, parts.canvas, moved, meet, closed);
  const why = new Why(parts.why, store, (times, at) => {
    store.setView({ times });
    player.goTo(at);
  });
  const { spring: card, canvas, wave: strip } = parts;
  const hits = new Hits({ store, compute, player, card, canvas, strip, last: () => last });
  const later = new Later({ store, compute, parts, forces }, (shown) => shown === last && !isPast && settle(shown));
  const views = new Views(store, parts.views, forces);
  const compare = new Compare({ store, compute, parts, forces, spectrum, last: () => last, refused: () => refused });
  let facts: Facts | null = null;
  // While a preview is shown, the sensors are those of the last exact case.
  let sensors: ExactFacts | null = null;

  const inputs = () => {
    choose.show(store.state);
    panels.show(store.state, facts);
  };
  const curves = (shown: Shown) => {
    const { hidden, sensors: wanted } = store.state.view;
    const read = readings(sensors, wanted);
    forces.show(shown.answer, shown.times, hidden, read);
    spectrum.show(shown.answer, hidden);
    readOut.show(shown, [...FORCE_LINES.filter(({ name }) => !hidden.includes(name)), ...read]);
  };
  let last: Shown | null = null;
  let atRest = 0;
  let refused: Refusal | null = null;
  let clocked = 0;
  forces.onDrawn = () => {
    if (last && performance.getEntriesByName('first curves').length === 0) {
      performance.mark('first curves');
      later.load();
    }
    if (!last?.since || last.since === clocked) return;
    clocked = last.since;
    performance.measure('slider to plots', { start: clocked, end: performance.now() });
  };
  const mark = (exact: boolean) => {
    parts.status.textContent = exact ? 'exact' : 'preview …';
    parts.status.classList.toggle('preview', !exact);
    document.body.dataset['exact'] = String(exact);
  };
  // Until the engine answers, what is shown is of another state.
  let isPast = false;
  /** Exact is what all of it is; only then is it judged. */
  const settle = ({ exact, exactText }: Shown) => {
    const isWhole = exact !== null && later.isThere;
    mark(isWhole);
    if (isWhole) judged.show(exactText, exact.facts);
  };
  if (store.state.view.frequency) response.open();
  store.subscribe((state, before) => {
    inputs();
    // A link to a frequency.
    if (state.view.frequency && state.view.frequency !== before.view.frequency) response.open();
    if (isOther(state, before)) {
      isPast = true;
      mark(false);
      modes.show(null);
      response.show(null);
      if (state.spec !== before.spec) judged.show(null);
    }
    if (last && (state.view.hidden !== before.view.hidden || state.view.sensors !== before.view.sensors)) {
      curves(last);
      later.show(last);
    }
  });
  const patience = new Patience<Refusal>((refusal) => {
    const field = panels.refuse(refusal);
    parts.refusal.hidden = refusal === null;
    refused = refusal;
    parts.refusal.textContent = refusal?.place ? '' : (refusal?.text ?? '');
    if (refusal?.place)
      void refusals().then(({ showRefusal }) => {
        if (refused === refusal) showRefusal(parts.refusal, store, refusal, field, last !== null);
      });
    if (refusal && last) mark(last.exact !== null && later.isThere);
    if (refusal && !last) document.getElementById('sentence')?.replaceChildren('Nothing is computed yet.');
  });
  compute.listen({
    shown: (shown) => {
      [last, facts] = [shown, shown.answer.facts];
      if (shown.exact) sensors = shown.exact.facts;
      if (shown.exact) atRest ||= window.setTimeout(loadTyping, REST);
      curves(shown);
      player.show(shown);
      hits.ready();
      say(sentence(shown.answer, compute.told(shown)));
      later.show(shown);
      meetings.show(shown.exact?.facts ?? null, facts);
      why.show(shown);
      const exact = shown.exact && { ...shown.exact.facts, text: shown.exactText };
      modes.show(exact);
      response.show(exact);
      panels.show(store.state, facts);
      views.show(shown);
      isPast = false;
      settle(shown);
    },
    refused: (refusal) => patience.tell(refusal),
    busy: () => {},
  });
  addEventListener('keydown', (event) => {
    if (event.key === ' ' && event.target === document.body) {
      event.preventDefault();
      player.setPlaying(parts.canvas.closest('.see')?.querySelector('.play')?.textContent === 'Play');
    }
  });
  Object.assign(window, {
    coilsense: {
      framesPerSecond: () => player.framesPerSecond,
      last: () => last,
      verdict: () => outcome,
      redraw: () => forces.redrawn(),
    },
  });
  inputs();
};
