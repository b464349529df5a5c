// What tests of jobs share: the command's words, files that the page saves, a log that is dropped, how far two answers are apart.
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
    execFileSync(program, args, {
      encoding: 'utf8',
      cwd: folder,
      maxBuffer: 1 << 28,
      stdio: ['ignore', 'pipe', 'inherit'],
    });
  return { folder, told };
}

/** The largest relative difference of two JSON values of one shape; texts must be the same. */
export function apart(here: unknown, there: unknown, place = ''): number {
  if (typeof here === 'number' && typeof there === 'number')
    return here === there ? 0 : Math.abs(here - there) / Math.max(Math.abs(there), 1e-9);
  if (here !== null && there !== null && typeof here === 'object' && typeof there === 'object') {
    expect(Object.keys(here), place).toEqual(Object.keys(there));
    const each = Object.entries(here).map(([key, value]) =>
      apart(value, (there as Record<string, unknown>)[key], `${place}/${key}`),
    );
    return Math.max(0, ...each);
  }
  expect(here, place).toEqual(there);
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

/** Drops a file where the tab takes one. */
export async function drop(page: Page, panel: string, name: string, content: string): Promise<void> {
  const data = await page.evaluateHandle(
    ([name, content]) => {
      const data = new DataTransfer();
      data.items.add(new File([content ?? ''], name ?? ''));
      return data;
    },
    [name, content],
  );
  await page.dispatchEvent(`${panel} .drop`, 'drop', { dataTransfer: data });
}
