// The command's other options on the page: the same numbers, wrong ones in red with the reason, all of them in the address.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { apart, drop, saved } from './jobs';
import { folder, rigLogs, settled, told, type, written } from './logs';
import { expect, test } from './page';

let hit = '';
test.beforeAll(() => {
  rigLogs();
  hit = readFileSync(join(folder, 'hit.csv'), 'utf8');
});

const identified = async (page: Page) => {
  await settled(page);
  return JSON.parse(await saved(page, 'Everything (JSON)')) as unknown;
};
/** Fits end where steps become small: 1e-8 of what is fitted. */
const SAME = 1e-7;

test('windings, mass, end 2, accuracies, tolerances and cleaning do what the command’s do', async ({ page }) => {
  await page.goto('./#S_T&@tab="log"');
  await drop(page, { 'hit.csv': hit });
  await expect(page.locator('#panel-log .verdict')).toBeVisible({ timeout: 60_000 });
  await type(page, 'The spring', 'Active windings', '52');
  await type(page, 'The spring', 'Mass of the coil', '65 g');
  await page.getByLabel('End 2 is').selectOption('held');
  await type(page, 'How exact', 'Force sensors, of reading', '0.5 %');
  await type(page, 'How exact', 'Position sensors', '0.2 %');
  await type(page, 'How exact', 'A force is trusted up to', '3 %');
  await type(page, 'How exact', 'A predicted f1 may be off by', '2 %');
  await type(page, 'What may be cleaned up', 'Fill gaps up to', '10 ms');
  await type(page, 'What may be cleaned up', 'Leave out before', '1 s');
  await type(page, 'What may be cleaned up', 'and after', '39 s');
  await settled(page);
  await expect(page.getByRole('region', { name: 'Verdict' })).toContainText('Within 3.00 % of its amplitude');
  const options =
    '--windings 52 --mass 65g --end2 held --accuracy-force 0.5% --accuracy-position 0.2% --tolerance 3% --prediction-tolerance 2% --fill-gaps 10ms --from 1s --to 39s';
  const there = JSON.parse(told('identify', 'hit.csv', ...options.split(' '), '--json')) as unknown;
  expect(apart(await identified(page), there)).toBeLessThan(SAME);
});

test('a wrong option is red with what is allowed, and the last good result stays', async ({ page }) => {
  await page.goto('./#S_T&@tab="log"');
  await drop(page, { 'hit.csv': hit });
  await expect(page.locator('#panel-log .verdict')).toBeVisible({ timeout: 60_000 });
  for (const [group, label, text, reason] of [
    ['The spring', 'Mass of the coil', '65 mm', /^must be a mass with its unit .* got "65 mm"$/],
    ['The spring', 'Active windings', 'many', /^must be a number from 1 to 1000000, got "many"$/],
    ['How exact', 'A force is trusted up to', '0 %', /^must be above 0 % and below 100 %, got "0 %"$/],
    ['What may be cleaned up', 'Resample to', '2 s', /^must be a frequency with its unit .* got "2 s"$/],
  ] as const) {
    await type(page, group, label, text);
    const field = page.getByLabel(label, { exact: true });
    await expect(field).toHaveAttribute('aria-invalid', 'true', { timeout: 30_000 });
    await expect(page.locator('#panel-log .wrong .error')).toHaveText(reason);
    await expect(page.locator('#panel-log .verdict')).toBeVisible();
    await type(page, group, label, '');
    await expect(field).not.toHaveAttribute('aria-invalid', 'true', { timeout: 30_000 });
  }
});

