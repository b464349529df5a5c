// What is computed of a state, and when: a preview of every state, the exact case once the state rests. Newer states win.
//
// Next door: one worker's queue (`lane`), those of an engine (`lanes`), what shows the results (`tabs`).

import type { Answer, ExactFacts, Facts, Job, Question } from './answer';
import { section, toToml, withValue } from './document';
import engineAddress from './engine/coilsense_web_bg.wasm?url';
import { part, persistently, say } from './faults';
import { compiled, text } from './fetched';
import { Lane, type Reply } from './lane';
import { Lanes } from './lanes';
import { played } from './playback';
import { preset } from './presets';
import { isOther, type State } from './state';
import type { Store } from './store';
import { workshop } from './workshop';

/** A state rests after so long [ms]. */
const REST = 140;
/** Most values of a link that are put right before the preset stands in for it. */
const MOST_MENDED = 8;
/** Most times that are drawn while a slider moves. */
const MOST_SAMPLES = 2000;
/** What is shown where nobody chose: so many first surge periods as fit the screen. */
const PERIODS = innerWidth < 640 ? 3 : 6;
/** What the finding is told of, on every screen. */
const TOLD_PERIODS = 6;

export interface Shown {
  /** The curves: of the exact case where it is there, else of the preview. */
  answer: Answer<Facts>;
  /** The exact case, where it is that of the state. */
  exact: Answer<ExactFacts> | null;
  /** The spec that the exact case is of. */
  exactText: string;
  /** Positions over the shown times. */
  frames: { times: Float64Array; positions: Float32Array; columns: number };
  /** Shown times [s]. */
  times: [number, number];
  /** When the input came that it answers [ms], on the clock of events. */
  since: number;
}

const hireLarger = () => new Worker(new URL('./meeting.worker.ts', import.meta.url), { type: 'module' });

/** Whether a spec, as the page writes it, has windings that meet. */
const meets = (text: string): boolean => /^\[contact\]$/m.test(text);

/** Why a state could not be computed, and the place in the spec that it is about. */
export interface Refusal {
  place: string;
  text: string;
  /** The place holds something that no spec has. */
  isUnknown?: boolean;
  /** What is shown is the state without it. */
  stands?: boolean;
}

type Listener = { shown(shown: Shown): void; refused(refusal: Refusal | null): void; busy(busy: boolean): void };

/** What tells a refusal in words. */
export const refusals = () => part('What tells why a value is refused', () => import('./refusals'));

export class Compute {
  private readonly files = new Map<string, string>();
  private readonly first: Lanes;
  /** The larger engine's, once windings are to meet. */
  private larger: Lanes | null = null;
  /** Workers of the larger engine that parts have by themselves. */
  private readonly parts: Lane[] = [];
  private readonly listeners: Listener[] = [];
  private readonly loaded = new Map<string, Promise<void>>();
  private last: Shown | null = null;
  /** The newest exact case, and the spec that it is of; it may come before the first preview. */
  private exact: Answer<ExactFacts> | null = null;
  private exactText = '';
  /** How fast the condition was played that was shown last. */
  private playedAt = 1;
  private rest = 0;
  private since = 0;
  /** How often a state was answered or refused: words of a refusal that come late are not said. */
  private judged = 0;
  /** Places of links and files that no spec has. */
  private readonly unknown: string[] = [];
  /** Where the very first state is refused: why, and the state that stands in for it, which is without what is wrong. */
  private instead: { state: State; refusal: Refusal; tries: number } | null = null;

  constructor(private readonly store: Store) {
    const engine = persistently('The engine', (isAgain) =>
      compiled(engineAddress, isAgain).catch((reason: unknown) => {
        this.refused({ place: '', text: 'The engine could not be loaded.' });
        throw reason;
      }),
    );
    const hire = () => new Worker(new URL('./engine.worker.ts', import.meta.url), { type: 'module' });
    this.first = new Lanes(engine, this.files, hire);
    store.subscribe((state, before) => {
      const moved = isOther(state, before);
      if (moved || state.view.times !== before.view.times) void this.follow(state, moved);
    });
  }

