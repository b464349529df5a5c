// The whole state in the address: a preset, what differs from it, and what of it is shown. `#S_T&spring.mass=70+g&@condition=1`
//
// Next door: what it is (`state`), who keeps it (`store`).

import { flatten, sections, unflatten, type Flat, type Value } from './document';
import { preset } from './presets';
import { defaultView, type State, type View } from './state';

const GONE = '-';

export function toHash(state: State): string {
  const parts = [encode(state.preset)];
  const [base, now] = [flatten(preset(state.preset).spec), flatten(state.spec)];
  for (const place of gone(base, now)) parts.push(GONE + encode(place));
  for (const [place, value] of now) {
    if (JSON.stringify(value) !== JSON.stringify(base.get(place)))
      parts.push(`${encode(place)}=${encode(plain(value))}`);
  }
  const usual = defaultView();
  for (const key of Object.keys(usual) as (keyof View)[]) {
    if (JSON.stringify(state.view[key]) !== JSON.stringify(usual[key]))
      parts.push(`@${key}=${encode(JSON.stringify(state.view[key]))}`);
  }
  return '#' + parts.join('&');
}

/** The state, and what of the address says nothing. */
export function fromHash(hash: string): { state: State; unread: string[] } {
  const [id = '', ...parts] = hash.replace(/^#/, '').split('&');
  const base = preset(decode(id));
  const unread = id && base.id !== decode(id) ? [decode(id) || id] : [];
  const flat = flatten(base.spec);
  const view: View = defaultView();
  for (const part of parts) {
    const [left = '', right = ''] = part.split(/=(.*)/s);
    if (left.startsWith('@')) {
      const key = decode(left.slice(1)) as keyof View;
      const value = json(decode(right));
      if (Object.hasOwn(FITS, key) && FITS[key]?.(value)) Object.assign(view, { [key]: value });
      else unread.push(decode(left) || left);
    } else if (left.startsWith(GONE)) {
      const place = decode(left.slice(1));
      for (const key of [...flat.keys()]) if (key === place || key.startsWith(`${place}.`)) flat.delete(key);
    } else if (/^[a-z]+\.(\d+\.)?[a-z_0-9]+$/.test(decode(left))) {
      flat.set(decode(left), value(decode(right)));
    } else if (part) unread.push(decode(left) || left);
  }
  const spec = unflatten(flat);
  if (view.condition >= sections(spec, 'condition').length) view.condition = 0;
  return { state: { preset: base.id, spec, view }, unread };
}

/** Places that are no longer there: whole tables by their name alone. */
function gone(base: Flat, now: Flat): string[] {
  const table = (place: string) => place.slice(0, place.lastIndexOf('.'));
  const there = new Set([...now.keys()].map(table));
  const places = new Set<string>();
  for (const place of base.keys()) if (!now.has(place)) places.add(there.has(table(place)) ? place : table(place));
  return [...places];
}

const isText = (value: unknown): boolean => typeof value === 'string';
const isCount = (value: unknown): boolean => Number.isSafeInteger(value) && Number(value) >= 0;
const areNames = (value: unknown): boolean => Array.isArray(value) && value.every(isText);
const isTime = (value: unknown): boolean => typeof value === 'number' && Number.isFinite(value) && value >= 0;
/** Texts by name, none longer than somebody types. */
const isWords = (value: unknown): boolean =>
  typeof value === 'object' &&
  value !== null &&
  !Array.isArray(value) &&
  Object.values(value).every((word) => isText(word) && word.length < 10_000);

/** What a part of the view may be: an address is typed by anybody. */
const FITS: Record<string, (value: unknown) => boolean> = {
  tab: isText,
  kept: isText,
  condition: isCount,
  damping: isCount,
  times: (value) => Array.isArray(value) && value.length === 2 && value.every(isTime) && value[0] < value[1],
  hidden: areNames,
  sensors: areNames,
  slow: (value) => isTime(value) && Number(value) <= 1,
  frequency: isTime,
  mitigate: isWords,
  log: isWords,
} satisfies Record<keyof View, (value: unknown) => boolean>;

/** Texts as they are, unless they would be read as something else. */
const plain = (value: Value): string =>
  typeof value === 'string' && typeof json(value) === 'undefined' ? value : JSON.stringify(value);
const value = (text: string): Value => (json(text) as Value | undefined) ?? text;

function json(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

const encode = (text: string): string =>
  encodeURIComponent(text).replaceAll('%20', '+').replaceAll('%2F', '/').replaceAll('%2C', ',');

function decode(text: string): string {
  try {
    return decodeURIComponent(text.replaceAll('+', ' '));
  } catch {
    return '';
  }
}
