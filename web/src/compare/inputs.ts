// Which inputs of two states differ, in the words of the page's fields. Conditions and sensors are matched by their names; of those that are left
// two at one place are one that was renamed.
//
// Next door: the fields (`fields`), the table that shows it (`card`).

import { section, sections, type Section, type Spec, type Value } from '../document';
import * as fields from '../fields';
import type { Field } from '../fields';
import { PRESETS } from '../presets';
import type { State } from '../state';
import { conditionOf } from './case';

export interface Difference {
  label: string;
  kept: string;
  now: string;
}

const NONE = 'not given';
const NAME = 'Name of the spring';

const FIELDS: Record<string, readonly Field[]> = {
  spring: [
    ...fields.BY_VALUES,
    ...fields.SHAPE,
    ...fields.RADII,
    ...fields.BY_GEOMETRY,
    ...fields.ENDS,
    ...fields.OFF_LENGTH,
    // Those of both ways to give a spring are the same in their words.
    ...fields.OFF_VALUES.map((field) => ({ ...field, label: `Tolerance of ${field.label}` })),
    ...fields.OFF_GEOMETRY.map((field) => ({ ...field, label: `Tolerance of ${field.label}` })),
    { key: 'name', label: NAME },
    { key: 'model', label: 'Model' },
    { key: 'masses_per_winding', label: 'Masses per winding' },
  ],
  mount: [
    {
      key: 'end2',
      label: 'End 2',
      words: ['held'],
      names: { force: 'under a constant force', mass: 'tied to a mass' },
    },
    { key: 'end_mass', label: 'Mass at end 2' },
    { key: 'damping_ratio', label: 'Damping ζ' },
  ],
  contact: [
    { key: 'windings', label: 'Windings that meet', names: { hard: 'are hard', elastic: 'are elastic' } },
    { key: 'restitution', label: 'Restitution e' },
    { key: 'damping_ratio', label: 'Contact damping ζ_c' },
    { key: 'ends', label: 'Ends meet their seats' },
  ],
  condition: [
    { key: 'kind', label: 'What it is' },
    ...Object.values(fields.CONDITION).flatMap(({ first, more }) => [...first, ...more]),
    ...fields.TIMING,
  ],
  sensor: fields.SENSOR,
  goal: fields.GOAL.map((field) => ({ ...field, label: field.key === 'error' ? field.label : `Goal: ${field.label}` })),
  uncertainty: fields.WARMTH,
};

function fieldOf(table: string, key: string): Field {
  return FIELDS[table]?.find((field) => field.key === key) ?? { key, label: `${table}.${key}` };
}

/** A value as the page shows it. */
function told(value: Value | undefined, { words, names }: Field): string {
  if (value === undefined) return words?.[0] ? (names?.[words[0]] ?? words[0]) : NONE;
  if (Array.isArray(value)) return value.map((one) => told(one, { key: '', label: '' })).join(' to ');
  if (typeof value === 'object') return JSON.stringify(value);
  return names?.[String(value)] ?? String(value);
}

/** Of two tables of one name; `before` stands before each label. */
function inTables(table: string, kept: Section, now: Section, before = ''): Difference[] {
  const keys = [...new Set([...Object.keys(kept), ...Object.keys(now)])];
  return keys.flatMap((key) => {
    const field = fieldOf(table, key);
    const [one, other] = [told(kept[key], field), told(now[key], field)];
    return one === other ? [] : [{ label: before + field.label, kept: one, now: other }];
  });
}

const nameOf = (one: Section): string => String(one['name'] ?? one['kind'] ?? '');

/** Of two lists: what has the same name, then what is left at the same place; null where one has none such. */
export function pairs(kept: Section[], now: Section[]): [Section | null, Section | null][] {
  const names = new Set(kept.map(nameOf));
  const left = (all: Section[], others: Set<string>) => all.map((one) => (others.has(nameOf(one)) ? null : one));
  const [gone, come] = [left(kept, new Set(now.map(nameOf))), left(now, names)];
  const known = kept.flatMap((one): [Section | null, Section | null][] => {
    const other = now.find((two) => nameOf(two) === nameOf(one));
    return other ? [[one, other]] : [];
  });
  const rest = Array.from(
    { length: Math.max(gone.length, come.length) },
    (_, place): [Section | null, Section | null] => [gone[place] ?? null, come[place] ?? null],
  );
  return [...known, ...rest.filter(([one, other]) => one || other)];
}

function inLists(table: string, word: string, kept: Spec, now: Spec): Difference[] {
  return pairs(sections(kept, table), sections(now, table)).flatMap(([one, other]) => {
    if (one && other) return inTables(table, one, other, `“${nameOf(one)}”: `);
    const [is, not] = ['there', 'not there'];
    return [{ label: `${word} “${nameOf(one ?? other ?? {})}”`, kept: one ? is : not, now: other ? is : not }];
  });
}

/** What differs, the telling things first: what is shown, the spring, what is done to it, sensors, the goal. */
export function differences(kept: State, now: State): Difference[] {
  const label = (id: string) => PRESETS.find((one) => one.id === id)?.label ?? id;
  const shown: Difference[] = [
    { label: 'Spring', kept: label(kept.preset), now: label(now.preset) },
    { label: 'What happens', kept: conditionOf(kept), now: conditionOf(now) },
  ];
  const lists: Record<string, string> = { condition: 'Condition', sensor: 'Sensor' };
  const all = new Set(['spring', 'mount', 'contact', ...Object.keys(kept.spec), ...Object.keys(now.spec)]);
  const tables = [...all].flatMap((table) => {
    const word = lists[table];
    if (word) return inLists(table, word, kept.spec, now.spec);
    const has = (spec: Spec) =>
      table === 'contact' && !spec[table] ? { windings: 'pass through' } : section(spec, table);
    const found = inTables(table, has(kept.spec), has(now.spec));
    // The name of another spring is said already.
    return found.filter(({ label }) => label !== NAME || kept.preset === now.preset);
  });
  return [...shown.filter((one) => one.kept !== one.now), ...tables];
}
