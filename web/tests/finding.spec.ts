// What somebody sees who has never seen the page: the headline is what the curves show, each thing has one name, and each card says what it is of.
import type { Page } from '@playwright/test';
import { ready } from './hits';
import { expect, facts, MOVING, open, series, test } from './page';

test.use(MOVING);

/** How far the ends are apart at most, and by how much k × stretch changes, over the shown times [N]. */
async function seen(page: Page): Promise<{ apart: number; swing: number }> {
  const times = await page.evaluate(() => window.coilsense.last()!.times);
  const [time = [], one = [], two = [], length = []] = await Promise.all(
    ['time', 'F_i', 'F_o', 'F_x'].map((name) => series(page, name)),
  );
  const shown = time.map((_, at) => at).filter((at) => time[at]! >= times[0] && time[at]! <= times[1]);
  const most = (of: (at: number) => number) => shown.reduce((most, at) => Math.max(most, of(at)), -Infinity);
  return {
    apart: most((at) => Math.abs(one[at]! - two[at]!)),
    swing: most((at) => length[at]!) + most((at) => -length[at]!),
  };
}
const two = (value: number) => String(Number(value.toPrecision(2)));

test('the headline is what the curves show: a hit, of which the length tells nothing', async ({ page }) => {
  await open(page, '#S_T');
  const { apart, swing } = await seen(page);
  const { spring, lines, forces } = await facts(page);
  expect(swing / apart).toBeLessThan(1e-3);
  const finding = page.locator('#sentence .finding');
  await expect(finding).toHaveText(
    `After “heel strike” the forces at the two ends differ by up to ${two(apart)}\u00a0N, ` +
      `${two((100 * apart) / spring.nominalForce)}\u00a0% of Fnom = ${spring.nominalForce.toPrecision(4)}\u00a0N; ` +
      `k × stretch shows none of this ringing (${lines[0]!.toPrecision(3)}\u00a0Hz).`,
  );
  const rms = ((100 * forces['F_o']!.rmsd) / spring.nominalForce).toPrecision(3);
  await expect(page.locator('#sentence .finer')).toHaveText(
    `ζ = 0, first 111\u00a0ms. Over 0.75–1\u00a0s a load cell at end 2 is off from k × stretch by ${rms}\u00a0% of Fnom, rms.`,
  );
});

test('where the driven end moves, k × stretch is not said to be still; a force at an end is named as the true one', async ({
  page,
}) => {
  await open(page, '#valve');
  const { apart, swing } = await seen(page);
  expect(swing).toBeGreaterThan(0.1 * apart);
  const sentence = page.locator('#sentence');
  await expect(sentence).toContainText('In “first turns” the forces');
  await expect(sentence).toContainText(`k × stretch itself changes by ${two(swing)}\u00a0N.`);
  await expect(sentence).not.toContainText('none of this');
  await expect(sentence).toContainText('a load cell at end 2 is off from the force at end 1 by ');
});

test('without a hit there is nothing to tell apart, and windings that touch do not ring at a frequency', async ({
  page,
}) => {
  await open(page, '#S_T&condition.0.velocity=0+m/s');
  await expect(page.locator('.finding')).toContainText('the forces at the two ends are the same');
  await page.goto('about:blank');
  await open(page, '#S_A&@condition=4');
  await expect(page.locator('.finding')).toContainText('Windings touch: a real coil would do something else.');
  await expect(page.locator('.finding')).not.toContainText('ringing');
});

test('the verdict says what it covers, and leads to the warnings and to the force taken as true', async ({ page }) => {
  await open(page, '#S_T');
  const card = page.getByRole('region', { name: 'Which sensor to trust', exact: true });
  await expect(card.locator('.answer')).toBeVisible({ timeout: 60_000 });
  const { conditions, dampings, warnings } = await facts(page);
  await expect(card.locator('.scope')).toHaveText(
    `Over all ${conditions.length} conditions, all ${dampings.length} dampings and the tolerances of this spring, not only “heel strike”, ζ = 0.`,
  );
  // Those of two load cells that differ in the name are one.
  const shown = page.locator('.warnings li');
  expect(await shown.count()).toBe(warnings.length - 1);
  await expect(shown.first()).toContainText('load cell, motor side, and load cell, load side: 17 surge lines');
  await expect(card.locator('.heed')).toContainText(`${warnings.length - 1} warnings: folded down by sampling;`);
  await card.getByRole('button', { name: 'Read them' }).click();
  await expect(page.locator('.rely')).toBeFocused();
  await expect(page.locator('.rely')).toBeInViewport();
  await card.getByRole('button', { name: 'Change it' }).click();
  await expect(page.locator('#goal-force')).toBeFocused();
  // The case that is drawn is another; the verdict is the same.
  await page.locator('#condition').selectOption({ label: 'resonance' });
  await expect(card.locator('.scope')).toContainText('not only “resonance”');
  await expect(page.locator('.off caption')).toContainText(
    'This “resonance”, ζ = 0, 0.75–1\u00a0s: off from k × stretch',
  );
});

