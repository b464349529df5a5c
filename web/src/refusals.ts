// What the engine refuses of a spec, in the page's words, with ways out; and the spec without it. Loaded with the first refusal.
//
// Next door: who asks the engine (`compute`), the field that it is about (`inputs/panels`), the fields' words (`fields`).

import type { Refusal } from './compute';
import { sections, valueAt, withValue, type Spec } from './document';
import { make, reveal } from './dom';
import { BY_GEOMETRY, BY_VALUES, CONDITION, ENDS, GOAL, RADII, SENSOR, SHAPE, TIMING } from './fields';
import { preset } from './presets';
import type { State } from './state';
import type { Store } from './store';

/** What the page calls a key. */
const LABELS: Readonly<Record<string, string>> = Object.fromEntries(
  [
    ...[BY_VALUES, SHAPE, RADII, BY_GEOMETRY, ENDS, TIMING, SENSOR, GOAL],
    ...Object.values(CONDITION).flatMap(({ first, more }) => [first, more]),
  ].flatMap((fields) => fields.map(({ key, label }) => [key, `“${label}”`])),
);

/** A word of the spec as the page has it. */
const label = (key: string): string => LABELS[key] ?? key.replaceAll('_', ' ');

const plain = (text: string): string =>
  text
    .replace(/; allowed: .*/s, '')
    .replace(/ in \[+(\w+)\]+/g, ' of the $1')
    .replace(/\b[a-z]+(_[a-z\d]+)+\b/g, label);

/** What the engine says, of the text that it was asked about. */
export function refusalOf(error: string, text: string, places: readonly string[]): Refusal {
  if (/^condition \d+, damping/.test(error))
    return { place: '', text: 'There is nothing to compute: choose something under “What happens”.' };
  const [, line = '', reason = error.replace(/^spec: /, '')] = /^spec:(\d+): (.*)$/s.exec(error) ?? [];
  const place = places[Number(line)] ?? '';
  const said = `${text.split('\n')[Number(line) - 1] ?? ''}: `;
  const [, lacked, what = ''] = /^\[+\w+\]+.* lacks the key "(\w+)": (.*)$/s.exec(reason) ?? [];
  if (lacked) return { place: `${place}.${lacked}`, text: `is missing: ${what}` };
  if (/ is not on this page$/.test(reason))
    return { place, text: 'this file is not here: drop it on the page, together with the spec that names it' };
  const isUnknown = /^unknown (key|table) /.test(reason);
  return { place, text: plain(reason.startsWith(said) ? reason.slice(said.length) : reason), isUnknown };
}

/** `bandwidth of the sensor “load cell”`, for a place that has no field in sight. */
function named(spec: Spec, place: string): string {
  const [table = '', second = '', third] = place.split('.');
  if (third === undefined) return second ? `${label(second)} of the ${table}` : table;
  const name = sections(spec, table)[Number(second)]?.['name'] ?? Number(second) + 1;
  return `${label(third)} of the ${table} “${name}”`;
}

/** The state with the preset's own value at a place, or none; all of the preset where that is no place of one value. */
export function mended(state: State, place: string): State {
  const { spec: usual } = preset(state.preset);
  const [table = '', second, third] = place.split('.');
  const isValue = second !== undefined && (third !== undefined || !Array.isArray(state.spec[table]));
  if (isValue) return { ...state, spec: withValue(state.spec, place, valueAt(usual, place)) };
  return { ...state, spec: structuredClone(usual), view: { ...state.view, condition: 0, damping: 0 } };
}

/** The spec without what no spec has: a key, or a whole table. */
export function without(spec: Spec, place: string): Spec {
  if (place.includes('.')) return withValue(spec, place, undefined);
  const { [place]: _, ...rest } = spec;
  return rest;
}

/** Whether a condition of the spec is meant that is not the one that is shown: its name, and which it is. */
function elsewhere({ spec, view }: State, place: string): { name: string; condition: number } | null {
  const [table, number] = place.split('.');
  const condition = Number(number);
  if (table !== 'condition' || condition === view.condition || !sections(spec, table)[condition]) return null;
  return { name: String(sections(spec, table)[condition]?.['name'] ?? condition + 1), condition };
}

/** Says it above the fields. `field` is that of the refusal, where there is one; `isShown`: whether something is shown. */
export function showRefusal(
  host: HTMLElement,
  store: Store,
  refusal: Refusal,
  field: HTMLElement | null,
  isShown: boolean,
): void {
  host.hidden = false;
  host.replaceChildren();
  const { place, text } = refusal;
  const { state } = store;
  const words = [
    field ? '' : place ? `${named(state.spec, place)}: ${text}.` : text,
    refusal.stands
      ? 'What is shown is without it.'
      : isShown
        ? 'What is shown is the last state that could be computed.'
        : '',
  ];
  const button = (label: string, act: () => void) =>
    make('button', { type: 'button', class: 'plain', onclick: act }, label);
  const other = elsewhere(state, place);
  const away = () => {
    const { spec, view } = mended(state, place);
    store.setSpec(spec, '', view);
  };
  host.append(words.filter(Boolean).join(' '), ' ');
  if (field) host.append(button('Show the field', () => reveal(field)));
  else if (other)
    host.append(
      button(`Go to “${other.name}”`, () => store.setView({ condition: other.condition, times: null }, true)),
    );
  if (place && !field) host.append(' ', button('Take the usual value', away));
}
