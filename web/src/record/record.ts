// A film of what is shown, for the user's disk: as WebM, or as a GIF where that is asked for or the browser compresses no video. It says how far it
// is, and can be cancelled; what is edited meanwhile does not change it.
//
// Next door: the buttons, which load this (`results/downloads`), the pictures (`picture`), the files (`video`, `gif`).

import type { Shown } from '../compute';
import { sections } from '../document';
import { clamp, digits, make } from '../dom';
import { download, nameOf } from '../download';
import { part } from '../faults';
import { CONDITION } from '../fields';
import { onset } from '../hit/act';
import { FORCE_LINES, readings } from '../plots/lines';
import { usualSpeed } from '../spring/scene';
import type { State } from '../state';
import type { Made, Making, Source } from './frames';
import { Picture } from './picture';
import { codec, video } from './video';

export type Kind = 'webm' | 'gif';

/** No film is shorter or longer [s]. */
const LENGTH = [2, 12] as const;
/** How often it is looked whether the exact case is there [ms]. */
const LOOK = 100;

let running: AbortController | null = null;

/** Makes a film of what is shown as soon as that is exact, and saves it; `host` has the words, the bar and *Cancel*. */
export async function record(
  kind: Kind,
  host: HTMLElement,
  state: () => State,
  last: () => Shown | null,
): Promise<void> {
  if (running) return;
  const abort = (running = new AbortController());
  const bar = make('progress', { 'aria-label': 'Pictures of the film', max: 1, value: 0 });
  const words = make('span', { role: 'status' });
  const cancel = make('button', { type: 'button', class: 'plain', onclick: () => abort.abort() }, 'Cancel');
  const hadFocus = document.activeElement;
  host.replaceChildren(words, bar, cancel);
  const say = (text: string) => (words.textContent = text);
  const making: Making = {
    told: (done, of) => {
      bar.value = done / of;
      bar.title = `${done} of ${of}`;
    },
    signal: abort.signal,
  };
  try {
    say('Waiting for the exact case …');
    const shown = await exact(last, abort.signal);
    say('Recording …');
    const source = sourceOf(shown, state());
    const { made, note } = await film(kind, source, making);
    download(`${nameOf(shown)}.${made.ending}`, made.blob, made.blob.type);
    say(`${note}Saved: ${digits(source.seconds, 2)} s, ${digits(made.blob.size / 1e6, 2)} MB.`);
  } catch (reason) {
    say(abort.signal.aborted ? 'Cancelled: nothing is saved.' : `No film could be made: ${text(reason)}.`);
  } finally {
    running = null;
    bar.remove();
    const isHere = document.activeElement === cancel;
    cancel.remove();
    if (isHere && hadFocus instanceof HTMLElement) hadFocus.focus();
  }
}

const text = (reason: unknown): string => (reason instanceof Error ? reason.message : String(reason));

/** As it was asked for; what a browser cannot compress is a GIF, and that is said. */
async function film(kind: Kind, source: Source, making: Making): Promise<{ made: Made; note: string }> {
  const found = kind === 'webm' ? await codec() : null;
  let note = kind === 'webm' && !found ? 'This browser writes no WebM, so it is a GIF. ' : '';
  if (found)
    try {
      return { made: await video(source, found, making), note };
    } catch {
      making.signal.throwIfAborted();
      note = 'This browser’s WebM failed, so it is a GIF. ';
    }
  const { gif } = await part('What writes GIFs', () => import('./gif'));
  return { made: await gif(source, making), note };
}

/** What is shown, once it is exact. */
async function exact(last: () => Shown | null, signal: AbortSignal): Promise<Shown> {
  for (;;) {
    signal.throwIfAborted();
    const shown = last();
    if (shown?.exact) return shown;
    await new Promise((resolve) => setTimeout(resolve, LOOK));
  }
}

/** As fast as the player runs, within limits. */
function sourceOf(shown: Shown, { spec, view }: State): Source {
  const { facts } = shown.answer;
  const whole = shown.times[1] - shown.times[0];
  const seconds = clamp(whole / (view.slow || usualSpeed(shown.times)), ...LENGTH);
  const condition = sections(spec, 'condition')[facts.condition];
  const kind = facts.conditions[facts.condition]?.kind ?? '';
  const strength = (CONDITION[kind]?.first ?? []).flatMap(({ key }) => condition?.[key] ?? []);
  const title = [
    facts.spring.name,
    [facts.conditions[facts.condition]?.name ?? '', ...(strength.length > 0 ? [`at ${strength.join(', ')}`] : [])].join(
      ' ',
    ),
    facts.dampings[facts.damping]?.label ?? '',
  ].join(', ');
  const forces = FORCE_LINES.filter(({ name }) => !view.hidden.includes(name) && shown.answer.series[name]);
  const lines = [...forces, ...readings(shown.exact?.facts ?? null, view.sensors)];
  const picture = new Picture({ shown, title, lines, onset: onset(condition), pace: pace(seconds / whole) });
  return { title, seconds, draw: (share, width) => picture.draw(share, width) };
}

/** How much slower than the spring. */
function pace(slower: number): string {
  if (Math.abs(slower - 1) < 0.01) return 'real time';
  return slower > 1 ? `${digits(slower, 3)}× slower` : `${digits(1 / slower, 3)}× faster`;
}