test('the sensors of the drawn case stand in the order of the verdict', async ({ page }) => {
  await open(page, '#S_T');
  await page.waitForFunction(() => window.coilsense.verdict() !== null, null, { timeout: 60_000 });
  const ranked = await page.locator('.ranking tr[data-sensor] th').allTextContents();
  expect(ranked).toHaveLength(5);
  const own = await page.locator('.off tr[data-force] th').allTextContents();
  expect(own).toEqual(['End 1 (Fi)', 'End 2 (Fo)', 'k × stretch (Fx)', 'inductance (FL)', ...ranked]);
});

test('the key stands above the curves, on a phone on one line, and says which of them are one', async ({ page }) => {
  for (const [width, height] of [
    [1280, 800],
    [390, 844],
    [375, 812],
  ] as const) {
    await page.setViewportSize({ width, height });
    await open(page, '#S_T');
    const key = (await page.locator('.keys').boundingBox())!;
    const plot = (await page.locator('.plot.forces').boundingBox())!;
    expect(key.y + key.height).toBeLessThanOrEqual(plot.y);
    expect(key.height, `${width}`).toBeLessThan(30);
    await page.goto('about:blank');
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  await open(page, '#S_T');
  await expect(page.locator('.keys')).toContainText(/k × stretch \(Fx\).*inductance \(FL\) both9\d\.\d N/);
  // An inductance that is not drawn is not one with anything.
  await page.locator('tr[data-force=F_L] button').click();
  await expect(page.locator('.keys')).toContainText(/k × stretch \(Fx\)9\d\.\d N/);
});

test('the buttons say their times, and which are shown', async ({ page }) => {
  await open(page, '#S_T');
  const pressed = page.locator('.views [aria-pressed=true]');
  await expect(pressed).toHaveText('0–111\u00a0ms (ringing)');
  await page.getByRole('button', { name: '0.75–1\u00a0s (judged)' }).click();
  await expect(pressed).toHaveText('0.75–1\u00a0s (judged)');
  await page.getByRole('button', { name: '0–1\u00a0s (all)' }).click();
  await expect(pressed).toHaveText('0–1\u00a0s (all)');
  await page.getByRole('button', { name: '+', exact: true }).click();
  await expect(pressed).toHaveCount(0);
});

test('a phone shows four columns of the verdict, and all of them on request', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, '#S_T');
  const table = page.getByRole('region', { name: 'Every sensor’s uncertainty' });
  await expect(table).toBeVisible({ timeout: 60_000 });
  const heads = table.locator('thead th:visible');
  await expect(heads).toHaveCount(4);
  expect(await table.evaluate((one) => one.scrollWidth - one.clientWidth)).toBeLessThanOrEqual(1);
  await table.getByRole('button', { name: 'More or fewer columns' }).click();
  await expect(heads).toHaveCount(9);
});

test('the wave is drawn before anybody scrolls to it, with the way of a wave on every page', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, '#S_T');
  await ready(page);
  const canvas = page.locator('.strip canvas');
  await expect(canvas).not.toBeInViewport();
  const dark = () =>
    canvas.evaluate((one: HTMLCanvasElement) => {
      const { width, height } = one;
      if (width <= 54) return 0;
      // Within the frame: what is nearly black is the dashed line.
      const copy = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d')!;
      copy.drawImage(one, 0, 0);
      const { data } = copy.getImageData(47, 19, width - 56, height - 60);
      let count = 0;
      for (let at = 0; at < data.length; at += 4) if (data[at]! + data[at + 1]! + data[at + 2]! < 150) count++;
      return count;
    });
  await expect.poll(dark).toBeGreaterThan(200);
  // Far from the blow it is there, too.
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.getByRole('slider', { name: 'Time', exact: true }).fill('900');
  await page.locator('.strip').scrollIntoViewIfNeeded();
  await expect.poll(dark).toBeGreaterThan(200);
});

test('the finding is one and the same on a phone and on a desk', async ({ browser }) => {
  const said = async (width: number, height: number) => {
    const context = await browser.newContext({ viewport: { width, height }, serviceWorkers: 'block' });
    const page = await context.newPage();
    await open(page, '#S_T');
    const text = await page.locator('#sentence').textContent();
    await context.close();
    return text;
  };
  expect(await said(390, 844)).toBe(await said(1280, 800));
});
