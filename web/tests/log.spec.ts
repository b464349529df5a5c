// Logs: what the page says of a dropped log is what the command says.
import AxeBuilder from '@axe-core/playwright';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { apart, drop, saved } from './jobs';
import { folder, rigLogs, told, written } from './logs';
import { typical } from './long';
import { expect, test } from './page';

test.beforeAll(rigLogs);

test('a dropped log is identified with the numbers of the command', async ({ page }) => {
  await page.goto('./#S_T&@tab="log"');
  await drop(page, { 'hit.csv': readFileSync(join(folder, 'hit.csv'), 'utf8') });
  await expect(page.locator('#panel-log .verdict')).toContainText('spring: 13 decaying lines', { timeout: 60_000 });
  await expect(page.locator('[data-quantity=first_frequency_hz] td').first()).toHaveText(/^54\.0\d+ Hz$/);
  const here = JSON.parse(await saved(page, 'Everything (JSON)')) as unknown;
  const difference = apart(here, JSON.parse(told('identify', 'hit.csv', '--json')));
  console.log(`identify: largest relative difference ${difference.toExponential(1)}`);
  // Fits end where steps become small: 1e-8 of what is fitted.
  expect(difference).toBeLessThan(1e-7);
});

test('columns are mapped, and a wrong log is refused with its row and column', async ({ page }) => {
  await page.goto('./#S_T&@tab="log"');
  const rows = readFileSync(join(folder, 'hit.csv'), 'utf8')
    .split('\n')
    .filter((line) => !line.startsWith('#'))
    .slice(0, 20_001);
  rows[0] = 'a,b,c';
  await drop(page, { 'nameless.csv': rows.join('\n') });
  await expect(page.locator('#panel-log .asked > .refusal')).toBeVisible({ timeout: 30_000 });
  for (const [column, channel, unit] of [
    ['a', 'time', 's'],
    ['b', 'F_o', 'N'],
    ['c', 'u1', 'mm'],
  ] as const) {
    await page.getByLabel(`Unit of ${column}`, { exact: true }).fill(unit);
    await page.getByLabel(`${column} is`, { exact: true }).selectOption(channel);
  }
  await expect(page.locator('#panel-log .verdict')).toContainText('spring', { timeout: 60_000 });
  await expect(page.locator('#panel-log .refusal').first()).toBeHidden();
  rows[40] = rows[40]!.replace(/,[^,]*,/, ',x,');
  rows[0] = 'time [s],F_o [N],u1 [mm]';
  await drop(page, { 'broken.csv': rows.join('\n') });
  await expect(page.locator('#panel-log .refusal').first()).toHaveText(
    /broken\.csv:41: column 2 "F_o \[N\]": "x" is not a number/,
    { timeout: 30_000 },
  );
});

test('a curve of inductance over length is fitted as the command fits it', async ({ page }) => {
  const rows = Array.from({ length: 2001 }, (_, index) => {
    const [t, u] = [index / 1000, 20 * Math.sin(index / 160)];
    return `${t.toFixed(4)},${u.toFixed(6)},${(1e6 * (5e-7 / (0.2 + 1e-3 * u) + 1e-6)).toFixed(9)},${(735 * (0.05 + 1e-3 * u)).toFixed(6)}`;
  });
  const text = ['time [s],u2 [mm],L [uH],F_o [N]', ...rows].join('\n') + '\n';
  written('coil.csv', text);
  await page.goto('./#S_T&@tab="log"');
  await drop(page, { 'coil.csv': text });
  await page.getByText('Calibration', { exact: true }).first().click();
  await page.getByLabel('Length at zero').fill('200 mm');
  await page.getByLabel('Length at zero').press('Tab');
  await expect(page.getByRole('region', { name: 'Calibration' })).toContainText('1/l = α L + β', { timeout: 30_000 });
  const here = JSON.parse(await saved(page, 'Calibration (JSON)')) as { inverse_length: unknown };
  const there = JSON.parse(told('calibrate', 'coil.csv', '--length-at-zero', '200 mm', '--json')) as {
    inverse_length: unknown;
  };
  expect(apart(here.inverse_length, there.inverse_length)).toBeLessThan(1e-9);
});

for (const [width, colorScheme] of typical([
  [375, 'dark'],
  [1280, 'light'],
  [2560, 'dark'],
] as const)) {
  test(`the tab fits ${width} pixels in ${colorScheme}, and axe finds nothing`, async ({ page }) => {
    await page.setViewportSize({ width, height: 900 });
    await page.emulateMedia({ colorScheme });
    await page.goto('./#S_T&@tab="log"');
    await page.locator('#log-file').setInputFiles(join(folder, 'hit.csv'));
    await expect(page.locator('#panel-log .verdict')).toBeVisible({ timeout: 60_000 });
    const fine = async (tab: string) => {
      expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), tab).toBeLessThanOrEqual(0);
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      await page.screenshot({ path: join(folder, `${tab}-${width}-${colorScheme}.png`), fullPage: true });
    };
    await fine('log');
  });
}

for (const colorScheme of typical(['light', 'dark'] as const)) {
  test(`before any log, and with a wrong choice, axe finds nothing in ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await page.goto('./#S_T&@tab="log"');
    await expect(page.getByRole('region', { name: 'What a log tells' })).toBeVisible();
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await page.locator('#log-file').setInputFiles(join(folder, 'hit.csv'));
    await expect(page.locator('#panel-log .verdict')).toBeVisible({ timeout: 60_000 });
    for (const summary of await page.locator('#panel-log summary').all()) await summary.click();
    await page.getByLabel('Coil radius', { exact: true }).fill('8 kg');
    await page.getByLabel('Coil radius', { exact: true }).press('Tab');
    await expect(page.getByText('What stands here is of the choices as they were before.')).toBeVisible();
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await page.screenshot({ path: join(folder, `log-wrong-${colorScheme}.png`), fullPage: true });
  });
}
