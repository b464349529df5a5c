// Logs that open at once: titles in other languages, pairs of files, what the page and the command write themselves.
//
// Next door: large and wrong files (`log-large`), options that are told (`log-options`).
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { drop, example, saved } from './jobs';
import { folder, rigLogs, settled, told } from './logs';
import { expect, test } from './page';

test.beforeAll(rigLogs);
test.beforeEach(({ page }) => page.goto('./#S_T&@tab="log"'));

const refusal = '#panel-log .asked > .refusal';

test('German titles are taken by unit and word, and a guess says that it is one', async ({ page }) => {
  const rows = readFileSync(join(folder, 'hit.csv'), 'utf8')
    .split('\n')
    .filter((line) => line && !line.startsWith('#'))
    .slice(1)
    .map((row) => row.split(','))
    .map(([t, force, u1]) => `${[t, u1, force].join(';').replaceAll('.', ',')}`);
  await drop(page, { 'deutsch.csv': ['Zeit/s;Weg oben (mm);Kraft unten [N]', ...rows].join('\n') });
  await expect(page.locator('#panel-log .verdict')).toContainText('spring: 13', { timeout: 60_000 });
  await expect(page.locator('#panel-log .guess')).toHaveText(
    'A guess by unit and title: Weg oben (mm) is u1, Kraft unten [N] is Fo. Correct it here if it is wrong.',
  );
  await expect(page.getByLabel('Weg oben (mm) is', { exact: true })).toHaveValue('u1');
  await expect(page.getByLabel('Kraft unten [N] is', { exact: true })).toHaveValue('F_o');
  // A length is no force, whatever its title says.
  await drop(page, { 'verkehrt.csv': 't [s];Kraft [mm];Weg [N]\n0,1;1,5;2\n0,2;1,6;3\n0,3;1,5;2\n' });
  await expect(page.getByLabel('Kraft [mm] is', { exact: true })).toHaveValue('u1', { timeout: 30_000 });
  await expect(page.getByLabel('Weg [N] is', { exact: true })).toHaveValue('F_o');
});

test('the pairs of the virtual rig open together, on one clock', async ({ page }) => {
  const of = (name: string) => readFileSync(join(folder, 'rig', name), 'utf8');
  // The slow one first: which is which does not hang on the order.
  await drop(page, { 'hit-1-slow.csv': of('hit-1-slow.csv'), 'hit-1-fast.csv': of('hit-1-fast.csv') });
  await expect(page.getByRole('region', { name: 'The second device' })).toContainText('0 ms were added to its times', {
    timeout: 60_000,
  });
  await expect(page.locator('#panel-log .verdict')).toBeVisible();
  await expect(page.locator(refusal)).toBeHidden();
  await settled(page);
  // Two that did not begin together have no such clock.
  await drop(page, { 'hit-1-fast.csv': of('hit-1-fast.csv'), 'hit-2-slow.csv': of('hit-2-slow.csv') });
  await expect(page.getByText('no channel is in both')).toBeVisible({ timeout: 60_000 });
  await expect(page.getByLabel('Its clock', { exact: true })).toHaveValue('');
});

/** A run in the layout of the measured ones: numbered rows, displacement, ten pairs of resistance and inductance. */
const run = (scale: number) =>
  Array.from({ length: 8 }, (_, row) => {
    const inductance = (scale * 6e-7) / (0.1 + 0.006 * row) + 2e-7;
    const pairs = Array.from({ length: 10 }, (_, n) => `; ${0.3 + 1e-5 * n}; ${inductance * (1 + 1e-4 * (n - 4.5))}`);
    return `${row + 1}; 10; 0.5; ${6 * row}${pairs.join('')}`;
  }).join('\n');

test('runs in the layout of the measured ones are known, and shown one at a time', async ({ page }) => {
  await drop(page, { 'first.csv': run(1), 'other.csv': run(1.5) });
  const layout = page.locator('#log-layout');
  await expect(layout).toHaveValue('lab-data', { timeout: 30_000 });
  const zero = page.locator('#log-length-at-zero');
  await expect(page.locator('#log-length-at-zero-error')).toContainText('is needed', { timeout: 30_000 });
  await zero.fill('100 mm');
  await zero.press('Tab');
  const curve = page.locator('#panel-log .curve');
  await expect(curve).toContainText('1/l = α L + β', { timeout: 30_000 });
  const alpha = await curve.textContent();
  const several = page.locator('#panel-log .several');
  await expect(several.getByRole('button', { name: 'first.csv', pressed: true })).toBeVisible();
  await several.getByRole('button', { name: 'other.csv' }).click();
  await expect(page.locator('#panel-log .asked')).toContainText('other.csv: ', { timeout: 30_000 });
  // Another run may be of another coil.
  await expect(zero).toHaveValue('', { timeout: 30_000 });
  await zero.fill('100 mm');
  await zero.press('Tab');
  await expect(curve).toContainText('1/l = α L + β', { timeout: 30_000 });
  await settled(page);
  expect(await curve.textContent()).not.toBe(alpha);
  // Of another log the layout is not true.
  await drop(page, { 'hit.csv': readFileSync(join(folder, 'hit.csv'), 'utf8') });
  await expect(page.locator('#panel-log .verdict')).toContainText('spring: 13', { timeout: 60_000 });
  await expect(layout).toHaveValue('');
  await expect(several.getByRole('button')).toHaveCount(0);
});

test('what is being typed while a log is read stays', async ({ page }) => {
  await drop(page, { 'first.csv': run(1), 'other.csv': run(1.5) });
  const zero = page.locator('#log-length-at-zero');
  await expect(page.locator('#log-length-at-zero-error')).toContainText('is needed', { timeout: 30_000 });
  await page.locator('#panel-log .several').getByRole('button', { name: 'other.csv' }).click();
  await zero.fill('100 mm');
  await expect(page.locator('#panel-log .asked')).toContainText('other.csv: ', { timeout: 30_000 });
  await expect(page.locator('#log-layout')).toHaveValue('lab-data');
  await settled(page);
  await expect(zero).toHaveValue('100 mm');
  await zero.press('Tab');
  await expect(page.locator('#panel-log .curve')).toContainText('1/l = α L + β', { timeout: 30_000 });
});

test('what the page and the command simulate opens with its columns, and without a fault', async ({ page }) => {
  told('simulate', example('sea-ankle'), '--out', 'own.csv', '--overwrite');
  const own = readFileSync(join(folder, 'own-heel-strike-zeta-0.005.csv'), 'utf8');
  await page.goto('./#S_T');
  const downloaded = await saved(page, 'Series (CSV)');
  await page.goto('./#S_T&@tab="log"');
  for (const [name, text] of Object.entries({ 'own.csv': own, 'page.csv': downloaded })) {
    await drop(page, { [name]: text });
    await expect(page.locator('#panel-log .asked')).toContainText(`${name}: `, { timeout: 60_000 });
    await settled(page);
    for (const channel of ['u1', 'u2', 'F_i', 'F_o', 'L'])
      await expect(
        page.locator('#panel-log .columns select').and(page.getByLabel(new RegExp(`^${channel} \\[.+ is$`))),
      ).toHaveValue(channel);
    await expect(page.locator('#panel-log .guess')).toHaveCount(0);
    await expect(page.getByRole('region', { name: 'Calibration' })).toContainText('the positions stand still', {
      timeout: 30_000,
    });
    await expect(page.getByText('range of the lengths')).toHaveCount(0);
    if (name === 'own.csv') await expect(page.locator('#panel-log .verdict')).toContainText('spring: 8 decaying lines');
  }
});
