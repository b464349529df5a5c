// Two devices on one clock, theories beside a calibration, and the log as it was dropped.
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { apart, drop, saved } from './jobs';
import { folder, rigLogs, settled, told, type, written } from './logs';
import { expect, test } from './page';

const examples = join(new URL('..', import.meta.url).pathname, '..', 'examples');

test.beforeAll(rigLogs);

/** The page's simulated log, and its text. */
async function simulated(page: Page): Promise<string> {
  await page.goto('./#S_T&@tab="log"');
  await page.getByRole('button', { name: 'Try it with a simulated log' }).click();
  await expect(page.locator('#panel-log .verdict')).toBeVisible({ timeout: 60_000 });
  await settled(page);
  return written('simulated-S_T.csv', await saved(page, 'Save the simulated log (CSV)'));
}

test('a second device is put on the first one’s clock, as the command does', async ({ page }) => {
  const rows = (await simulated(page))
    .split('\n')
    .filter((line) => /^\d/.test(line))
    .map((line) => line.split(','));
  const first = ['time [s],F_i [N],F_o [N]', ...rows.map(([t, , , a, b]) => `${t},${a},${b}`)].join('\n');
  const late = (time = '') => (Number(time) + 0.25).toFixed(4);
  const second = ['clock,left,right,cell', ...rows.map(([t, a, b, , f]) => `${late(t)},${a},${b},${f}`)].join('\n');
  written('first.csv', first);
  written('second.csv', second);
  await drop(page, { 'first.csv': first });
  await expect(page.getByRole('region', { name: 'What became of the rows' })).toContainText('first.csv', {
    timeout: 30_000,
  });
  await page.getByText('A second device').click();
  await drop(page, { 'second.csv': second }, '.drop >> nth=1');
  for (const [column, channel, unit] of [
    ['clock', 'time', 's'],
    ['left', 'u1', 'mm'],
    ['right', 'u2', 'mm'],
    ['cell', 'F_o', 'N'],
  ] as const) {
    await page.getByLabel(`Unit of ${column}, second device`, { exact: true }).fill(unit);
    await page.getByLabel(`${column} is, second device`, { exact: true }).selectOption(channel);
  }
  await expect(page.getByRole('region', { name: 'The second device' })).toContainText('−250 ms were added', {
    timeout: 60_000,
  });
  await settled(page);
  const columns = ['time=clock [s]', 'u1=left [mm]', 'u2=right [mm]', 'F_o=cell [N]'].flatMap((one) => [
    '--with-column',
    one,
  ]);
  const there = JSON.parse(told('identify', 'first.csv', '--with', 'second.csv', ...columns, '--json')) as unknown;
  expect(apart(JSON.parse(await saved(page, 'Everything (JSON)')), there)).toBeLessThan(1e-7);
  await type(page, 'A second device', 'Its clock', '-0.2 s');
  await expect(page.getByRole('region', { name: 'The second device' })).toContainText(
    '−200 ms were added to its times, as told',
    {
      timeout: 60_000,
    },
  );
  await type(page, 'A second device', 'Its clock', 'F_o=F_9');
  await expect(page.locator('#panel-log .wrong .error')).toContainText('must name two of', { timeout: 30_000 });
});

test('the theories of the page’s spring stand beside the fit, with the command’s numbers', async ({ page }) => {
  await simulated(page);
  const region = page.getByRole('region', { name: 'Calibration', exact: true });
  await expect(region).toContainText('then theories are compared');
  await page.locator('#panel-log summary:text-is("The spring")').click();
  await page.getByLabel('It is', { exact: true }).selectOption('tab');
  await expect(region.locator('[data-theory="ideal solenoid"]')).toBeVisible({ timeout: 60_000 });
  await settled(page);
  const here = JSON.parse(await saved(page, 'Calibration (JSON)')) as { theories: unknown[] };
  const there = JSON.parse(
    told('calibrate', 'simulated-S_T.csv', '--spec', join(examples, 'sea-ankle.toml'), '--json'),
  ) as typeof here;
  const difference = apart(here, there);
  console.log(
    `calibrate: ${here.theories.length} theories, largest relative difference ${difference.toExponential(1)}`,
  );
  expect(here.theories.length).toBeGreaterThan(5);
  expect(difference).toBeLessThan(1e-9);
  await type(page, 'Calibration', 'Preload', '230 mm, 3.2 uH');
  await expect(region).toContainText('through the preload', { timeout: 60_000 });
  await settled(page);
  const fit = (json: string) => (JSON.parse(json) as { inverse_length: unknown }).inverse_length;
  const command = told('calibrate', 'simulated-S_T.csv', '--preload', '230 mm, 3.2 uH', '--json');
  expect(apart(fit(await saved(page, 'Calibration (JSON)')), fit(command))).toBeLessThan(1e-9);
  await type(page, 'Calibration', 'Preload', '230 N');
  await expect(page.locator('#panel-log .wrong .error')).toContainText('got "230 N"', { timeout: 30_000 });
});

