// The simulated log: a new user's first look, and what was put into it comes out again.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { expect, test } from './page';
import { apart, saved } from './jobs';
import { folder, rigLogs, settled, told, type, written } from './logs';

test.beforeAll(rigLogs);

const tried = async (page: Page, hash = '#S_T&@tab="log"') => {
  await page.goto(`./${hash}`);
  await page.getByRole('button', { name: 'Try it with a simulated log' }).click();
  await expect(page.locator('#panel-log .verdict')).toBeVisible({ timeout: 60_000 });
  await settled(page);
};

test('a new user sees what to drop, and a simulated log gives the spring of the page back', async ({ page }) => {
  await page.goto('./#S_T&@tab="log"');
  await expect(page.getByRole('region', { name: 'What a log tells' })).toContainText('Nothing leaves this browser');
  await tried(page);
  await expect(page.locator('#panel-log .verdict')).toContainText('spring: ');
  await expect(page.getByRole('region', { name: 'What became of the rows' })).toContainText('Simulated data');
  const found = JSON.parse(await saved(page, 'Everything (JSON)')) as Record<
    string,
    { value: number; low: number; high: number }
  >;
  // S_T of Table I: what was put in lies within a thousandth of what came out.
  const near = (name: string, truth: number) =>
    expect(Math.abs((found[name]?.value ?? NaN) / truth - 1), name).toBeLessThan(1e-3);
  near('stiffness_n_per_m', 760);
  near('mass_kg', 0.065);
  near('length_at_zero_force_m', 0.104);
  expect(Math.abs((found['damping_ratio']?.value ?? 0) / 0.005 - 1)).toBeLessThan(0.02);
});

test('what was identified opens in the tab Spring, and is the spec that the command writes', async ({ page }) => {
  await tried(page);
  const text = await saved(page, 'Save the simulated log (CSV)');
  expect(text).toMatch(/^# Simulated data: /);
  written('simulated-S_T.csv', text);
  await expect(page.getByRole('region', { name: 'The spring', exact: true })).toContainText(
    'tell windings, radius and wire',
  );
  await type(page, 'The spring', 'Active windings', '52');
  await type(page, 'The spring', 'Coil radius', '8 mm');
  await type(page, 'The spring', 'Wire diameter', '2 mm');
  const button = page.getByRole('button', { name: 'Open this spring in the tab Spring' });
  await expect(button).toBeVisible({ timeout: 30_000 });
  await settled(page);
  const spec = await saved(page, 'Download the spec (TOML)');
  const by = ['--windings', '52', '--radius', '8 mm', '--wire', '2 mm'];
  const json = told('identify', 'simulated-S_T.csv', ...by, '--spec-out', 'found.toml', '--json');
  // Fits end where steps become small: the numbers in the spec have six digits and more, and are the same to the last but one.
  const numbers = (text: string) => text.split(/(-?\d+(?:\.\d+)?(?:e-?\d+)?)/);
  const [here, there] = [numbers(spec), numbers(readFileSync(join(folder, 'found.toml'), 'utf8'))];
  expect(here.filter((_, index) => index % 2 === 0)).toEqual(there.filter((_, index) => index % 2 === 0));
  here.forEach((part, index) => {
    if (index % 2)
      expect(Math.abs(Number(part) - Number(there[index]))).toBeLessThanOrEqual(1e-5 * Math.abs(Number(there[index])));
  });
  expect(apart(JSON.parse(await saved(page, 'Everything (JSON)')), JSON.parse(json))).toBeLessThan(1e-7);
  await button.click();
  await expect(page.getByRole('tab', { name: 'Spring' })).toHaveAttribute('aria-selected', 'true');
  await page.waitForFunction(() => window.coilsense.last()?.exact?.facts.spring.name === 'identified', null, {
    timeout: 30_000,
  });
  const stiffness = await page.evaluate(() => window.coilsense.last()?.exact?.facts.spring.stiffness ?? 0);
  expect(Math.abs(stiffness / 760 - 1)).toBeLessThan(1e-3);
  await expect(page.locator('#panel-spring .refusal:visible')).toHaveCount(0);
});

test('the page’s spring predicts f1, as a spec does for the command', async ({ page }) => {
  await tried(page);
  written('simulated-S_T.csv', await saved(page, 'Save the simulated log (CSV)'));
  await page.locator('#panel-log summary', { hasText: 'The spring' }).click();
  await page.getByLabel('It is', { exact: true }).selectOption('tab');
  await expect(page.getByRole('button', { name: 'Open this spring in the tab Spring' })).toBeVisible({
    timeout: 30_000,
  });
  await settled(page);
  const spec = join(new URL('..', import.meta.url).pathname, '..', 'examples', 'sea-ankle.toml');
  const there = JSON.parse(told('identify', 'simulated-S_T.csv', '--spec', spec, '--json')) as unknown;
  expect(apart(JSON.parse(await saved(page, 'Everything (JSON)')), there)).toBeLessThan(1e-7);
  expect(decodeURIComponent(page.url())).toContain('@log={"spring":"tab"}');
});