test('a mapping file beside the log says which column is what, and its faults are told by line', async ({ page }) => {
  const rows = hit.split('\n').filter((line) => line !== '' && !line.startsWith('#'));
  const text = ['Zeit;LC;Laser', ...rows.slice(1).map((row) => row.replaceAll(',', ';').replaceAll('.', ','))].join(
    '\n',
  );
  const columns =
    'time = "Zeit [s]"\nF_o = { column = "LC", gain = "2 N" }\nu1 = { column = "Laser [mm]", factor = -1 }';
  const mapping = `[log]\ndelimiter = ";"\ndecimal = ","\n\n[columns]\n${columns}`;
  written('german.csv', text);
  written('german.toml', mapping);
  await page.goto('./#S_T&@tab="log"');
  await drop(page, { 'german.toml': mapping, 'german.csv': text });
  await expect(page.locator('#panel-log .verdict')).toBeVisible({ timeout: 60_000 });
  const there = JSON.parse(told('identify', 'german.csv', '--mapping', 'german.toml', '--json')) as unknown;
  expect(apart(await identified(page), there)).toBeLessThan(SAME);
  await type(page, 'How the text is written', 'Mapping (TOML)', `${mapping}\nu2 =`);
  await expect(page.locator('#panel-log .wrong .error')).toHaveText(/^line \d+: not TOML/, { timeout: 30_000 });
  await type(page, 'How the text is written', 'Mapping (TOML)', mapping.replace('"Laser [mm]"', '"Lazer [mm]"'));
  await expect(page.locator('#panel-log .refusal').first()).toContainText('Lazer', { timeout: 30_000 });
});

test('delimiter and decimal sign can be told', async ({ page }) => {
  const text = 't [s];F_o [N]\n' + Array.from({ length: 3000 }, (_, row) => `${row},5;1,25`).join('\n');
  await page.goto('./#S_T&@tab="log"');
  await drop(page, { 'odd.csv': text });
  await settled(page);
  await page.getByText('How the text is written').click();
  await page.getByLabel('Columns are separated by').selectOption(';');
  await page.getByLabel('Decimal sign').selectOption('.');
  await expect(page.locator('#panel-log .refusal').first()).toContainText('no row of numbers', { timeout: 30_000 });
  await page.getByLabel('Decimal sign').selectOption(',');
  await expect(page.getByRole('img', { name: 'Forces over time' })).toBeVisible({ timeout: 30_000 });
  await page.getByLabel('Columns are separated by').selectOption(',');
  await expect(page.locator('#panel-log .refusal').first()).toContainText('no column is recognised as the time', {
    timeout: 30_000,
  });
});

test('choices stay in the address, and go with undo', async ({ page }) => {
  await page.goto('./#S_T&@tab="log"');
  await drop(page, { 'hit.csv': hit });
  await expect(page.locator('#panel-log .verdict')).toBeVisible({ timeout: 60_000 });
  await type(page, 'The spring', 'Active windings', '52');
  await page.getByLabel('u1 [mm] is', { exact: true }).selectOption('');
  await page.getByText('What may be cleaned up').click();
  await page.getByLabel('put rows into the order of their times').check();
  await settled(page);
  await expect.poll(() => decodeURIComponent(page.url())).toContain('"is+u1+[mm]":"-"');
  await page.reload();
  await drop(page, { 'hit.csv': hit });
  await expect(page.locator('#panel-log .verdict')).toBeVisible({ timeout: 60_000 });
  await expect(page.getByLabel('Active windings')).toHaveValue('52');
  await expect(page.getByLabel('put rows into the order of their times')).toBeChecked();
  await expect(page.getByLabel('u1 [mm] is', { exact: true })).toHaveValue('');
  const there = JSON.parse(
    told(
      'identify',
      'hit.csv',
      '--windings',
      '52',
      '--sort',
      '--column',
      'time=#1 [s]',
      '--column',
      'F_o=#2 [N]',
      '--json',
    ),
  ) as { first_frequency_hz: unknown };
  const here = (await identified(page)) as { first_frequency_hz: unknown; stiffness_n_per_m: unknown };
  expect(apart(here.first_frequency_hz, there.first_frequency_hz)).toBeLessThan(SAME);
  expect(here.stiffness_n_per_m).toBeNull();
  await type(page, 'The spring', 'Active windings', '53');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByLabel('Active windings')).toHaveValue('52');
});
