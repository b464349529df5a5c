// Remedies: what the page says of a spec's conditions, of the stated scenario and of a log is what the command says; picked, taken along, linked.
import AxeBuilder from '@axe-core/playwright';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import type { Ranking } from '../src/mitigate/ranking';
import { apart, drop, example, folderOf, saved } from './jobs';
import { typical } from './long';
import { expect, test } from './page';

const { folder, told } = folderOf('mitigate');
const panel = '#panel-mitigate';
/** Designs are solutions of equations, solved on two processors: of 1e-16 a few million times as much may come. */
const SAME = 1e-8;

/** The tab with these choices. */
const address = (choices: Record<string, string> = {}, preset = 'S_T'): string =>
  `./#${preset}&@tab="mitigate"&@mitigate=${encodeURIComponent(JSON.stringify(choices))}`;

async function judge(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Judge', exact: true }).click();
  await expect(page.locator(`${panel} [role=status]`).filter({ hasText: 'Judged in' })).toBeVisible({
    timeout: 110_000,
  });
}

/** A text in words and in decimal numbers. */
const parts = (text: string): { words: string[]; numbers: number[] } => {
  const number = /-?\d+\.\d+(?:[eE][-+]?\d+)?/g;
  return { words: text.split(number), numbers: (text.match(number) ?? []).map(Number) };
};

/** How far the page's whole answer is from the command's. */
async function difference(page: Page, ...args: string[]): Promise<number> {
  const here = JSON.parse(await saved(page, 'Everything (JSON)')) as unknown;
  const found = apart(here, JSON.parse(told('mitigate', ...args, '--json')));
  console.log(`mitigate ${args.slice(1).join(' ')}: largest relative difference ${found.toExponential(1)}`);
  return found;
}

test('within ten seconds it is clear what this is and what to press', async ({ page }) => {
  await page.goto(address());
  await expect(page.getByRole('heading', { name: 'Which filter takes the ringing out' })).toBeVisible();
  await expect(page.getByText('Press Judge')).toBeVisible();
  await expect(page.getByRole('button', { name: 'Judge' })).toBeInViewport();
});

test('without any choice the answer is the command’s, advice and all', async ({ page }) => {
  await page.goto(address());
  await judge(page);
  expect(await difference(page, example('sea-ankle'))).toBeLessThan(SAME);
  await expect(page.locator(`${panel} .verdict`)).toContainText(
    'Sampled at 2000 Hz ([control]) with 0.03 N rms of noise (load cell, motor side), 5 series; k ±0.5 % (from the spec), m ±10 % (assumed)',
  );
});

test('where u1 moves, shaped commands are told with what they leave and cost', async ({ page }) => {
  await page.goto(address({ seeds: '1' }));
  await judge(page);
  const card = page.getByRole('region', { name: 'Shape the command instead' });
  await expect(card).toContainText('half resonance, resonance');
  const { command_shaping: told } = JSON.parse(await saved(page, 'Everything (JSON)')) as Ranking;
  for (const one of told!.shapers) {
    const cells = card.locator(`[data-shaper="${one.name}"] td`);
    await expect(cells.nth(1)).toHaveText(`${(100 * one.mode_1_left_worst).toFixed(1)} %`);
    await expect(cells.nth(3)).toHaveText(`${(1e3 * one.mean_delay_s).toFixed(1)} ms`);
  }
  // Two impulses half a period of 54.07 Hz apart: late by a quarter of it, 4.6 ms.
  await expect(card.locator('[data-shaper^="ZV,"] td').nth(3)).toHaveText('4.6 ms');
});

test('every option counts as it does for the command', async ({ page }) => {
  await page.goto(address({ seeds: '1' }));
  await page.getByText('Sampling, noise, tolerances').click();
  for (const [label, value] of [
    ['Most lag', '12 deg'],
    ['Sampling rate', '4 kHz'],
    ['Noise of', '0.4 N'],
    ['Bandwidth', '2 Hz'],
    ['Stiffness off by', '4 %'],
    ['Mass off by', '7 %'],
  ] as const)
    await page.locator(panel).getByLabel(label).fill(value);
  await judge(page);
  const options = ['--rate', '4 kHz', '--noise', '0.4 N', '--bandwidth', '2 Hz', '--stiffness-tolerance', '4 %'];
  const more = ['--mass-tolerance', '7 %', '--most-lag', '12 deg', '--seeds', '1'];
  expect(await difference(page, example('sea-ankle'), ...options, ...more)).toBeLessThan(SAME);
  await expect(page.locator(`${panel} .verdict`)).toContainText(
    'Sampled at 4000 Hz with 0.4 N rms of noise, one series',
  );
});

