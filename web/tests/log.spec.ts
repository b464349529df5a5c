// Logs: what the page says of a simulated log is what the command says.
import AxeBuilder from '@axe-core/playwright';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { expect, test } from './page';

const page = new URL('..', import.meta.url).pathname;
const folder = join(page, 'test-results', 'log');
const program = process.env['COILSENSE_COMMAND'] ?? '';
const told = (...args: string[]): string =>
  execFileSync(program, args, { encoding: 'utf8', cwd: folder, maxBuffer: 1 << 28 });

test.beforeAll(() => {
  mkdirSync(folder, { recursive: true });
  told('rig', join(page, '..', 'examples', 'virtual-rig.toml'), '--out', 'rig');
  writeFileSync(join(folder, 'tap.csv'), readFileSync(join(folder, 'rig', 'tap-1-fast.csv')));
});

/** The largest relative difference of two JSON values of one shape; texts must be the same. */
function apart(here: unknown, there: unknown, place = ''): number {
  if (typeof here === 'number' && typeof there === 'number')
    return here === there ? 0 : Math.abs(here - there) / Math.max(Math.abs(there), 1e-9);
  if (here !== null && there !== null && typeof here === 'object' && typeof there === 'object') {
    expect(Object.keys(here), place).toEqual(Object.keys(there));
    return Math.max(
      0,
      ...Object.entries(here).map(([key, value]) =>
        apart(value, (there as Record<string, unknown>)[key], `${place}/${key}`),
      ),
    );
  }
  expect(here, place).toEqual(there);
  return 0;
}

async function saved(page: Page, button: string): Promise<string> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: button }).click(),
  ]);
  return readFileSync((await download.path()) ?? '', 'utf8');
}

async function drop(page: Page, name: string, content: string): Promise<void> {
  const data = await page.evaluateHandle(
    ([name, content]) => {
      const data = new DataTransfer();
      data.items.add(new File([content ?? ''], name ?? ''));
      return data;
    },
    [name, content],
  );
  await page.dispatchEvent('.drop', 'drop', { dataTransfer: data });
}

test('a dropped log is identified with the numbers of the command', async ({ page }) => {
  await page.goto('./#S_T&@tab="log"');
  await drop(page, 'tap.csv', readFileSync(join(folder, 'tap.csv'), 'utf8'));
  await expect(page.locator('#panel-log .verdict')).toContainText('spring: 12 lines that die out', { timeout: 60_000 });
  await expect(page.locator('[data-quantity=first_frequency_hz] td').first()).toHaveText('54.06 Hz');
  const here = JSON.parse(await saved(page, 'Everything (JSON)')) as unknown;
  const difference = apart(here, JSON.parse(told('identify', 'tap.csv', '--json')));
  console.log(`identify: largest relative difference ${difference.toExponential(1)}`);
  // Fits end where steps become small: 1e-8 of what is fitted.
  expect(difference).toBeLessThan(1e-7);
});

test('columns are mapped, and a wrong log is refused with its row and column', async ({ page }) => {
  await page.goto('./#S_T&@tab="log"');
  const rows = readFileSync(join(folder, 'tap.csv'), 'utf8')
    .split('\n')
    .filter((line) => !line.startsWith('#'))
    .slice(0, 20_001);
  rows[0] = 'a,b,c';
  await drop(page, 'nameless.csv', rows.join('\n'));
  await expect(page.locator('#panel-log .refusal')).toBeVisible({ timeout: 30_000 });
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
  await drop(page, 'broken.csv', rows.join('\n'));
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
  writeFileSync(join(folder, 'coil.csv'), text);
  await page.goto('./#S_T&@tab="log"');
  await drop(page, 'coil.csv', text);
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

for (const [width, colorScheme] of [
  [375, 'dark'],
  [1280, 'light'],
  [2560, 'dark'],
] as const) {
  test(`the tab fits ${width} pixels in ${colorScheme}, and axe finds nothing`, async ({ page }) => {
    await page.setViewportSize({ width, height: 900 });
    await page.emulateMedia({ colorScheme });
    await page.goto('./#S_T&@tab="log"');
    await page.locator('#log-file').setInputFiles(join(folder, 'tap.csv'));
    await expect(page.locator('#panel-log .verdict')).toBeVisible({ timeout: 60_000 });
    const fine = async (tab: string) => {
      expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), tab).toBeLessThanOrEqual(0);
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      await page.screenshot({ path: join(folder, `${tab}-${width}-${colorScheme}.png`), fullPage: true });
    };
    await fine('log');
  });
}
