// The speed of a recorded motion: a slider that every such condition has, and the curve of how far forces are off over it, which are the command's numbers.
import { writeFileSync } from 'node:fs';
import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import type { At } from '../src/speeds/points';
import { command, results } from './command';
import { exact, expect, facts, open, test } from './page';

const card = (page: Page) => page.locator('section.speeds-of');
const slider = (page: Page) => page.getByRole('slider', { name: 'Speed of the recording, slider' });
const address = (page: Page) => decodeURIComponent(new URL(page.url()).hash);

/** Opens the curve, and waits until it is whole. */
async function curve(page: Page): Promise<At[]> {
  await card(page).locator('summary').click();
  const body = card(page).locator('.over-speed');
  await expect(body).toHaveAttribute('aria-busy', 'false', { timeout: 100_000 });
  return JSON.parse((await body.getAttribute('data-points')) ?? '[]') as At[];
}

test('a recorded cycle has a slider of its speed, which keeps the turns that are judged; no other condition has one', async ({
  page,
}) => {
  await open(page, '#valve&@condition=1');
  const before = await facts(page);
  await expect(slider(page)).toHaveAttribute('aria-valuetext', '100 %');
  await slider(page).focus();
  await page.keyboard.press('End');
  await exact(page);
  await expect(slider(page)).toHaveAttribute('aria-valuetext', '160 %');
  const after = await facts(page);
  const [from, to] = before.conditions[1]!.window;
  expect(after.conditions[1]!.window[0]).toBeCloseTo(from / 1.6, 12);
  expect(after.conditions[1]!.window[1]).toBeCloseTo(to / 1.6, 12);
  expect(address(page)).toContain('condition.1.playback_speed=160+%');
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await exact(page);
  expect((await facts(page)).conditions[1]!.window).toEqual([from, to]);
  // A number as people type it, and one that no recording is played at.
  const field = page.locator('#condition-1-playback_speed');
  await field.fill('80');
  await field.blur();
  await exact(page);
  await expect(field).toHaveValue('80 %');
  await field.fill('0 %');
  await expect(page.locator('#condition-1-playback_speed-error')).toContainText('must be from 1 to 10000 %');
  await open(page, '#S_T');
  await expect(slider(page)).toHaveCount(0);
  await expect(card(page)).toBeHidden();
});

test('the curve over speed is whole, peaks included, and is of the command’s numbers', async ({ page }, info) => {
  test.slow();
  await open(page, '#valve&mount.damping_ratio=0.01');
  const points = await curve(page);
  const { forces, spring } = await facts(page);
  expect(Math.min(...points.map(({ speed }) => speed))).toBeCloseTo(0.4, 9);
  expect(Math.max(...points.map(({ speed }) => speed))).toBeCloseTo(1.6, 9);
  const of = (at: At) => at.off['F_o'] ?? 0;
  const most = points.reduce((a, b) => (of(b) > of(a) ? b : a));
  console.log(`${points.length} speeds, worst at ${most.speed}: ${of(most)}`);
  await expect(card(page).locator('.live')).toContainText('of the recorded speed');
  // The neighbours of the worst are near to it: the peak is seen as it is.
  const order = points.map(({ speed }) => speed);
  const place = order.indexOf(most.speed);
  for (const near of [points[place - 1], points[place + 1]]) expect(of(most) / of(near!)).toBeLessThan(1.1);
  // Numbers of the command, at the worst speed and at one more.
  for (const at of [most, points[3]!]) {
    const [spec] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Spec (TOML)' }).click(),
    ]);
    await spec.saveAs(info.outputPath('mine.toml'));
    const { readFileSync } = await import('node:fs');
    const speed = `playback_speed = "${Number((100 * at.speed).toPrecision(12))} %"`;
    const text = readFileSync(info.outputPath('mine.toml'), 'utf8').replace(/(name = "first turns"\n)/, `$1${speed}\n`);
    expect(text).toContain(speed);
    writeFileSync(info.outputPath('faster.toml'), text);
    writeFileSync(info.outputPath('cam-6000rpm.csv'), readFileSync('../examples/cam-6000rpm.csv'));
    command('analyze', info.outputPath('faster.toml'), '--overwrite', '--out', info.outputPath('analysis'));
    const told = results(info.outputPath('analysis')) as unknown as {
      cases: { condition: string; forces: Record<string, { rmsd_n: number }> }[];
    };
    const there = told.cases.find(({ condition }) => condition === 'first turns')!.forces['F_o']!.rmsd_n;
    expect(Math.abs((of(at) * spring.nominalForce) / there - 1)).toBeLessThan(1e-9);
  }
  expect(forces['F_o']!.rmsd).toBeGreaterThan(0);
  const { violations } = await new AxeBuilder({ page }).include('.speeds-of').analyze();
  expect(violations).toEqual([]);
});

test('a click on the curve takes that speed, the curve stays, and another spring asks anew', async ({ page }) => {
  test.slow();
  await open(page, '#valve&mount.damping_ratio=0.01');
  const points = await curve(page);
  const over = card(page).locator('.u-over');
  const box = (await over.boundingBox())!;
  await over.click({ position: { x: 0.25 * box.width, y: 0.5 * box.height } });
  await expect.poll(() => address(page)).toMatch(/playback_speed=(69\.\d|7[01](\.\d)?)\+%/);
  await exact(page);
  const body = card(page).locator('.over-speed');
  await expect(body).toHaveAttribute('aria-busy', 'false', { timeout: 1000 });
  expect(JSON.parse((await body.getAttribute('data-points')) ?? '[]')).toEqual(points);
  await page.getByRole('slider', { name: /^Wire diameter d, slider/ }).focus();
  await page.keyboard.press('PageUp');
  await exact(page);
  await expect(body).toHaveAttribute('aria-busy', 'true');
});

test('the worst is told of speeds at which no windings pass through one another', async ({ page }) => {
  test.slow();
  await open(page, '#valve&mount.damping_ratio=0.01');
  const points = await curve(page);
  const worst = (of: At[]) => of.reduce((a, b) => ((b.off['F_o'] ?? 0) > (a.off['F_o'] ?? 0) ? b : a));
  const free = points.filter(({ touch }) => !touch);
  // Beyond contact it is larger by far: that is no force of a coil.
  expect(free.length).toBeLessThan(points.length);
  expect(worst(free).off['F_o']! / worst(points).off['F_o']!).toBeLessThan(0.9);
  await expect(card(page).locator('.live')).toContainText(
    `at ${Number((100 * worst(free).speed).toFixed(1))}\u00a0%, the worst of the speeds at which no windings touch`,
  );
  await expect(card(page).locator('.about')).toContainText('speeds at which windings would touch');
});