test('another spring has its own usual noise and bandwidth', async ({ page }) => {
  await page.goto(address({ seeds: '1', rate: '10 kHz' }, 'valve'));
  await page.getByText('Sampling, noise, tolerances').click();
  await judge(page);
  expect(await difference(page, example('valve-spring'), '--seeds', '1', '--rate', '10 kHz')).toBeLessThan(SAME);
  const noise = (JSON.parse(await saved(page, 'Everything (JSON)')) as Ranking).noise_n;
  await expect(page.getByLabel('Noise of')).toHaveAttribute('placeholder', `${Number(noise.toPrecision(3))} N`);
});

test('the stated scenario is judged as the command judges it', async ({ page }) => {
  test.setTimeout(300_000);
  await page.goto(address());
  await page.getByLabel('Judge on').selectOption('stated');
  await expect(page.getByLabel('Most lag')).toBeHidden();
  await page.getByRole('button', { name: 'Judge', exact: true }).click();
  await expect(page.locator(`${panel} .verdict`).getByText('50 series')).toBeVisible({ timeout: 280_000 });
  expect(await difference(page, example('sea-ankle'), '--stated')).toBeLessThan(SAME);
});

test('a wrong choice is red with the reason, and the last good answer stays', async ({ page }) => {
  await page.goto(address({ seeds: '1' }));
  await judge(page);
  await page.getByText('Sampling, noise, tolerances').click();
  for (const [label, name, value, reason] of [
    ['Most lag', 'most-lag', '30 N', 'must be an angle with its unit (rad, deg), got "30 N"'],
    ['Sampling rate', 'rate', '90 Hz', 'must be above twice the first surge frequency of 54.065 Hz, got 90 Hz'],
    ['Noise of', 'noise', '-1 N', 'must be above zero, got "-1 N"'],
    ['Bandwidth', 'bandwidth', '1 kHz', 'must be above zero and below the first surge frequency, got 1000 Hz'],
    ['Mass off by', 'mass-tolerance', '120 %', 'must be from 0 % to below 100 %, got "120 %"'],
    ['Series of noise', 'seeds', '1.5', 'must be a whole number from 1 to 1000, got "1.5"'],
  ] as const) {
    const field = page.locator(panel).getByLabel(label);
    const before = await field.inputValue();
    await field.fill(value);
    await expect(page.locator(`#mitigate-${name}-error`)).toContainText(reason);
    await expect(field).toHaveAttribute('aria-invalid', 'true');
    await page.getByRole('button', { name: 'Judge', exact: true }).click();
    await expect(page.locator(`${panel} tr[data-candidate]`).first()).toBeVisible();
    await expect(page.locator(`#mitigate-${name}-error`)).toContainText(reason);
    await field.fill(before);
    await expect(page.locator(`#mitigate-${name}-error`)).toBeHidden();
  }
});

test('a point, a line of the table and the curve are always the same candidate', async ({ page }) => {
  await page.goto(address({ seeds: '1' }));
  await judge(page);
  const out = page.getByRole('region', { name: 'What comes out' });
  await page.getByRole('button', { name: 'mean over 2τ' }).press('Enter');
  await expect(out.getByRole('heading')).toHaveText('mean over 2τ');
  // The pointer goes over the plot until a point is named; a click picks that one.
  const plot = page.getByRole('img', { name: /Filters.*error against lag/ }).locator('.u-over');
  await plot.scrollIntoViewIfNeeded();
  const box = (await plot.boundingBox())!;
  const tip = plot.locator('.tip');
  const met = new Set<string>();
  let name = '';
  for (let at = 0; at < 400 && met.size < 3; at++) {
    const [x, y] = [(at % 20) * (box.width / 20) + 5, Math.floor(at / 20) * (box.height / 20) + 5];
    await page.mouse.move(box.x + x, box.y + y);
    if (!(await tip.isVisible())) continue;
    const said = (await tip.textContent()) ?? '';
    expect(said).toMatch(/: [\d.]+ % at worst, [\d.]+ % on the nominal spring, −?[\d.]+° late$/);
    name = said.replace(/: [\d.]+ % at worst.*$/, '');
    met.add(name);
    await page.mouse.click(box.x + x, box.y + y);
    await expect(out.getByRole('heading')).toHaveText(name);
  }
  expect(met.size).toBeGreaterThanOrEqual(3);
  await expect(page.locator(`${panel} button.line[aria-pressed=true]`)).toHaveText(name);
  await expect.poll(() => decodeURIComponent(page.url()).replaceAll('+', ' ')).toContain(`"candidate":"${name}"`);
});

