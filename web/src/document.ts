// A spec as the page holds it: the tables of a TOML file. To text and back to what the text's lines are about.
//
// Next door: who holds one (`state`), how one goes into an address (`address`).

export type Value = string | number | boolean | Value[];
export type Section = Record<string, Value>;
/** Tables by name; `condition` and `sensor` are lists of them. */
export type Spec = Record<string, Section | Section[]>;

/** Keys of a spec in one level: `spring.mass`, `condition.0.velocity`. */
export type Flat = Map<string, Value>;

export const section = (spec: Spec, name: string): Section => {
  const found = spec[name];
  return found && !Array.isArray(found) ? found : {};
};

export const sections = (spec: Spec, name: string): Section[] => {
  const found = spec[name];
  return Array.isArray(found) ? found : [];
};

export function flatten(spec: Spec): Flat {
  const flat: Flat = new Map();
  const add = (place: string, from: Section) =>
    Object.entries(from).forEach(([key, value]) => flat.set(`${place}.${key}`, value));
  for (const [name, tables] of Object.entries(spec)) {
    if (Array.isArray(tables)) tables.forEach((table, index) => add(`${name}.${index}`, table));
    else add(name, tables);
  }
  return flat;
}

export function unflatten(flat: Flat): Spec {
  const spec: Spec = {};
  const lists = new Map<string, Map<number, Section>>();
  for (const [place, value] of flat) {
    const parts = place.split('.');
    const [name, key] = [parts[0] ?? '', parts[parts.length - 1] ?? ''];
    if (parts.length === 3) {
      const list = lists.get(name) ?? new Map<number, Section>();
      lists.set(name, list);
      const index = Number(parts[1]);
      list.set(index, { ...list.get(index), [key]: value });
      spec[name] = [];
    } else {
      spec[name] = { ...section(spec, name), [key]: value };
    }
  }
  for (const [name, list] of lists) spec[name] = [...list].sort(([a], [b]) => a - b).map(([, table]) => table);
  return spec;
}

/** A copy with one key set, or taken out where there is no value. */
export function withValue(spec: Spec, place: string, value: Value | undefined): Spec {
  const copy = structuredClone(spec);
  const [name = '', second = '', third] = place.split('.');
  let table: Section | undefined;
  if (third === undefined) {
    table = section(copy, name);
    copy[name] = table;
  } else {
    table = sections(copy, name)[Number(second)];
  }
  const key = third ?? second;
  if (!table) return copy;
  if (value === undefined) delete table[key];
  else table[key] = value;
  return copy;
}

export function valueAt(spec: Spec, place: string): Value | undefined {
  const [name = '', second = '', third] = place.split('.');
  return third === undefined ? section(spec, name)[second] : sections(spec, name)[Number(second)]?.[third];
}

/** TOML, and for each of its lines (from 1) the place of the value that stands there. */
export function toToml(spec: Spec): { text: string; places: string[] } {
  const lines: string[] = [];
  const places: string[] = [''];
  const say = (line: string, place: string) => {
    lines.push(line);
    places.push(place);
  };
  const table = (heading: string, place: string, from: Section) => {
    if (lines.length > 0) say('', '');
    say(heading, place);
    for (const [key, value] of Object.entries(from)) say(`${key} = ${written(value)}`, `${place}.${key}`);
  };
  for (const [name, tables] of Object.entries(spec)) {
    if (Array.isArray(tables)) tables.forEach((one, index) => table(`[[${name}]]`, `${name}.${index}`, one));
    else table(`[${name}]`, name, tables);
  }
  return { text: lines.join('\n') + '\n', places };
}

function written(value: Value): string {
  if (Array.isArray(value)) return `[${value.map(written).join(', ')}]`;
  // A TOML string takes what a JSON string does; of characters that JSON writes plainly, only the delete key's may not stand there.
  if (typeof value === 'string') return JSON.stringify(value).replaceAll('\u007f', '\\u007f');
  if (typeof value === 'object')
    return `{ ${Object.entries(value as Section)
      .map(([key, one]) => `${key} = ${written(one)}`)
      .join(', ')} }`;
  return String(value);
}
