// The page's exact numbers are the command's: both run the same engine, on two processors.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Deviation } from '../src/answer';
import { command, EXAMPLES, results, resultsOf, type Results } from './command';
import { moveTo, openModes } from './modes';
import { expect, exact, facts, open, series, test } from './page';

/** Of F_nom: sines and exponentials of two libraries differ in their last digits, and thousands of samples add up. */
const TOLERANCE = 1e-9;

const pairs = (page: Deviation, told: Results['cases'][number]['forces'][string]) => [
  [page.rmsd, told.rmsd_n],
  [page.maximum, told.maximum_n],
  [page.maximumAbsolute, told.maximum_absolute_n],
  [page.mean, told.mean_n],
];

for (const [preset, example] of Object.entries(EXAMPLES)) {
  test(`${preset}: every condition and damping gives the numbers of coilsense analyze ${example}.toml`, async ({
    page,
  }) => {
    test.slow();
    const { nominal_force_n: nominal, cases } = resultsOf(example);
    await open(page, `#${preset}`);
    const { conditions, dampings } = await facts(page);
    expect(cases.length).toBe(conditions.length * dampings.length);
    let worst = 0;
    for (const [number, told] of cases.entries()) {
      const [condition, damping] = [Math.floor(number / dampings.length), number % dampings.length];
      await page.evaluate((hash) => (location.hash = hash), `#${preset}&@condition=${condition}&@damping=${damping}`);
      await page.waitForFunction(
        ([c, d]) =>
          window.coilsense.last()?.exact?.facts.condition === c && window.coilsense.last()?.exact?.facts.damping === d,
        [condition, damping],
      );
      const found = await facts(page);
      expect([found.conditions[condition]?.name, found.dampings[damping]?.label]).toEqual([
        told.condition,
        told.damping,
      ]);
      for (const [force, deviation] of Object.entries(found.forces)) {
        for (const [here = NaN, there = NaN] of pairs(deviation, told.forces[force]!))
          worst = Math.max(worst, Math.abs(here - there) / nominal);
      }
      expect(found.sensors.map(({ name }) => name)).toEqual(told.sensors.map(({ sensor }) => sensor));
      for (const [index, { deviation }] of found.sensors.entries()) {
        for (const [here = NaN, there = NaN] of pairs(deviation, told.sensors[index]!.deviation))
          worst = Math.max(worst, Math.abs(here - there) / nominal);
      }
      expect(worst, `${told.condition}, ${told.damping}`).toBeLessThan(TOLERANCE);
      expect(
        Math.abs(found.lengths[0] - told.shortest_length_m) + Math.abs(found.lengths[1] - told.longest_length_m),
      ).toBeLessThan(1e-12);
      expect(found.clash.firstContact === null).toBe(told.first_contact_s === null);
      // Bisected to 1e-12 s.
      if (told.first_contact_s !== null)
        expect(Math.abs((found.clash.firstContact ?? 0) - told.first_contact_s)).toBeLessThan(1e-9);
    }
    console.log(`${preset}: ${cases.length} cases, largest difference ${worst.toExponential(1)} of F_nom`);
  });
}

test('the spec taken along gives the command the same numbers, and the CSV is the command’s', async ({
  page,
}, info) => {
  await open(page, '#S_T&spring.mass=80+g&mount.damping_ratio=0.003');
  const [spec] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Spec (TOML)' }).click(),
  ]);
  const [file, folder, csv] = [info.outputPath('mine.toml'), info.outputPath('analysis'), info.outputPath('mine.csv')];
  await spec.saveAs(file);
  command('analyze', file, '--out', folder);
  const told = results(folder);
  const found = await facts(page);
  for (const [force, deviation] of Object.entries(found.forces)) {
    for (const [here = NaN, there = NaN] of pairs(deviation, told.cases[0]!.forces[force]!))
      expect(Math.abs(here - there) / told.nominal_force_n).toBeLessThan(TOLERANCE);
  }
  const [table] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Series (CSV)' }).click(),
  ]);
  await table.saveAs(csv);
  command('simulate', file, '--out', join(folder, 'signals.csv'));
  const read = (path: string) =>
    readFileSync(path, 'utf8')
      .trim()
      .split('\n')
      .map((line) => line.split(','));
  const [mine, theirs] = [read(csv), read(join(folder, 'signals-heel-strike-zeta-0.003.csv'))];
  expect(mine[0]).toEqual(theirs[0]);
  expect(mine.length).toBe(theirs.length);
  for (const name of ['time [s]', 'F_i [N]', 'F_o [N]', 'F_x [N]', 'F_L [N]']) {
    const column = theirs[0]!.indexOf(name);
    expect(column, name).toBeGreaterThanOrEqual(0);
    const worst = mine
      .slice(1)
      .reduce(
        (most, row, index) => Math.max(most, Math.abs(Number(row[column]) - Number(theirs[index + 1]![column]))),
        0,
      );
    expect(worst / told.nominal_force_n, name).toBeLessThan(TOLERANCE);
  }
});

