// Every mode of the coil: lines against length, the wire in space, what they say, and what they say where there is nothing to draw.
import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { typical } from './long';
import { openModes, settled } from './modes';
import { exact, expect, open, test } from './page';

/** What a canvas shows, as numbers that differ where the picture does. */
const picture = (page: Page, selector: string): Promise<string> =>
  page.locator(selector).evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());

test('lines, all modes and the wire are there once the part is opened, and not asked for before', async ({ page }) => {
  const asked: string[] = [];
  page.on('request', (request) => asked.push(request.url()));
  await open(page);
  expect(asked.filter((url) => /part-/.test(url))).toEqual([]);
  const part = await openModes(page);
  expect(asked.filter((url) => /part-.*js/.test(url))).toHaveLength(1);
  // S_T at 230 mm: two sideways modes, then surge and torsion, of which the surge is picked.
  await expect(part.locator('tr[aria-current], tr:has([aria-pressed=true])')).toHaveAttribute('data-kind', 'axial');
  const kinds = await part.locator('table.modes tbody tr').evaluateAll((all) => all.map((row) => row.dataset['kind']));
  expect(kinds.slice(0, 4)).toEqual(['lateral', 'lateral', 'axial', 'torsional']);
  await expect(part).toContainText('Driven along level lines: half resonance 27.0 Hz, resonance 54.1 Hz');
  await expect(part).toContainText('Driven at every frequency: heel strike, end stop max, end stop min');
  await expect(part).toContainText('Shaded: from ends held to ends free to tilt');
  await expect(part.locator('canvas[role=img]')).toHaveAccessibleName(
    /The wire of S_T at 230\.0 mm, ends held\. Mode 3, 54\.\d Hz, axial/,
  );
  await expect(part).toContainText(/Enlarged: the farthest point moves \d+ mm here/);
  await expect(part.locator('.reactions tbody tr')).toHaveCount(2);
});

test('a mode is picked in the table, on the chart and by keys, and the length by keys, too', async ({ page }) => {
  await open(page);
  const part = await openModes(page);
  const wire = part.locator('canvas[role=img]');
  await part.getByRole('button', { name: '60.7 Hz' }).click();
  await expect(wire).toHaveAccessibleName(/Mode 4, 60\.7 Hz, torsional/);
  const plot = part.locator('.plot.lengths');
  await plot.focus();
  await page.keyboard.press('ArrowDown');
  await expect(wire).toHaveAccessibleName(/Mode 3/);
  await page.keyboard.press('Home');
  await expect(wire).toHaveAccessibleName(/at 196\.0 mm/);
  await page.keyboard.press('ArrowRight');
  await expect(wire).toHaveAccessibleName(/at 197\.4 mm/);
  for (let step = 0; step < 5; step++) await page.keyboard.press('ArrowDown');
  await expect(wire).toHaveAccessibleName(/Mode 1,/);
  // The line of the first torsional mode, by the mouse.
  const over = plot.locator('.u-over');
  const box = (await over.boundingBox())!;
  await over.click({ position: { x: box.width / 2, y: box.height * (1 - 60.7 / (2.4 * 54.15)) } });
  await expect(wire).toHaveAccessibleName(/at 230\.0 mm, ends held\. Mode 4/);
});

test('the wire is turned by keys and by a drag, and stands still where that is asked for', async ({ page }) => {
  await open(page);
  const part = await openModes(page);
  await part.getByRole('button', { name: 'Hold still' }).click();
  const canvas = '.turntable canvas';
  const pictures = [await picture(page, canvas)];
  await part.locator('.turntable').focus();
  for (const key of ['ArrowLeft', 'ArrowUp']) {
    await page.keyboard.press(key);
    pictures.push(await picture(page, canvas));
  }
  const box = (await part.locator(canvas).boundingBox())!;
  await page.mouse.move(box.x + 100, box.y + 60);
  await page.mouse.down();
  await page.mouse.move(box.x + 180, box.y + 90, { steps: 4 });
  await page.mouse.up();
  pictures.push(await picture(page, canvas));
  expect(new Set(pictures).size).toBe(pictures.length);
  await page.waitForTimeout(300);
  expect(await picture(page, canvas)).toBe(pictures[pictures.length - 1]);
});

