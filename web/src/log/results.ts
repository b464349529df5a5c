// The right side of the tab: what was recorded, what it says, the calibration; faded while a choice is wrong.
//
// Next door: each part (`recorded`, `found`, `calibration`), who asks (`tabs/log`).

import type { Answer } from '../answer';
import { digits, make } from '../dom';
import type { Times } from '../plots/timeline';
import { showCalibration, type Told } from './calibration';
import { card, showFound, type Ways } from './found';
import { saysSomething, type Recorded, type Said } from './identification';
import { showRecorded } from './recorded';

export class Results {
  private readonly clock = make('div', { class: 'found' });
  private readonly head = make('div', { class: 'found' });
  private readonly found = make('div', { class: 'found' });
  private readonly recorded = make('div', { class: 'found' });
  private readonly note = make(
    'p',
    { class: 'refusal note', hidden: true },
    'What stands here is of the choices as they were before.',
  );
  private readonly calibration = make('div', { class: 'found' });
  private readonly ofLog = [this.head, this.clock, this.recorded, this.found];
  readonly element = make('div', { class: 'told' }, this.note, ...this.ofLog, this.calibration);

  /** The times that are shown of the log. */
  private range: Times | null = null;
  private isEmpty = true;

  /** `empty` makes what stands here before any log does. */
  constructor(
    private readonly ways: Ways,
    private readonly empty: () => HTMLElement,
  ) {}

  /** Nothing is left of the last log; what is said in its place. */
  clear(instead: string): void {
    for (const part of [...this.ofLog, this.calibration]) {
      part.replaceChildren();
      part.classList.remove('stale');
    }
    this.note.hidden = true;
    [this.range, this.isEmpty] = [null, true];
    this.head.replaceChildren(make('p', { class: 'hint' }, instead));
  }

  /** What brings back all that is shown, as it is. */
  keep(): () => void {
    const parts = [...this.ofLog, this.calibration].map(
      (part) => [part, [...part.childNodes], part.className] as const,
    );
    const { range, isEmpty } = this;
    const { hidden } = this.note;
    return () => {
      for (const [part, nodes, looks] of parts) {
        part.replaceChildren(...nodes);
        part.className = looks;
      }
      [this.range, this.isEmpty, this.note.hidden] = [range, isEmpty, hidden];
    };
  }

  /** What is shown is not of the choices as they are; without a log, how to begin. */
  fade(): void {
    if (this.isEmpty) return this.head.replaceChildren(this.empty());
    this.note.hidden = false;
    for (const part of this.ofLog) part.classList.add('stale');
  }

  /** Shows what came of a log; why it says nothing, else nothing. */
  showLog(name: string, answer: Answer<unknown>): string {
    const facts = answer.facts as Recorded;
    this.note.hidden = true;
    this.isEmpty = false;
    for (const part of this.ofLog) part.classList.remove('stale');
    this.showClock(facts);
    showRecorded(this.recorded, facts, answer.series, this.range, (range) => (this.range = range));
    if (saysSomething(facts)) {
      showFound(this.head, this.found, name, answer as Answer<Said>, this.ways);
      return '';
    }
    for (const part of [this.head, this.found]) part.replaceChildren();
    return facts.refusal ?? 'the log says nothing';
  }

  private showClock({ clock }: Recorded): void {
    if (!clock) return this.clock.replaceChildren();
    const { file, offset, found } = clock;
    const milliseconds = (value: number) => `${digits(1e3 * value, 6)} ms`;
    const drift = found?.drift
      ? `drift ${digits(found.drift[0], 4)} ± ${digits(found.drift[1], 2)} ppm`
      : 'drift not resolved, taken as up to 100 ppm';
    const words = found
      ? `${milliseconds(offset)} were added to its times, ± ${milliseconds(found.halfWidth)} in 95 of 100 cases: its ${found.channels[1]} against ${found.channels[0]} of the first, correlation ${digits(found.correlation, 3)}, ${drift}.`
      : `${milliseconds(offset)} were added to its times, as told.`;
    this.clock.replaceChildren(card('The second device', make('p', {}, `${file}: ${words}`)));
  }

  /** A log without a force, but with inductances. */
  onlyCalibration(): void {
    this.clear('No column is a force, so nothing is said of what rings; see the calibration.');
  }

  showCalibration(name: string, answer: Answer<unknown> | null): void {
    this.calibration.replaceChildren();
    const still = 'No calibration: the positions stand still in this log, so that its L is that of one length.';
    if (answer && (answer.facts as Partial<Told>).json) showCalibration(this.calibration, name, answer as Answer<Told>);
    else if (answer) this.calibration.replaceChildren(card('Calibration', make('p', { class: 'hint' }, still)));
  }

  refuseCalibration(error: string): void {
    this.calibration.replaceChildren(card('Calibration', make('p', { class: 'refusal' }, error)));
  }
}
