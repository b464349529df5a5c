// The engine's catalogue in the fields: names of materials and of sensor classes to choose from, and what the chosen one brings along.
//
// Next door: the fields (`panels`, `control`), the tables (`coilsense-web`, `catalogue`).

import type { Catalogue, Facts } from '../answer';
import type { Compute } from '../compute';
import { section, sections } from '../document';
import type { State } from '../state';
import type { Control } from './control';

/** Keys of a class that say which it is, not what it measures. */
const NAMES = ['name', 'class', 'kind'];

export class Shelf {
  private catalogue: Catalogue | null = null;
  private asked = false;
  /** Sensors as the engine reads them, of the last exact case. */
  private kinds: string[] = [];

  constructor(
    private readonly compute: Compute,
    facts: Facts | null,
  ) {
    this.know(facts);
  }

  private know(facts: Facts | null): void {
    if (facts && 'sensors' in facts) this.kinds = (facts.sensors as { kind: string }[]).map(({ kind }) => kind);
  }

  /** Fetches the catalogue, once: with the first group of fields that is opened. */
  load(done: () => void): void {
    if (this.asked) return;
    this.asked = true;
    void this.compute.alone({ kind: 'catalogue' }).then((reply) => {
      if (!('text' in reply)) return;
      this.catalogue = JSON.parse(reply.text) as Catalogue;
      done();
    });
  }

  /** Fills lists, hints and what holds where nothing is typed. */
  fill(state: State, controls: readonly Control[], facts: Facts | null): void {
    this.know(facts);
    const at = new Map(controls.map((control) => [control.place, control]));
    sections(state.spec, 'sensor').forEach((table, index) => {
      const kind = String(table['kind'] ?? this.kinds[index] ?? 'load-cell');
      at.get(`sensor.${index}.kind`)?.usually(kind);
      this.sensor(index, kind, String(table['class'] ?? ''), at);
    });
    const material = at.get('spring.material');
    if (!this.catalogue || !material) return;
    const { usual, materials } = this.catalogue;
    material.offer(
      materials.map(({ name }) => name ?? ''),
      `${usual} (usual)`,
    );
    const chosen = String(section(state.spec, 'spring')['material'] ?? usual);
    material.tell(words(materials.find(({ name }) => name === chosen) ?? {}));
  }

  private sensor(index: number, kind: string, chosen: string, at: Map<string, Control>): void {
    const list = at.get(`sensor.${index}.class`);
    if (!this.catalogue || !list) return;
    const fitting = this.catalogue.sensors.filter((one) => one['kind'] === kind);
    list.offer(
      fitting.map((one) => one['class'] ?? ''),
      'no device of the catalogue',
    );
    const row = this.catalogue.sensors.find((one) => one['class'] === chosen) ?? {};
    list.tell(chosen ? words(row) : '');
    for (const [place, control] of at)
      if (place.startsWith(`sensor.${index}.`) && control !== list)
        control.tell(control.ownHint, row[place.split('.')[2] ?? ''] ?? '');
  }
}

/** `sample rate 80 Hz · noise 0.00044 %` */
const words = (row: Record<string, string>): string =>
  Object.entries(row)
    .filter(([key]) => !NAMES.includes(key))
    .map(([key, value]) => `${key.replaceAll('_', ' ').replace('youngs', 'Young’s')} ${value}`)
    .join(' · ');