  listen(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** Begins with the state as it is. */
  begin(): void {
    void this.follow(this.store.state, true);
  }

  /** An input event from which on the clock runs. */
  mark(event: Event): void {
    this.since = event.timeStamp;
  }

  /** Any one question, in the lane of exact answers. */
  ask(question: Question): Promise<Reply> {
    return new Promise((resolve) => this.lanes(question).exacts.ask(question, resolve));
  }

  /** The newest question of a part that asks often, in a worker beside the others; nobody answers one that a newer one overtook. */
  beside(question: Question, done: (reply: Reply) => void): void {
    this.lanes(question).asides.ask(question, done);
  }

  /** A worker of its own for a part that asks much of such a spec; the part ends it. */
  laneOf(question: { text: string }): Lane {
    return this.lanes(question).lane(false);
  }

  /** A worker of the larger engine for a part that asks it often. */
  workshopLane(): Lane {
    const lane = new Lane(workshop(), this.files, false, hireLarger);
    this.parts.push(lane);
    return lane;
  }

  /** One question in a worker of its own, which waits for nothing and ends with its answer, or with the signal, after which nobody answers. */
  async alone(question: Question, over?: AbortSignal): Promise<Reply> {
    const lane = this.lanes(question).lane(false);
    over?.addEventListener('abort', () => lane.end());
    const reply = await new Promise<Reply>((resolve) => lane.ask(question, resolve));
    lane.end();
    return reply;
  }

  /** A job for the larger engine, in a worker of its own, which tells how much is done until somebody cancels it. */
  job(
    job: Job,
    told: (done: number, of: number, file?: string) => void,
  ): { reply: Promise<Reply>; cancel: () => void } {
    let isOver = false;
    let cancel = () => {};
    const run = async (): Promise<Reply> => {
      await this.load(this.store.state.preset);
      const { begin } = await part('What asks the larger engine', () => import('./jobs/job'));
      // Nobody hears what was cancelled.
      if (isOver) return new Promise(() => {});
      const begun = begin(job, this.files, told);
      cancel = begun.cancel;
      return begun.reply;
    };
    return {
      reply: run(),
      cancel: () => {
        isOver = true;
        cancel();
      },
    };
  }

  /** The files that specs may name, once those of the preset are there. */
  async known(): Promise<Map<string, string>> {
    await this.load(this.store.state.preset);
    return this.files;
  }

  /** A file that a spec of the user's names. */
  addFile(name: string, text: string): void {
    this.files.set(name, text);
    this.first.addFile(name, text);
    this.larger?.addFile(name, text);
    for (const lane of this.parts) lane.addFile(name, text);
  }

  /** The case that is shown, as a question. */
  question(state: State): { text: string; condition: number; damping: number; places: string[] } {
    const { text, places } = toToml(state.spec);
    return { text, places, condition: state.view.condition, damping: state.view.damping };
  }

  /** Of the engine that a question needs: windings that meet take the larger one. */
  private lanes(question: { text: string } | Question): Lanes {
    if (!('text' in question && meets(question.text))) return this.first;
    if (this.larger) return this.larger;
    return (this.larger = new Lanes(workshop(), this.files, hireLarger));
  }

  private refused(refusal: Refusal | null): void {
    for (const listener of this.listeners) listener.refused(refusal);
  }

  /** The spec with as many masses as the exact case has, so that windings are drawn where that has them meet. */
  private asFine({ spec }: State, text: string): string {
    const { contact, spring } = this.exact?.facts ?? {};
    const isGiven = 'masses_per_winding' in section(spec, 'spring');
    if (!contact || !spring || isGiven || spring.massesPerWinding < 2) return text;
    return toToml(withValue(spec, 'spring.masses_per_winding', spring.massesPerWinding)).text;
  }

  private async follow(state: State, moved: boolean): Promise<void> {
    // A preset without files must not wait for a turn of the loop.
    const files = Object.keys(preset(state.preset).files);
    if (files.some((file) => !this.files.has(file))) {
      await this.load(state.preset);
      if (isOther(this.store.state, state)) return;
    }
    const asked = this.question(state);
    if (moved) {
      this.first.exacts.drop();
      this.larger?.exacts.drop();
      // What the other engine still has under way is of an earlier state.
      for (const lanes of [this.first, this.larger]) if (lanes !== this.lanes(asked)) lanes?.drop();
      clearTimeout(this.rest);
    }
    this.askPreview(state, asked, moved);
  }

  private askPreview(state: State, asked: ReturnType<Compute['question']>, moved: boolean): void {
    const { places: _, ...question } = asked;
    const begun = this.since;
    const times = this.times(state);
    const rate = this.last?.answer.facts.conditions[state.view.condition]?.sampleRate ?? 10_000;
    const samples = Math.max(2, Math.min(MOST_SAMPLES, Math.round((times[1] - times[0]) * rate) + 1));
    const { text } = question;
    const drawn = text === this.exactText ? this.asFine(state, text) : text;
    const of = { kind: 'preview' as const, from: times[0], to: times[1], samples, ...question, text: drawn };
    this.lanes(question).previews.ask(of, (reply) => {
      if ('error' in reply) return void this.refuse(reply.error, state, asked);
      if (!('answer' in reply)) return;
      const answer = reply.answer as Answer<Facts>;
      // A new condition may be shorter than the times that were asked for, or have another surge frequency.
      const fitting = this.times(state, answer.facts);
      const stands = state === this.instead?.state;
      // What was exact of an earlier state is none of this one, even where its preview comes late.
      const same = question.text === this.exactText && !isOther(this.store.state, state);
      this.playedAt = played(state.spec, state.view.condition);
      this.take(answer, fitting, same, begun, stands);
      const off = Math.abs(fitting[1] - times[1]) > 0.2 * times[1] || fitting[0] !== times[0];
      if (off && stands) this.askPreview(state, asked, false);
      else if (off) this.askPreview(this.store.state, this.question(this.store.state), false);
    });
    if (moved) this.rest = window.setTimeout(() => this.askExact(state, asked), REST);
  }

  private askExact(state: State, asked: ReturnType<Compute['question']>): void {
    const { places: _, ...question } = asked;
    for (const listener of this.listeners) listener.busy(true);
    this.lanes(question).exacts.ask({ kind: 'exact', ...question }, (reply) => {
      for (const listener of this.listeners) listener.busy(false);
      if ('error' in reply) return void this.refuse(reply.error, state, asked);
      if (!('answer' in reply)) return;
      const answer = reply.answer as Answer<ExactFacts>;
      [this.exact, this.exactText] = [answer, question.text];
      if (!this.last) return;
      this.show({ ...this.last, answer, exact: answer, exactText: question.text });
      const { times, frames } = this.last;
      const isCoarse = this.asFine(this.store.state, question.text) !== question.text;
      if (isCoarse || frames.times[frames.times.length - 1] !== times[1])
        this.askPreview(state === this.instead?.state ? state : this.store.state, asked, false);
    });
  }

  /** A preview: curves while nothing better is there, positions always. */
  private take(
    answer: Answer<Facts>,
    times: [number, number],
    stillExact: boolean,
    since: number,
    stands: boolean,
  ): void {
    const time = answer.series['time'] ?? new Float64Array();
    const frames = { times: time, positions: answer.positions, columns: answer.facts.spring.masses + 2 };
    const same = this.exact && stillExact && this.sameCase(answer.facts, this.exact.facts) ? this.exact : null;
    this.judged += 1;
    if (!stands) this.refused(null);
    this.show({ answer: same ?? answer, exact: same, exactText: this.exactText, frames, times, since });
    if (stands) this.refused(this.instead?.refusal ?? null);
  }

  private sameCase(a: Facts, b: Facts): boolean {
    return a.condition === b.condition && a.damping === b.damping;
  }

  private show(shown: Shown): void {
    this.last = shown;
    for (const listener of this.listeners) listener.shown(shown);
  }

  private async refuse(error: string, state: State, asked: ReturnType<Compute['question']>): Promise<void> {
    clearTimeout(this.rest);
    const number = ++this.judged;
    const { mended, refusalOf, without } = await refusals();
    if (number !== this.judged) return;
    const { text, places } = asked;
    const refusal = refusalOf(error, text, places);
    const { place } = refusal;
    const stands = state === this.instead?.state;
    if (refusal.isUnknown && !stands) {
      this.unknown.push(place);
      say('unknown', `No spec has “${this.unknown.join('”, “')}”: left out of what the link or the file says.`);
      return this.store.leaveOut(without(state.spec, place));
    }
    if (!stands) this.refused(refusal);
    const tries = stands ? (this.instead?.tries ?? 0) + 1 : 0;
    if (this.last || tries > MOST_MENDED + 1) return;
    // The very first state: what stands in for it is without what is wrong, or the preset where that is too much.
    const instead = mended(state, tries > MOST_MENDED ? '' : place);
    this.instead = {
      state: instead,
      refusal: { ...(stands && this.instead ? this.instead.refusal : refusal), stands: true },
      tries,
    };
    this.askPreview(instead, this.question(instead), true);
  }

  /** The times that are shown [s]: the chosen ones within the condition, or its first surge periods. */
  private times(state: State, facts = this.last?.answer.facts, periods = PERIODS): [number, number] {
    const { condition } = state.view;
    const { duration: told = 1, kind, window } = facts?.conditions[condition] ?? {};
    // Facts of the state before may be of a recording that was played at another speed.
    const slower = facts === this.last?.answer.facts ? this.playedAt / played(state.spec, condition) : 1;
    const duration = told * slower;
    // Of the coil's own first mode: on a mass at end 2 the lowest line is the mass's swing.
    const { lines, spring } = facts ?? {};
    const ring = lines?.find((line) => line > 0.4 * (spring?.surgeFrequency ?? 0));
    // A recorded motion may begin with rest: where it is judged, it rings.
    const begin = kind === 'recorded' ? slower * (window?.[0] ?? 0) : 0;
    const first: [number, number] = [begin, Math.min(duration, begin + periods / (ring ?? lines?.[0] ?? 54))];
    const [from, to] = state.view.times ?? first;
    return from < duration && to > from ? [Math.max(0, from), Math.min(to, duration)] : first;
  }

  /** The times that the finding is told of [s]: an exact case has more than a small screen shows, a preview has not. */
  told({ exact, times }: Shown): [number, number] {
    return exact ? this.times(this.store.state, exact.facts, TOLD_PERIODS) : times;
  }

  /** What a preset's spec names. */
  load(id: string): Promise<void> {
    const known = this.loaded.get(id);
    if (known) return known;
    const each = Object.entries(preset(id).files).map(async ([name, { address, bytes }]) =>
      this.addFile(name, await persistently(`The recorded motion ${name}`, (isAgain) => text(address, bytes, isAgain))),
    );
    const all = Promise.all(each).then(() => undefined);
    this.loaded.set(id, all);
    return all;
  }
}
