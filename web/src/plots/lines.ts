// Which lines there are: the four forces, and what each sensor reads, which is drawn where somebody asks for it.
//
// Next door: their looks (`looks`), the chart (`forces`), the words beside it (`readout`).

import type { ExactFacts, Facts } from '../answer';
import { FORCE_NAMES } from './looks';

export interface Line {
  /** Its series in an answer. */
  series: string;
  /** The symbol of a force, the name of a sensor. */
  name: string;
  /** Among lines of its sort. */
  number: number;
}

export const FORCE_LINES: readonly Line[] = FORCE_NAMES.map((name, number) => ({
  series: name,
  name,
  number,
}));

/** The readings that are asked for by name, of an exact case or the last one: a preview knows no sensors. */
export function readings(facts: Facts | ExactFacts | null, wanted: readonly string[]): Line[] {
  if (!facts || !('sensors' in facts)) return [];
  return facts.sensors.flatMap(({ name }, number) =>
    wanted.includes(name) ? [{ series: `reading ${number}`, name, number }] : [],
  );
}