/** Length [m] and L [H] of S_T of wire of a permeability of 2.5, as `coilsense simulate` has them (self_distance = "geometric-mean"). */
const MAGNETIC = [
  [0.2, 3.5003407266e-6],
  [0.201468, 3.4788259594e-6],
  [0.201468, 3.4788259594e-6],
  [0.205729, 3.4183358262e-6],
  [0.205729, 3.4183358262e-6],
  [0.212366, 3.3295301283e-6],
  [0.212366, 3.3295301283e-6],
  [0.220729, 3.2261308568e-6],
  [0.220729, 3.2261308568e-6],
  [0.23, 3.1213416381e-6],
  [0.23, 3.1213416381e-6],
  [0.239271, 3.0256527974e-6],
  [0.247634, 2.9462355807e-6],
  [0.254271, 2.8873951444e-6],
  [0.258532, 2.851414597e-6],
  [0.26, 2.8393259019e-6],
] as const;

test('a slider says what wire of each permeability would leave of the points, the least where the command fits it', async ({
  page,
}) => {
  // Simulated coils carry no current along their axis; real ones do, μ₀ l/2π (ln(2l/r) − 1) with leads far away.
  const along = (length: number) => 2e-7 * length * (Math.log((2 * length) / 8e-3) - 1);
  const rows = MAGNETIC.map(([length, henry], index) => `${index},0,${length},${henry + along(length)}`);
  written('magnetic.csv', `time [s],u1 [m],u2 [m],L [H]\n${rows.join('\n')}\n`);
  await page.goto('./#S_T&@tab="log"');
  await page.locator('#log-file').setInputFiles(join(folder, 'magnetic.csv'));
  const region = page.getByRole('region', { name: 'Calibration', exact: true });
  await expect(region).toBeVisible({ timeout: 60_000 });
  const wire = page.getByRole('region', { name: 'Is its wire magnetic?', exact: true });
  // Without a coil nothing is known of its wire.
  await expect(wire).toHaveCount(0);
  await page.locator('#panel-log summary:text-is("The spring")').click();
  await page.getByLabel('It is', { exact: true }).selectOption('tab');
  await expect(wire).toContainText('Least remains at', { timeout: 60_000 });
  await settled(page);
  const there = JSON.parse(
    told('calibrate', 'magnetic.csv', '--spec', join(examples, 'sea-ankle.toml'), '--theory', 'steel', '--json'),
  ) as { steel: { relative_permeability: number; offset_h: number } };
  const said = async (pattern: RegExp) => Number(pattern.exec(await wire.innerText())?.[1]?.replace('−', '-'));
  const [best, left, air] = [/Least remains at ([\d.]+)\./, /nH, ([\d.e−-]+) nH rms/, /αL \+ β leaves ([\d.]+) nH/];
  // To a hundredth, and what a straight line between tenths is off.
  expect(Math.abs((await said(best)) - there.steel.relative_permeability)).toBeLessThan(0.03);
  expect(Math.abs((await said(/constant of (\S+) nH/)) - 1e9 * there.steel.offset_h)).toBeLessThan(10);
  const least = await said(left);
  expect(least).toBeLessThan(0.5 * (await said(air)));
  const slider = wire.getByLabel('Relative permeability', { exact: true });
  await slider.fill('1');
  await expect(wire).toContainText('With a permeability of 1 (not magnetic)');
  expect(await said(left)).toBeGreaterThan(1.5 * least);
  for (const [width, colorScheme] of [
    [390, 'dark'],
    [1280, 'light'],
  ] as const) {
    await page.setViewportSize({ width, height: 900 });
    await page.emulateMedia({ colorScheme });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    await wire.screenshot({ path: join(folder, `wire-${width}.png`) });
  }
});

