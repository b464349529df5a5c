// The springs that the page begins with: the specs of `examples/`, the same files that the command's examples are.
//
// Next door: what a spec is (`document`).

import car from '../../examples/car-suspension.toml';
import cam from '../../examples/cam-6000rpm.csv?url';
import parallelAnkle from '../../examples/parallel-ankle.toml';
import road from '../../examples/road-c-20mps.csv?url';
import ankle from '../../examples/sea-ankle.toml';
import valve from '../../examples/valve-spring.toml';
import type { Spec } from './document';

export interface Preset {
  /** As it stands in an address. */
  id: string;
  label: string;
  /** The file in `examples/`. */
  example: string;
  spec: Spec;
  /** Files that the spec names, where they lie, and how long each is. */
  files: Record<string, { address: string; bytes: number }>;
}

export const PRESETS: readonly Preset[] = [
  { id: 'S_T', label: 'S_T – robot ankle', example: 'sea-ankle', spec: ankle, files: {} },
  { id: 'S_A', label: 'S_A – prosthesis', example: 'parallel-ankle', spec: parallelAnkle, files: {} },
  {
    id: 'valve',
    label: 'Valve, 6000 rpm',
    example: 'valve-spring',
    spec: valve,
    files: { 'cam-6000rpm.csv': { address: cam, bytes: LENGTHS.cam } },
  },
  {
    id: 'suspension',
    label: 'Car suspension',
    example: 'car-suspension',
    spec: car,
    files: { 'road-c-20mps.csv': { address: road, bytes: LENGTHS.road } },
  },
];

export const preset = (id: string): Preset => PRESETS.find((one) => one.id === id) ?? (PRESETS[0] as Preset);
