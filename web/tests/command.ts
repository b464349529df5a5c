// What the command says of the presets, for the page to be held against: run once, before the tests.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { ModesAt } from '../src/answer';

export const EXAMPLES = {
  S_T: 'sea-ankle',
  S_A: 'parallel-ankle',
  valve: 'valve-spring',
  suspension: 'car-suspension',
} as const;

const page = new URL('..', import.meta.url).pathname;
// Not among the results of tests, which each run of theirs throws away.
const out = join(page, '..', 'target', 'of-command');
const exampleFile = (example: string): string => join(page, '..', 'examples', `${example}.toml`);

/** Runs the command; what it prints, and its own words where it fails. */
export function command(...args: string[]): string {
  const program = process.env['COILSENSE_COMMAND'];
  if (!program) throw new Error('COILSENSE_COMMAND must be the path of the command coilsense');
  return execFileSync(program, args, { stdio: ['ignore', 'pipe', 'inherit'], encoding: 'utf8', maxBuffer: 1e8 });
}

interface Deviation {
  rmsd_n: number;
  maximum_n: number;
  maximum_absolute_n: number;
  mean_n: number;
}

export interface Results {
  nominal_force_n: number;
  spring: { modes_at: ModesAt[] };
  cases: {
    condition: string;
    damping: string;
    forces: Record<string, Deviation>;
    sensors: { sensor: string; deviation: Deviation }[];
    shortest_length_m: number;
    longest_length_m: number;
    smallest_pitch_m: number | null;
    first_contact_s: number | null;
  }[];
}

export const results = (folder: string): Results =>
  JSON.parse(readFileSync(join(folder, 'results.json'), 'utf8')) as Results;
export const resultsOf = (example: string): Results => results(join(out, example));
export const reportOf = (example: string): string => join(out, example, 'report.html');

/** `coilsense analyze` of every preset's example, where this very command has not been asked that. */
export default function setup(): void {
  mkdirSync(out, { recursive: true });
  for (const example of Object.values(EXAMPLES)) {
    const [folder, stamp] = [join(out, example), join(out, `${example}.stamp`)];
    const asked = [process.env['COILSENSE_COMMAND'] ?? '', exampleFile(example)]
      .map((file) => `${file} ${existsSync(file) ? statSync(file).mtimeMs : ''}`)
      .join('\n');
    if (existsSync(stamp) && readFileSync(stamp, 'utf8') === asked) continue;
    command('analyze', exampleFile(example), '--out', folder, '--date', '2026-11-22');
    writeFileSync(stamp, asked);
  }
}
