// What tests of logs share: logs of a virtual rig, and the tab's options.
//
// Next door: what tests of both job tabs share (`jobs`).
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { example, folderOf } from './jobs';
import { expect } from './page';

export const { folder, told } = folderOf('log');

/** `hit.csv` of the virtual rig, once. */
export function rigLogs(): void {
  const hit = join(folder, 'hit.csv');
  if (existsSync(hit)) return;
  told('rig', example('virtual-rig'), '--out', 'rig');
  writeFileSync(hit, readFileSync(join(folder, 'rig', 'hit-1-fast.csv')));
}

/** A file for the command, and its text. */
export function written(name: string, text: string): string {
  writeFileSync(join(folder, name), text);
  return text;
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
