// The finding in four steps, each with a link to the moment at which it is seen: rest, blow, the wave meets an end, sensor by sensor.
//
// Next door: where it stands (`why`), the verdict on the sensors (`verdict`).

import type { ExactFacts } from '../answer';
import type { Shown } from '../compute';
import { digits, fixed, make, rich, type Child } from '../dom';
import { toHash } from '../address';
import type { Store } from '../store';
import css from '../style/verdict.css?inline';
import { wear } from '../style/wear';

/** Where the tour is of, where something else is shown: the ankle's heel strike. */
const OF_ANKLE = '#S_T&@times=[0,0.04]';

interface Step {
  heading: string;
  words: Child[];
  times: [number, number];
  at: number;
  /** Where it is seen over frequency, too [Hz]. */
  frequency?: number;
}

export class Tour {
  private readonly body = make('div', { class: 'tour' });
  private drawn = '';

  constructor(
    host: HTMLElement,
    private readonly store: Store,
    private readonly look: (times: [number, number], at: number) => void,
  ) {
    wear(css);
    host.append(this.body);
  }

  /** Of the exact case; what stands there while it is computed is of the last one. */
  show({ exact }: Shown): void {
    const facts = exact?.facts;
    if (!facts) return;
    const series = exact.series;
    const kind = facts.conditions[facts.condition]?.kind;
    const steps = kind === 'impact' ? this.steps(facts, apart(series)) : null;
    const key = JSON.stringify([kind, this.store.state.spec, this.store.state.view.damping, facts.condition]);
    if (key === this.drawn) return;
    this.drawn = key;
    this.body.replaceChildren(
      ...(steps
        ? [make('ol', {}, ...steps.map((step) => this.step(step)))]
        : [
            make(
              'p',
              {},
              'The steps are those of a hit. ',
              make('a', { href: OF_ANKLE }, 'See them at the ankle’s heel strike'),
              ', or choose an impact above.',
            ),
          ]),
    );
  }

  private steps(facts: ExactFacts, apartAt: (time: number) => number): Step[] {
    const { spring, staticForce, forces, truth, sensors } = facts;
    const way = spring.transitTime;
    const ms = (time: number) => `${fixed(1e3 * time, time < 0.1 ? 2 : 0)}\u00a0ms`;
    const percent = (force: number) => `${digits((100 * force) / spring.nominalForce)}\u00a0%`;
    const off = (name: string) => percent(forces[name]?.rmsd ?? 0);
    const own = sensors.map(({ name, deviation }) => `${name} ${percent(deviation.rmsd)}`).join(', ');
    return [
      {
        heading: 'Rest',
        words: [
          `Nothing moves: both ends pull with k × stretch, ${digits(staticForce)}\u00a0N. A load cell at either end tells the force.`,
        ],
        times: [0, 0.5 * way],
        at: 0,
      },
      {
        heading: 'Blow',
        words: [
          'All windings are given a speed at once. They run up against one end and away from the other: half way through the first pass, at ',
          `${ms(0.5 * way)}, the ends are ${digits(apartAt(0.5 * way))}\u00a0N apart, though the spring is as long as before.`,
        ],
        times: [0, way],
        at: 0.5 * way,
      },
      {
        heading: 'The wave meets the other end',
        words: [
          `Each wave takes ${ms(way)} from one end to the other and turns round there: the ends change places, ${digits(apartAt(1.5 * way))}\u00a0N apart at ${ms(1.5 * way)}, and so on, ${digits(0.5 / way)} times a second, until damping ends it.`,
        ],
        times: [0, 3 * way],
        at: 1.5 * way,
        // Where the wave that comes back takes the force away from the driven end: half of how often it goes to and fro.
        frequency: Number((0.25 / way).toPrecision(4)),
      },
      {
        heading: 'Sensor by sensor',
        words: [
          rich(
            `Off ${truth === 'F_x' ? 'k × stretch' : truth}, rms over the judged times: F_i ${off('F_i')}, F_o ${off('F_o')}, F_x ${off('F_x')}, F_L ${off('F_L')} of F_nom by themselves. A deflection sensor does not see the wave; a load cell sees only its own end of it; the inductance adds up the whole coil.`,
          ),
          own ? ` With noise, filter and lag: ${own}.` : '',
        ],
        times: [0, Math.min(12 * way, facts.conditions[facts.condition]?.duration ?? 12 * way)],
        at: 2.5 * way,
      },
    ];
  }

  private step({ heading, words, times, at, frequency }: Step): HTMLElement {
    const { state } = this.store;
    const href = toHash({ ...state, view: { ...state.view, times } });
    const go = (event: Event) => {
      event.preventDefault();
      this.look(times, at);
    };
    return make(
      'li',
      {},
      make('b', {}, `${heading}. `),
      ...words,
      ' ',
      make('a', { href, onclick: go, 'aria-label': `Show it: ${heading}` }, 'Show it'),
      ...(frequency ? [' ', this.overFrequency(frequency)] : []),
    );
  }

  /** A link to the two ends over frequency. */
  private overFrequency(frequency: number): HTMLElement {
    const { state } = this.store;
    const go = (event: Event) => {
      event.preventDefault();
      this.store.setView({ frequency });
      const there = document.querySelector<HTMLElement>('.two-ends summary');
      there?.scrollIntoView({ block: 'start' });
      there?.focus();
    };
    const href = toHash({ ...state, view: { ...state.view, frequency } });
    return make('a', { href, onclick: go }, `See it over frequency, at ${digits(frequency, 4)}\u00a0Hz`);
  }
}

/** How far the ends are apart at a time [N]. */
function apart(series: Record<string, Float64Array>): (time: number) => number {
  const [time, one, two] = [series['time'], series['F_i'], series['F_o']];
  if (!time || !one || !two) return () => NaN;
  return (at) => {
    const found = time.findIndex((t) => t >= at);
    const index = found < 0 ? time.length - 1 : found;
    return Math.abs((one[index] ?? NaN) - (two[index] ?? NaN));
  };
}
