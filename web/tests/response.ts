// The two ends over frequency: opened on the page, and computed from the matrices that the command exports.
import { readFileSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, type Locator, type Page } from '@playwright/test';
import type { PointFacts } from '../src/answer';
import { command, EXAMPLES } from './command';

/** The part once all of it is there. */
export async function openResponse(page: Page): Promise<Locator> {
  const part = page.locator('.two-ends');
  if ((await part.locator('details').getAttribute('open')) === null) await part.locator('summary').click();
  await settled(page);
  return part;
}

/** Waits until what is shown is of the state. */
export async function settled(page: Page): Promise<void> {
  await expect(page.locator('.over-frequency')).toHaveAttribute('aria-busy', 'false', { timeout: 30_000 });
}

/** What the part shows, with all digits, once it is of a frequency. */
export async function pointAt(page: Page, frequency: number): Promise<PointFacts> {
  const shown = async () => JSON.parse((await page.locator('.over-frequency').getAttribute('data-point')) ?? '{}');
  await expect.poll(async () => ((await shown()) as PointFacts).frequency).toBe(frequency);
  return (await shown()) as PointFacts;
}

export async function go(page: Page, frequency: number): Promise<PointFacts> {
  const field = page.locator('.two-ends').getByRole('textbox', { name: 'Frequency' });
  await field.fill(`${frequency} Hz`);
  await field.press('Enter');
  return pointAt(page, frequency);
}

type Complex = [number, number];
const times = ([a, b]: Complex, [c, d]: Complex): Complex => [a * c - b * d, a * d + b * c];
const less = ([a, b]: Complex, [c, d]: Complex): Complex => [a - c, b - d];
export function divided([a, b]: Complex, [c, d]: Complex): Complex {
  const square = c * c + d * d;
  return [(a * c + b * d) / square, (b * c - a * d) / square];
}
export const size = ([a, b]: Complex): number => Math.hypot(a, b);
export const phase = ([a, b]: Complex): number => Math.atan2(b, a);

interface Exported {
  available_modes: number;
  kept_modes: number;
  continuous: { a: number[][]; b: number[][]; c: number[][]; d: number[][] };
}

/** `coilsense export --as state-space` of an example with one of its dampings: a plant of every mode. */
export function exported(preset: keyof typeof EXAMPLES, ratio: number | null): Exported {
  const folder = join(new URL('..', import.meta.url).pathname, 'test-results', 'export');
  mkdirSync(folder, { recursive: true });
  const file = join(folder, `${preset}-${ratio}.json`);
  const spec = join(new URL('../../examples/', import.meta.url).pathname, `${EXAMPLES[preset]}.toml`);
  const damping = ratio === null ? [] : ['--damping-ratio', String(ratio)];
  command('export', spec, '--as', 'state-space', '--out', file, '--overwrite', ...damping);
  return JSON.parse(readFileSync(file, 'utf8')) as Exported;
}

/** F_i, F_o and F_x over the first input at a frequency [Hz]: C (jω − A)⁻¹ B + D by elimination. */
export function forcesOf({ continuous: { a, b, c, d } }: Exported, frequency: number): Complex[] {
  const omega = 2 * Math.PI * frequency;
  const rows: Complex[][] = a.map((row, at) => [
    ...row.map((value, column): Complex => [-value, at === column ? omega : 0]),
    [b[at]?.[0] ?? 0, 0],
  ]);
  const state = eliminated(rows);
  return [0, 1, 2].map((output) =>
    (c[output] ?? []).reduce<Complex>(
      ([re, im], weight, at) => [re + weight * (state[at]?.[0] ?? 0), im + weight * (state[at]?.[1] ?? 0)],
      [d[output]?.[0] ?? 0, 0],
    ),
  );
}

function eliminated(rows: Complex[][]): Complex[] {
  const count = rows.length;
  const at = (row: number, column: number): Complex => rows[row]?.[column] ?? [0, 0];
  for (let pivot = 0; pivot < count; pivot++) {
    let best = pivot;
    for (let row = pivot; row < count; row++) if (size(at(row, pivot)) > size(at(best, pivot))) best = row;
    [rows[pivot], rows[best]] = [rows[best] ?? [], rows[pivot] ?? []];
    for (let row = pivot + 1; row < count; row++) {
      const factor = divided(at(row, pivot), at(pivot, pivot));
      if (size(factor) === 0) continue;
      const target = rows[row] ?? [];
      for (let column = pivot; column <= count; column++)
        target[column] = less(at(row, column), times(factor, at(pivot, column)));
    }
  }
  const found: Complex[] = Array.from({ length: count }, () => [0, 0]);
  for (let row = count - 1; row >= 0; row--) {
    let sum = at(row, count);
    for (let column = row + 1; column < count; column++)
      sum = less(sum, times(at(row, column), found[column] ?? [0, 0]));
    found[row] = divided(sum, at(row, row));
  }
  return found;
}
