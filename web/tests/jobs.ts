// What tests of the tabs Log and Mitigate share: the command's words, files that the page saves, a log that is dropped, how far two answers are apart.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { expect } from './page';

const page = new URL('..', import.meta.url).pathname;
export const example = (name: string): string => join(page, '..', 'examples', `${name}.toml`);

/** A folder of test results, in which the command runs. */
export function folderOf(name: string): { folder: string; told: (...args: string[]) => string } {
  const folder = join(page, 'test-results', name);
  mkdirSync(folder, { recursive: true });
  const program = process.env['COILSENSE_COMMAND'] ?? '';
  const told = (...args: string[]) =>
    execFileSync(program, args, { encoding: 'utf8', cwd: folder, maxBuffer: 1 << 28 });
  return { folder, told };
}

/** The largest relative difference of two JSON values of one shape; all but numbers must be the same. */
export function apart(here: unknown, there: unknown, place = ''): number {
  if (typeof here === 'number' && typeof there === 'number')
    return here === there ? 0 : Math.abs(here - there) / Math.max(Math.abs(there), 1e-9);
  if (here !== null && there !== null && typeof here === 'object' && typeof there === 'object') {
    const names = Object.keys(here);
    // Tens of thousands of them: only what differs is handed to `expect`.
    if (names.join() !== Object.keys(there).join()) expect(names, place).toEqual(Object.keys(there));
    const each = names.map((name) =>
      apart((here as Record<string, unknown>)[name], (there as Record<string, unknown>)[name], `${place}/${name}`),
    );
    return each.reduce((most, one) => Math.max(most, one), 0);
  }
  if (here !== there) expect(here, place).toEqual(there);
  return 0;
}

/** The text of the file that a button saves. */
export async function saved(page: Page, button: string): Promise<string> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: button }).click(),
  ]);
  return readFileSync((await download.path()) ?? '', 'utf8');
}

/** Drops texts by name. */
export async function drop(page: Page, files: Record<string, string>, where = '.drop >> nth=0'): Promise<void> {
  const data = await page.evaluateHandle((files) => {
    const data = new DataTransfer();
    for (const [name, content] of Object.entries(files)) data.items.add(new File([content], name));
    return data;
  }, files);
  await page.dispatchEvent(where, 'drop', { dataTransfer: data });
}