test('settings are the command’s in either precision, as C, Rust and JSON', async ({ page }) => {
  await page.goto(address({ seeds: '1', candidate: 'none of them' }));
  // A link to a candidate judges by itself; one that is not there gives way to what is advised.
  await expect(page.locator(`${panel} .verdict`).getByText('With 1 series')).toBeVisible({ timeout: 100_000 });
  for (const precision of ['single', 'double'] as const) {
    told('mitigate', example('sea-ankle'), '--seeds', '1', '--precision', precision, '--out', precision);
    const wanted = (ending: string) => readFileSync(join(folder, precision, `force_filter.${ending}`), 'utf8');
    await page.getByLabel('Precision of the settings').selectOption(`${precision} precision`);
    for (const [button, ending] of [
      ['Settings (C header)', 'h'],
      ['Settings (Rust)', 'rs'],
      ['Settings (JSON)', 'json'],
    ] as const) {
      const [here, there] = [await saved(page, button), wanted(ending)].map(parts);
      expect(here!.words).toEqual(there!.words);
      const off = Math.max(...here!.numbers.map((number, index) => Math.abs(number - there!.numbers[index]!)));
      console.log(`${precision} ${ending}: ${here!.numbers.length} numbers, off by ${off.toExponential(1)} at most`);
      // Taps below 0.1, solved for on two processors; single precision may round them to neighbours.
      expect(off).toBeLessThan(precision === 'single' ? 1e-8 : 1e-12);
    }
  }
});

test('the signal and the pictures are taken along', async ({ page }) => {
  await page.goto(address({ seeds: '1' }));
  await judge(page);
  const table = async () => {
    const [titles = '', ...rows] = (await saved(page, 'Signal (CSV)')).trim().split('\n');
    expect(titles).toBe('time [s],F_i [N],out [N],truth [N]');
    return rows.map((row) => row.split(',').map(Number));
  };
  await page.getByRole('button', { name: 'F_i, unfiltered' }).click();
  for (const [, measured, out] of await table()) expect(out).toBe(measured);
  // A notch, run here once more from its settings: b0 x + b1 x' + b2 x'' − a1 y' − a2 y''.
  await page.getByRole('button', { name: 'notch at f1, Q = 2' }).click();
  const { settings } = JSON.parse(await saved(page, 'Settings (JSON)')) as {
    settings: { sections: Record<'a1' | 'a2' | 'b0' | 'b1' | 'b2', number>[] };
  };
  const { a1, a2, b0, b1, b2 } = settings.sections[0]!;
  const rows = await table();
  const worst = Math.max(
    ...rows.slice(2).map(([, x = 0, y = 0], index) => {
      const [[, x2 = 0, y2 = 0], [, x1 = 0, y1 = 0]] = [rows[index]!, rows[index + 1]!] as [number[], number[]];
      return Math.abs(b0 * x + b1 * x1 + b2 * x2 - a1 * y1 - a2 * y2 - y);
    }),
  );
  // The same five products in another order, on forces of 1e2 N.
  expect(worst).toBeLessThan(1e-10);
  const figure = await saved(page, 'Figure (SVG)');
  expect(figure).toContain('what comes out');
  expect(figure).not.toContain('NaN');
  const [first] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Error against lag (SVG)' }).click(),
  ]);
  const picture = readFileSync((await first.path()) ?? '', 'utf8');
  const filters = await page
    .getByRole('region', { name: /Ranking: Filters/ })
    .locator('tbody tr')
    .count();
  // One dot each, three in the legend.
  expect(picture.match(/<circle/g)).toHaveLength(filters + 3);
  expect(picture).not.toContain('NaN');
});