test('the wire stands still, bent as the mode is, where motion is not wanted', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page);
  const part = await openModes(page);
  const before = await picture(page, '.turntable canvas');
  await page.waitForTimeout(500);
  expect(await picture(page, '.turntable canvas')).toBe(before);
  await part.getByRole('button', { name: 'Move', exact: true }).click();
  await page.waitForTimeout(300);
  expect(await picture(page, '.turntable canvas')).not.toBe(before);
});

test('a coil that is no helix has no lines, and the part says why', async ({ page }) => {
  // Three windings of 8 mm are 183 mm of wire, shorter than the spring is to be.
  await open(page, '#S_T&spring.windings=3');
  await page.locator('.every summary').click();
  await expect(page.locator('.every')).toContainText(
    'The coil cannot be followed as a helix, so that nothing is drawn: ',
  );
  await expect(page.locator('.every .plot, .every canvas').filter({ visible: true })).toHaveCount(0);
  // With enough wire again all of it is there.
  await page.goto('./#S_T');
  await expect(page.locator('.every .plot')).toBeVisible();
});

test('where the spring buckles its lines end, and that is said', async ({ page }) => {
  await open(page, '#suspension&mount.ends_tilt=between');
  const part = await openModes(page);
  await expect(part).toContainText(/With ends free to tilt the spring buckles from \d+\.\d mm to \d+\.\d mm/);
  await part.getByRole('combobox').selectOption({ label: 'ends free to tilt' });
  await part.getByRole('slider', { name: 'Length' }).focus();
  await page.keyboard.press('Home');
  await expect(part.locator('table.modes caption')).toContainText('The spring buckles at this length');
});

test('it is said of which model the forces are', async ({ page }) => {
  await open(page);
  await expect(await openModes(page)).toContainText('The forces above are of the paper’s chain of masses');
  await open(page, '#valve');
  await expect(await openModes(page)).toContainText('has its first mode along the axis at 388.');
});

test('while what is typed cannot be computed, the last lines stay, in grey', async ({ page }) => {
  await open(page);
  const part = await openModes(page);
  const first = part.locator('table.modes tbody tr th').first();
  const before = await first.textContent();
  const mass = page.getByLabel('Mass m', { exact: true });
  await mass.fill('infinitely many g');
  await expect(page.locator('#spring-mass-error')).toBeVisible();
  await expect(part.locator('.every-mode')).toHaveClass(/stale/);
  await expect(first).toHaveText(before ?? '');
  await mass.fill('80 g');
  await exact(page);
  await settled(page);
  await expect(first).not.toHaveText(before ?? '');
});

for (const colorScheme of typical(['light', 'dark'] as const))
  test(`axe finds nothing in the opened part, in ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await open(page, '#suspension&mount.ends_tilt=between');
    await openModes(page);
    const { violations } = await new AxeBuilder({ page }).include('.every').analyze();
    expect(violations).toEqual([]);
  });

test('nothing of it is wider than a phone, and all of it is reached by Tab', async ({ page }) => {
  await page.setViewportSize({ width: 375, height: 812 });
  await open(page);
  const part = await openModes(page);
  expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
  await part.locator('summary').focus();
  const reached = new Set<string>();
  for (let step = 0; step < 24; step++) {
    await page.keyboard.press('Tab');
    const name = await page.evaluate(() => {
      const at = document.activeElement;
      return at?.closest('.every') ? (at.getAttribute('aria-label') ?? at.textContent ?? '') : '';
    });
    reached.add(name.replace(/:.*/, ''));
  }
  for (const name of ['Length', 'Ends', 'Hold still', 'Modes of the coil']) expect([...reached], name).toContain(name);
  expect([...reached].some((name) => name.startsWith('Frequencies of the modes over length'))).toBe(true);
  expect([...reached].some((name) => name.startsWith('The wire in space'))).toBe(true);
});