test('a preview is the exact curve but for F_L, which is good to what its second order leaves', async ({ page }) => {
  // A view whose times the exact case has, too.
  await open(page, '#S_T&@times=[0,0.1]');
  const names = ['time', 'F_i', 'F_o', 'F_L'];
  const preview = await page.evaluate(async (names) => {
    const slider = document.querySelector<HTMLInputElement>('input[aria-label="How hard it is hit, slider"]')!;
    slider.value = '500';
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    while (window.coilsense.last()?.exact !== null) await new Promise(requestAnimationFrame);
    return Object.fromEntries(names.map((name) => [name, [...(window.coilsense.last()?.answer.series[name] ?? [])]]));
  }, names);
  await exact(page);
  const full = Object.fromEntries(
    await Promise.all(names.map(async (name) => [name, await series(page, name)] as const)),
  );
  const at = (time: number) => full['time']!.findIndex((other) => Math.abs(other - time) < 1e-9);
  let compared = 0;
  preview['time']!.forEach((time, index) => {
    const same = at(time);
    if (same < 0) return;
    compared++;
    expect(Math.abs(preview['F_i']![index]! - full['F_i']![same]!)).toBeLessThan(1e-6);
    expect(Math.abs(preview['F_o']![index]! - full['F_o']![same]!)).toBeLessThan(1e-6);
    // 1e-7 of L (book: theory, section 1) is 1e-5 of F_nom.
    expect(Math.abs(preview['F_L']![index]! - full['F_L']![same]!)).toBeLessThan(2e-3);
  });
  expect(compared).toBeGreaterThan(500);
});

test('Tables II and III of the tab Paper are the reproduction’s', async ({ page }, info) => {
  const folder = info.outputPath('paper');
  command('reproduce', '--out', folder);
  await open(page);
  await page.getByRole('tab', { name: 'Paper' }).click();
  await expect(page.locator('.paper[aria-busy=false]')).toBeVisible({ timeout: 60_000 });
  const shown = await page.locator('.tables tbody td:not(.printed)').allTextContents();
  const cells = JSON.parse(readFileSync(join(folder, 'tables.json'), 'utf8')) as {
    tables_percent: number;
    text_percent: number;
  }[];
  expect(cells.length).toBe(60);
  const told = cells
    .flatMap((cell) => [cell.tables_percent, cell.text_percent])
    // No minus sign stands before a zero.
    .map((percent) =>
      percent
        .toFixed(2)
        .replace(/^-(?=[0.]+$)/, '')
        .replace('-', '−'),
    );
  expect(shown.map((text) => text.replace(' differs', ''))).toEqual(told);
});

test('the modes of the coil are those of the data sheet, at every length and with either ends', async ({ page }) => {
  for (const [preset, example] of [
    ['valve', 'valve-spring'],
    ['S_T', 'sea-ankle'],
  ] as const) {
    await open(page, `#${preset}`);
    const told = resultsOf(example).spring.modes_at;
    const part = await openModes(page);
    const rows = part.locator('table.modes tbody tr');
    for (const [number, at] of told.entries()) {
      await moveTo(page, number / (told.length - 1));
      const ways = [at, ...(at.loosest ? [at.loosest] : [])];
      for (const [way, { modes, ends }] of ways.entries()) {
        if (ways.length > 1) await part.getByRole('combobox').selectOption({ index: way });
        await expect(part.locator('table.modes caption')).toContainText(ends);
        const frequencies = modes.slice(0, 10).map(({ frequency_hz }) => `${frequency_hz.toFixed(1)} Hz`);
        await expect(rows.locator('th')).toHaveText(frequencies);
        const kinds = await rows.evaluateAll((all) => all.map((row) => row.getAttribute('data-kind')));
        expect(kinds).toEqual(modes.slice(0, 10).map(({ kind }) => kind));
      }
    }
  }
});
