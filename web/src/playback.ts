// How fast a recorded condition is played: a share of the speed of its file.
//
// Next door: who moves it (`fields`, `speeds/part`), what times of a condition are (`compute`).

import { sections, type Spec } from './document';
import { read, shown } from './inputs/quantity';

export const KEY = 'playback_speed';

/** As the spec has it; 1 where it says nothing, or what cannot be. */
export const played = (spec: Spec, condition: number): number => {
  const value = read(shown(sections(spec, 'condition')[condition]?.[KEY]));
  return value?.unit === '%' && value.number > 0 ? value.number / 100 : 1;
};
