// The lines of the modes against length, by way of the ends, mode and kind.
//
// Next door: their names in an answer (`coilsense-web`, `modes`), who draws them (`chart`).

import type { Answer, Kind, LinesFacts } from '../answer';

/** Frequencies over lengths [Hz], null where there is none: of a mode, while it is of a kind. */
export interface Curve {
  number: number;
  kind: Kind;
  values: (number | null)[];
}

/** From the one way of the ends to the other. */
export interface Band {
  kind: Kind;
  lower: (number | null)[];
  upper: (number | null)[];
}

export interface Lines {
  facts: LinesFacts;
  /** [m], rising. */
  lengths: number[];
  /** The ends as they are held, and as loose as they may be where that lies between two ways. */
  ways: { ends: string; buckles: boolean[]; curves: Curve[] }[];
  bands: Band[];
}

export function lines({ facts, series }: Answer<LinesFacts>): Lines {
  const values = (name: string) => Array.from(series[name] ?? []);
  const gaps = (name: string) => values(name).map((value) => (Number.isFinite(value) ? value : null));
  const names = Object.keys(series).map((name) => ({ name, words: name.split(' ') }));
  const curves = (way: number) =>
    names
      .filter(({ words }) => words[0] === 'curve' && words[1] === String(way))
      .map(({ name, words }) => ({ number: Number(words[2]), kind: words[3] as Kind, values: gaps(name) }));
  return {
    facts,
    lengths: values('length'),
    ways: facts.ends.map((ends, way) => ({
      ends,
      buckles: values(`buckles ${way}`).map(Boolean),
      curves: curves(way),
    })),
    bands: names
      .filter(({ words }) => words[0] === 'lower')
      .map(({ name, words }) => ({
        kind: words[1] as Kind,
        lower: gaps(name),
        upper: gaps(name.replace('lower', 'upper')),
      })),
  };
}
