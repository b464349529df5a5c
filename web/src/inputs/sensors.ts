// The sensors of a spec: the fields of each, one more, one less.
//
// Next door: one field (`control`), the groups (`panels`), the classes there are (`shelf`).

import { sections } from '../document';
import { make } from '../dom';
import { SENSOR, type Field } from '../fields';
import type { Store } from '../store';

type Sensors = ReturnType<typeof sections>;

/** What stands in the group of sensors; `at` gives a table's fields. */
export function sensorFields(store: Store, at: (place: string) => (field: Field) => HTMLElement): HTMLElement[] {
  const all = () => sections(store.state.spec, 'sensor');
  const put = (sensor: Sensors) => store.setSpec({ ...structuredClone(store.state.spec), sensor });
  const button = (label: string, act: () => void) =>
    make('button', { type: 'button', class: 'plain', onclick: act }, label);
  const one = (table: Sensors[number], index: number) =>
    make(
      'details',
      { id: `sensor-${index}` },
      make('summary', {}, String(table['name'] ?? table['class'] ?? table['kind'] ?? 'sensor')),
      ...SENSOR.filter(
        (field) => field.key !== 'end' || table['end'] !== undefined || table['kind'] === 'load-cell',
      ).map(at(`sensor.${index}`)),
      button('Remove this sensor', () => put(all().filter((_, other) => other !== index))),
    );
  const add = () =>
    put([...all(), { name: nameBeside(all()), kind: 'load-cell', end: 2, bandwidth: '1 kHz', sample_rate: '2.5 kHz' }]);
  return [...all().map(one), button('Add a sensor', add)];
}

/** A name that no other sensor has. */
function nameBeside(all: Sensors): string {
  const names = new Set(all.map(({ name }) => name));
  let number = all.length + 1;
  while (names.has(`sensor ${number}`)) number++;
  return `sensor ${number}`;
}