test('a log is judged with the numbers of the command, its columns by name or by hand', async ({ page }) => {
  told('simulate', example('sea-ankle'), '--out', 'motion.csv');
  const text = readFileSync(join(folder, 'motion-heel-strike-zeta-0.005.csv'), 'utf8');
  // What a design takes for noise is what keeps its equations apart: with the eighth of it that the load cell has, two processors differ 50 times as much.
  const noise = '0.24 N';
  await page.goto(address({ noise }));
  await page.getByLabel('Judge on').selectOption('log');
  await page.getByRole('button', { name: 'Judge', exact: true }).click();
  await expect(page.locator(`${panel} .refusal`).filter({ hasText: 'Drop a log first' })).toBeVisible();
  await drop(page, { 'motion-heel-strike-zeta-0.005.csv': text }, `${panel} .drop`);
  await expect(page.getByLabel('F_i [N] is, to judge on')).toHaveValue('F_i', { timeout: 20_000 });
  await judge(page);
  const log = ['--log', 'motion-heel-strike-zeta-0.005.csv', '--noise', noise];
  expect(await difference(page, example('sea-ankle'), ...log)).toBeLessThan(SAME);
  // The same without names, and without F_o: filters alone.
  const nameless = text.replace(/^.*$/m, (titles) => titles.replace('F_i [N],F_o [N]', 'force,other'));
  await drop(page, { 'nameless.csv': nameless }, `${panel} .drop`);
  await expect(page.getByLabel('force is, to judge on')).toHaveValue('', { timeout: 20_000 });
  await page.getByRole('button', { name: 'Judge', exact: true }).click();
  await expect(page.locator(`${panel} .refusal`).filter({ hasText: 'nameless.csv' })).toContainText('F_i');
  await page.getByLabel('force is, to judge on').selectOption('F_i');
  await page.getByLabel('Unit of force, to judge on').fill('kN');
  await page.getByLabel('Unit of force, to judge on').press('Tab');
  await page.getByLabel('Unit of force, to judge on').fill('N');
  await page.getByLabel('Unit of force, to judge on').press('Tab');
  await judge(page);
  const here = JSON.parse(await saved(page, 'Everything (JSON)')) as { candidates: { against: string }[] };
  const there = JSON.parse(told('mitigate', example('sea-ankle'), ...log, '--json')) as typeof here;
  const filters = ({ candidates }: typeof here) => candidates.filter(({ against }) => against === 'k·Δl');
  expect(here.candidates).toHaveLength(filters(there).length);
  // The worst run has the log's name.
  const plain = (each: object[]) => each.map((one) => ({ ...one, worst_run: '' }));
  expect(apart(plain(here.candidates), plain(filters(there)))).toBeLessThan(SAME);
});

test('choices travel in the address, and numbers of an earlier state are said to be so', async ({ page, context }) => {
  await page.goto(address({ seeds: '1' }));
  await judge(page);
  const earlier = page.getByText('These numbers are of an earlier state');
  await expect(earlier).toBeHidden();
  await page.getByLabel('Most lag').fill('40 deg');
  await expect(earlier).toBeVisible();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByLabel('Most lag')).toHaveValue('');
  await expect(earlier).toBeHidden();
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect(page.getByLabel('Most lag')).toHaveValue('40 deg');
  await page.getByRole('button', { name: 'Judge again' }).click();
  await expect(earlier).toBeHidden({ timeout: 100_000 });
  await page.getByRole('tab', { name: 'Spring' }).click();
  await page.getByLabel('Mass m', { exact: true }).fill('70 g');
  await page.getByRole('tab', { name: 'Mitigate' }).click();
  await expect(earlier).toBeVisible();
  // What was done on a tab is undone there.
  await page.getByRole('tab', { name: 'Spring' }).click();
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.getByRole('tab', { name: 'Mitigate' }).click();
  await expect(page.getByLabel('Most lag')).toHaveValue('40 deg');
  await expect(earlier).toBeHidden();
  await page.getByRole('button', { name: 'delay line', exact: true }).click();
  await expect.poll(() => decodeURIComponent(page.url())).toContain('candidate');
  const other = await context.newPage();
  await other.goto(page.url());
  await expect(other.getByLabel('Most lag')).toHaveValue('40 deg');
  const out = other.getByRole('region', { name: 'What comes out' });
  await expect(out.getByRole('heading')).toHaveText('delay line', { timeout: 100_000 });
  await other.close();
});

test('judging can be cancelled', async ({ page }) => {
  await page.goto(address());
  await page.getByRole('button', { name: 'Judge', exact: true }).click();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(page.locator(`${panel} [role=status]`).filter({ hasText: 'Cancelled.' })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Judge', exact: true })).toBeEnabled();
});

for (const [width, colorScheme] of typical([
  [375, 'dark'],
  [1280, 'light'],
  [2560, 'dark'],
] as const)) {
  test(`the tab fits ${width} pixels in ${colorScheme}, and axe finds nothing`, async ({ page }) => {
    await page.setViewportSize({ width, height: 900 });
    await page.emulateMedia({ colorScheme });
    const fine = async (state: string) => {
      expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), state).toBeLessThanOrEqual(
        0,
      );
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      await page.screenshot({ path: join(folder, `${state}-${width}-${colorScheme}.png`), fullPage: true });
    };
    await page.goto(address({ seeds: '1' }));
    await expect(page.getByLabel('Most lag')).toHaveAttribute('placeholder', '30 deg', { timeout: 20_000 });
    await fine('empty');
    await judge(page);
    await fine('judged');
    await page.getByText('Sampling, noise, tolerances').click();
    await page.getByLabel('Noise of').fill('loud');
    await expect(page.locator('#mitigate-noise-error')).toBeVisible();
    await fine('wrong');
    await page.getByLabel('Judge on').selectOption('log');
    await fine('log');
  });
}
