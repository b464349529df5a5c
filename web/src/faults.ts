// What stands in the way, said below whatever is shown, with a button that tries again; and what is tried until it succeeds.
//
// Next door: how a part is loaded once more (`anew`), files and engines (`fetched`), workers (`alive`), what is said before any of this runs (`guard`).

import { make } from './dom';

/** Nothing is silent for longer [ms]. */
export const SILENT = 2500;

const host = make('section', { id: 'notices', 'aria-label': 'Notes' });
document.body.prepend(host);

const button = (label: string, act: () => void) =>
  make('button', { type: 'button', class: 'plain', onclick: act }, label);

/** What comes back takes it away. */
function put(isFault: boolean, text: string, label: string, act: () => void, ...more: HTMLElement[]): () => void {
  const element = make(
    'div',
    { class: isFault ? 'refusal' : 'said', role: isFault ? 'alert' : 'status' },
    make('span', {}, text),
    label !== '' && button(label, act),
    ...more,
  );
  host.append(element);
  return () => element.remove();
}

const said = new Map<string, () => void>();

/** Says something until it is read, or what may be done about it is; of one kind only the newest. */
export function say(kind: string, text: string, label = '', act = () => {}): void {
  said.get(kind)?.();
  const gone = put(
    false,
    text,
    label,
    act,
    button('OK', () => gone()),
  );
  said.set(kind, gone);
}

/** Says that something takes long, with a way out where there is one; what comes back takes it away. */
export const slow = (text: string, label = '', act = () => {}): (() => void) => put(false, text, label, act);

const MENDED = 'mended';
/** After these it may go well: the network is back, or something else that was missing is there. */
const HOPES = ['online', MENDED];

const open = new Map<string, Promise<void>>();
let pressed = '';

/** Says a fault, and waits until the user tries again, or the network is back. */
export function again(what: string, text: string): Promise<void> {
  const known = open.get(what);
  if (known) return known;
  const promise = new Promise<void>((resolve) => {
    const done = () => {
      gone();
      for (const event of HOPES) removeEventListener(event, done);
      open.delete(what);
      resolve();
    };
    const gone = put(true, text, 'Try again', () => {
      pressed = what;
      done();
    });
    for (const event of HOPES) addEventListener(event, done);
    // Whoever pressed it does not lose the place.
    if (pressed === what) host.querySelector<HTMLElement>('.refusal:last-child button')?.focus();
  });
  open.set(what, promise);
  return promise;
}

/** What a browser says of a file that it could not have, in words. */
function why(reason: unknown): string {
  if (!navigator.onLine) return 'this device is offline';
  const text = String(reason instanceof Error ? reason.message : reason).replace(/https?:\S*\//, '');
  if (reason instanceof SyntaxError || reason instanceof WebAssembly.CompileError) return 'its file came cut short';
  return reason instanceof TypeError ? 'its file is missing or the network is down' : text;
}

/** Does what needs a file, again and again until it succeeds: says when that takes long, and what went wrong. */
export async function persistently<T>(what: string, act: (isAgain: boolean) => Promise<T>): Promise<T> {
  for (let isAgain = false; ; isAgain = true) {
    let quick = () => {};
    const late = setTimeout(() => (quick = slow(`${what}: still loading …`)), SILENT);
    try {
      const found = await act(isAgain);
      // Several parts may want one file: what was mended for one is tried for all.
      if (isAgain) dispatchEvent(new Event(MENDED));
      return found;
    } catch (reason) {
      quick();
      clearTimeout(late);
      await again(what, `${what} could not be loaded: ${why(reason)}. Nothing that you set is lost.`);
    } finally {
      quick();
      clearTimeout(late);
    }
  }
}

const parts = new Map<string, Promise<unknown>>();

/** A part of the page that is loaded when it is first wanted; `load` imports it. */
export function part<T>(what: string, load: () => Promise<T>): Promise<T> {
  const known =
    parts.get(what) ??
    persistently(what, (isAgain) => (isAgain ? import('./anew').then(({ anew }) => anew(load)) : load()));
  parts.set(what, known);
  return known as Promise<T>;
}
