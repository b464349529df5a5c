// What tests of logs share: logs of a virtual rig, a drop, what is taken along, and how far two JSON values are apart.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { expect } from './page';

const page = new URL('..', import.meta.url).pathname;
export const folder = join(page, 'test-results', 'log');
const program = process.env['COILSENSE_COMMAND'] ?? '';

/** What the command prints, run where the logs are. */
export const told = (...args: string[]): string =>
  execFileSync(program, args, { encoding: 'utf8', cwd: folder, maxBuffer: 1 << 28 });

/** One line of complaint of the command. */
export function complained(...args: string[]): string {
  try {
    told(...args);
  } catch (error) {
    return String((error as { stderr: Buffer | string }).stderr);
  }
  throw new Error('the command did not complain');
}

/** `tap.csv` of the virtual rig, once. */
export function rigLogs(): void {
  mkdirSync(folder, { recursive: true });
  const tap = join(folder, 'tap.csv');
  if (existsSync(tap)) return;
  told('rig', join(page, '..', 'examples', 'virtual-rig.toml'), '--out', 'rig');
  writeFileSync(tap, readFileSync(join(folder, 'rig', 'tap-1-fast.csv')));
}

/** A file for the command, and its text. */
export function written(name: string, text: string): string {
  writeFileSync(join(folder, name), text);
  return text;
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

/** The text that a button downloads. */
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

/** Waits until nothing of the tab is under way. */
export const settled = (page: Page): Promise<void> =>
  expect(page.locator('#panel-log[aria-busy=false]')).toBeAttached({ timeout: 60_000 });

/** Unfolds a group of options and types into one. */
export async function type(page: Page, group: string, label: string, text: string): Promise<void> {
  const folded = page.locator('#panel-log details', { has: page.locator(`summary:text-is("${group}")`) });
  if ((await folded.getAttribute('open')) === null) await folded.locator('summary').click();
  const field = page.getByLabel(label, { exact: true });
  await field.fill(text);
  await field.press('Tab');
}