test('a file of the measured runs’ layout is calibrated as the command does by the preset', async ({ page }) => {
  // Made up: 12 positions of 3 mm, ten readings each of a coil of 5e-7 H m.
  const row = (step: number) => {
    const henry = 5e-7 / (0.11 + 3e-3 * step);
    const pairs = Array.from(
      { length: 10 },
      (_, n) => `${0.1 + n / 100};${(henry * (1 + 1e-4 * Math.sin(7 * n + step))).toExponential(9)}`,
    );
    return [step, 0, 0, 3 * step, ...pairs].join(';');
  };
  const text = written('runs.csv', Array.from({ length: 13 }, (_, step) => row(step)).join('\n') + '\n');
  await page.goto('./#S_T&@tab="log"&@log={"layout":"lab-data"}');
  await drop(page, { 'runs.csv': text });
  await expect(page.locator('#panel-log .wrong .error')).toContainText('is needed', { timeout: 30_000 });
  await type(page, 'Calibration', 'Length at zero', '110 mm');
  await expect(page.getByRole('region', { name: 'Calibration', exact: true })).toContainText(
    'first and the last of 12 points',
    {
      timeout: 30_000,
    },
  );
  await settled(page);
  const there = JSON.parse(
    told('calibrate', 'runs.csv', '--preset', 'lab-data', '--length-at-zero', '110 mm', '--json'),
  ) as unknown;
  expect(apart(JSON.parse(await saved(page, 'Calibration (JSON)')), there)).toBeLessThan(1e-9);
});

test('the log is drawn as it was dropped, with its hits, and a part of it can be looked at', async ({ page }) => {
  await simulated(page);
  const region = page.getByRole('region', { name: 'What was recorded' });
  await expect(region).toContainText(/[56] hits were found/);
  for (const name of ['Forces over time', 'Positions over time', 'Inductance over time'])
    await expect(region.getByRole('img', { name })).toBeVisible();
  const shown = region.locator('[aria-live]');
  await expect(shown).toHaveText(/^0 s to 15\.2\d* s$/);
  await region.getByRole('button', { name: 'Zoom in' }).press('Enter');
  await expect(shown).toHaveText(/^3\.8\d* s to 11\.4\d* s$/);
  await region.getByRole('button', { name: 'Later' }).press('Enter');
  await expect(shown).toHaveText(/^6\.8\d* s to 14\.4\d* s$/);
  const over = region.locator('.u-over').first();
  await over.scrollIntoViewIfNeeded();
  const box = (await over.boundingBox())!;
  await page.mouse.move(box.x + 0.25 * box.width, box.y + 40);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 40, { steps: 4 });
  await page.mouse.up();
  await expect(shown).toHaveText(/^8\.7\d* s to 10\.6\d* s$/);
  // A choice does not change what is looked at.
  await type(page, 'How exact', 'A force is trusted up to', '2 %');
  await expect(page.getByRole('region', { name: 'Verdict' })).toContainText('Within 2.00 % of its amplitude', {
    timeout: 30_000,
  });
  await expect(shown).toHaveText(/^8\.7\d* s to 10\.6\d* s$/);
  await over.dblclick();
  await expect(shown).toHaveText(/^0 s to 15\.2\d* s$/);
});

test('two logs that are dropped together are two devices, and one can be left out again', async ({ page }) => {
  const rows = (await simulated(page))
    .split('\n')
    .filter((line) => /^\d/.test(line))
    .map((line) => line.split(','));
  const first = ['time [s],F_i [N],F_o [N]', ...rows.map(([t, , , a, b]) => `${t},${a},${b}`)].join('\n');
  const second = ['time [s],u1 [mm],u2 [mm]', ...rows.map(([t, a, b]) => `${t},${a},${b}`)].join('\n');
  await drop(page, { 'first.csv': first, 'second.csv': second });
  await expect(page.locator('#panel-log .refusal').first()).toContainText('no channel is in both', { timeout: 30_000 });
  await type(page, 'A second device', 'Its clock', '0 s');
  await expect(page.getByRole('region', { name: 'The second device' })).toContainText('0 ms were added', {
    timeout: 60_000,
  });
  await expect(page.locator('[data-quantity=stiffness_n_per_m] td').first()).toHaveText(/^760\.0/, { timeout: 30_000 });
  await page.getByRole('button', { name: 'Without it' }).click();
  await expect(page.locator('[data-quantity=stiffness_n_per_m] td').first()).not.toHaveText(/^760/, {
    timeout: 30_000,
  });
  await expect(page.getByRole('region', { name: 'The second device' })).toHaveCount(0);
});

test('a log that says nothing is still drawn, beside the reason', async ({ page }) => {
  const text = 'time [s],u1 [mm]\n' + Array.from({ length: 200 }, (_, row) => `${row / 100},${row % 7}`).join('\n');
  await page.goto('./#S_T&@tab="log"');
  await drop(page, { 'still.csv': text });
  await expect(page.locator('#panel-log .refusal').first()).toContainText('still.csv: ', { timeout: 30_000 });
  await expect(page.getByRole('img', { name: 'Positions over time' })).toBeVisible();
});
