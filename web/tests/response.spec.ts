// The two ends over frequency: numbers of the command's own matrices, a dot that follows slider, field, buttons and pointer, and what is said where
// there is no limit, no ratio or no such curve.
import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { EXAMPLES } from './command';
import { typical } from './long';
import { exact, expect, facts, open, test } from './page';
import { divided, exported, forcesOf, go, openResponse, phase, pointAt, settled, size } from './response';

const slider = (page: Page) => page.locator('.two-ends').getByRole('slider', { name: 'Frequency, slider' });
const shown = async (page: Page) =>
  Number(
    (JSON.parse((await page.locator('.over-frequency').getAttribute('data-point')) ?? '{}') as { frequency: number })
      .frequency,
  );

/** Of the second damping of a preset, where it has several: with one, no number is without limit. */
const RATIOS: Record<keyof typeof EXAMPLES, [number, number | null]> = {
  S_T: [2, 0.005],
  S_A: [1, 0.001],
  valve: [1, 0.01],
  suspension: [0, null],
};
for (const preset of typical(Object.keys(EXAMPLES) as (keyof typeof EXAMPLES)[]))
  test(`sizes, phases and the limit of ${preset} are those of the command’s matrices`, async ({ page }) => {
    const [damping, ratio] = RATIOS[preset];
    const plant = exported(preset, ratio);
    await open(page, `#${preset}&@damping=${damping}`);
    await openResponse(page);
    const { spring } = await facts(page);
    // The same chain: end masses have a mode more.
    expect(plant.kept_modes - spring.masses * spring.massesPerWinding).toBe(preset === 'suspension' ? 1 : 0);
    for (const share of [0.031, 0.25, 0.4998, 0.77, 1.001, 1.63, 3.1]) {
      const frequency = Number((share * spring.surgeFrequency).toPrecision(4));
      const found = await go(page, frequency);
      const [first = [0, 0], last = [0, 0], stretch = [0, 0]] = forcesOf(plant, frequency);
      for (const [told, ratio] of [
        [found.through, divided(last, first)],
        [found.lengthOverOwn, divided(stretch, first)],
        [found.own, divided(first, [spring.stiffness, 0])],
      ] as const) {
        expect(Math.abs((told?.[0] ?? NaN) / size(ratio) - 1), `${preset} at ${frequency} Hz`).toBeLessThan(1e-9);
        expect(Math.abs(Math.sin((told?.[1] ?? NaN) - phase(ratio)))).toBeLessThan(1e-9);
      }
    }
    // Up to the limit one percent is kept, and not beyond.
    const words = (await page.locator('.two-ends .live b').last().textContent()) ?? '';
    const limit = Number(/up to ([\d.]+)/.exec(words)?.[1]);
    const off = (frequency: number) => {
      const [first = [0, 0], last = [0, 0]] = forcesOf(plant, frequency);
      const [re, im] = divided(last, first);
      return Math.hypot(re - 1, im);
    };
    // Four digits are told.
    expect(off(0.999 * limit)).toBeLessThan(0.01);
    expect(off(1.001 * limit)).toBeGreaterThan(0.01);
  });

test('nothing of it is loaded before it is opened; then the dot follows slider, keys, buttons and the pointer', async ({
  page,
}) => {
  await open(page, '#S_T&@damping=2');
  const part = await openResponse(page);
  const before = await shown(page);
  await slider(page).focus();
  await page.keyboard.press('ArrowRight');
  await expect.poll(() => shown(page)).toBeGreaterThan(before);
  const near = await shown(page);
  expect(near / before).toBeLessThan(1.02);
  await expect(slider(page)).toHaveAttribute('aria-valuetext', new RegExp(`^${near}\u00a0Hz: F_o is ×[\\d.]+ F_i$`));
  await expect(part.locator('.live')).toContainText(`At ${near}\u00a0Hz a load cell at end 2 shows ×`);
  await page.keyboard.press('End');
  // 4.2 surge frequencies.
  await expect.poll(() => shown(page)).toBeGreaterThan(4.1 * 54);
  await part.getByRole('button', { name: /^peak 27\.03/ }).click();
  await pointAt(page, 27.03);
  await expect(part).toContainText('all but vanishes here');
  await part.getByRole('button', { name: /^mode 54\.06/ }).click();
  await pointAt(page, 54.06);
  await expect(part).toContainText('The coil rings here');
  const over = part.locator('.u-over');
  const box = (await over.boundingBox())!;
  await over.click({ position: { x: 0.5 * box.width, y: 0.5 * box.height } });
  // Half way on a logarithmic axis from 0.02 to 4.2 surge frequencies: 0.3 of them.
  await expect.poll(async () => Math.round(await shown(page))).toBe(16);
});

test('the dot is drawn where the frequency is', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, '#S_T&@damping=2');
  const part = await openResponse(page);
  const picture = () => part.locator('.plot canvas').evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
  await go(page, 5);
  const one = await picture();
  await go(page, 50);
  const two = await picture();
  await go(page, 5);
  expect(two).not.toBe(one);
  await expect.poll(picture).toBe(one);
});

test('the dot is there before the engine answers, and stays where it answers', async ({ page }) => {
  await open(page, '#suspension');
  const part = await openResponse(page);
  // The answer is a task of its own, which comes after all of this.
  const [moved, waits] = await part.evaluate(async (part) => {
    const canvas = part.querySelector<HTMLCanvasElement>('.plot canvas')!;
    const slider = part.querySelector<HTMLInputElement>('input[type=range]')!;
    const point = () => part.querySelector<HTMLElement>('.over-frequency')!.dataset['point'];
    const [before, told] = [canvas.toDataURL(), point()];
    slider.value = '300';
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    for (let turn = 0; turn < 5; turn++) await Promise.resolve();
    return [canvas.toDataURL() !== before, point() === told];
  });
  expect([moved, waits]).toEqual([true, true]);
  // 0.35 to 213 Hz in equal factors: 300 of 1000 steps.
  await expect.poll(() => shown(page)).toBeCloseTo(2.4, 0);
});

test('what is typed is understood with commas and kilohertz, and refused beyond the curve', async ({ page }) => {
  await open(page);
  const part = await openResponse(page);
  const field = part.getByRole('textbox', { name: 'Frequency' });
  for (const [typed, taken] of [
    ['12,5', 12.5],
    ['0.1 kHz', 100],
    ['33 Hz', 33],
  ] as const) {
    await field.fill(typed);
    await field.press('Enter');
    await pointAt(page, taken);
  }
  for (const wrong of ['soon', '-3 Hz', '0', '9999 Hz', '20 N']) {
    await field.fill(wrong);
    await field.press('Enter');
    await expect(part.getByText(/^A frequency from 1\.081\u00a0Hz to 227\.1\u00a0Hz\.$/)).toBeVisible();
    await expect(field).toHaveAttribute('aria-invalid', 'true');
    expect(await shown(page)).toBe(33);
  }
  await field.fill('40 Hz');
  await field.press('Enter');
  await expect(field).toHaveAttribute('aria-invalid', 'false');
});

test('a link opens at its frequency, the tour has one, and one that cannot be is put where the curve ends', async ({
  page,
}) => {
  await open(page, '#S_T&@damping=2&@frequency=20.5');
  await settled(page);
  await pointAt(page, 20.5);
  await slider(page).focus();
  await page.keyboard.press('ArrowRight');
  await expect.poll(() => page.url()).toMatch(/@frequency=20\.58/);
  await open(page, '#S_A&@frequency=1e9');
  await page.reload();
  await exact(page);
  await settled(page);
  // 4.2 times 168.6 Hz.
  await expect.poll(() => shown(page)).toBeCloseTo(4.2 * 168.63, -1);
  for (const wrong of ['-3', '"x"', 'null', '[1]']) {
    await page.goto('about:blank');
    await open(page, `#S_T&@frequency=${wrong}`);
    await expect(page.locator('.two-ends details')).not.toHaveAttribute('open', '');
  }
  await page.goto('about:blank');
  await open(page, '#S_T');
  await page.getByText('Why the ends disagree, in four steps').click();
  await page.getByRole('link', { name: 'See it over frequency, at 27.03' }).click();
  await settled(page);
  await pointAt(page, 27.03);
  await expect(page.locator('.two-ends summary')).toBeInViewport();
});

test('without damping no number stands for what has no limit', async ({ page }) => {
  await open(page, '#S_T&@damping=0');
  const part = await openResponse(page);
  await expect(part.locator('.about')).toContainText('ζ = 0: the peaks have no top');
  // The peak to all of its digits.
  await part.getByRole('button', { name: /^peak 27\.03/ }).click();
  await pointAt(page, 27.03);
  await expect(part.locator('.live')).toContainText('times Fi');
  await expect(part).not.toContainText(/NaN|Infinity|undefined|null/);
  await open(page, '#S_T&@damping=2');
  await page.reload();
  await exact(page);
  await openResponse(page);
  await expect(part.locator('.about')).not.toContainText('no top');
});

test('end 2 under a force is what is pulled, and on a mass the ratio does not begin at 1', async ({ page }) => {
  await open(page, '#S_T&mount.end2=force&control.load_mass=1+kg&@damping=2');
  const part = await openResponse(page);
  await expect(part.locator('.live')).toContainText('a load cell at end 1 shows');
  await expect(part.locator('.about')).toContainText('End 2 is under a force that is prescribed');
  await expect(part.getByRole('combobox')).toBeDisabled();
  // Force in at end 2, end 1 held: by reciprocity what gets through the other way, 1/cos(ωτ).
  const { through, driven } = await go(page, 13.52);
  expect(driven).toBe(2);
  const { spring } = await facts(page);
  expect(through?.[0]).toBeCloseTo(1 / Math.cos(2 * Math.PI * 13.52 * spring.transitTime), 2);
  await page.goto('about:blank');
  await open(page, '#suspension');
  await openResponse(page);
  await expect(part.locator('.about')).toContainText(/begins at ×0\.99\d*, not at 1/);
  await page.goto('about:blank');
  await open(page, '#suspension&mount.end_mass=1+kg');
  await openResponse(page);
  await expect(part.locator('.live')).toContainText('it is nowhere within 1\u00a0%');
});

test('windings that meet or touch are said, and the curve stays that of small motions', async ({ page }) => {
  await open(
    page,
    '#valve&spring.coil_diameter=24.65+mm&spring.masses_per_winding=2&contact.windings=hard&@condition=1',
  );
  const part = await openResponse(page);
  await expect(part.locator('.about')).toContainText('Windings are asked to meet: the curve is of motions so small');
  await page.goto('about:blank');
  await open(page, '#S_A&@condition=4&@damping=0');
  await openResponse(page);
  await expect(part.locator('.about')).toContainText('Windings touch in the motion that is shown above');
});

test('while what is typed cannot be computed the last curve stays, in grey; a new state is followed', async ({
  page,
}) => {
  await open(page, '#S_T&@damping=2&@frequency=20');
  const part = await openResponse(page);
  const limit = part.locator('.live b').last();
  const before = await limit.textContent();
  const mass = page.getByLabel('Mass m', { exact: true });
  await mass.fill('infinitely many g');
  await expect(page.locator('#spring-mass-error')).toBeVisible();
  await expect(part.locator('.over-frequency')).toHaveClass(/stale/);
  await expect(limit).toHaveText(before ?? '');
  await mass.fill('80 g');
  await exact(page);
  await settled(page);
  await expect(limit).not.toHaveText(before ?? '');
  // The frequency that was chosen stays.
  expect(await shown(page)).toBe(20);
});

test('over k × motion both ends ring at the modes, where their ratio is 1', async ({ page }) => {
  await open(page, '#S_T&@damping=2');
  const part = await openResponse(page);
  await part.getByRole('combobox').selectOption('motion');
  await expect(part.locator('figcaption')).toContainText('k × motion');
  const { own, other, through } = await go(page, 54.06);
  expect(own?.[0]).toBeGreaterThan(50);
  expect(other?.[0]).toBeGreaterThan(50);
  expect(through?.[0]).toBeCloseTo(1, 1);
});

test('the coil stands still where motion is not wanted, and moves where it is asked to', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, '#S_T&@damping=2');
  const part = await openResponse(page);
  const picture = () => part.locator('canvas.moving').evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
  await part.locator('canvas.moving').scrollIntoViewIfNeeded();
  const before = await picture();
  await page.waitForTimeout(400);
  expect(await picture()).toBe(before);
  await part.getByRole('button', { name: 'Move', exact: true }).click();
  await expect.poll(picture).not.toBe(before);
  await part.getByRole('button', { name: 'Hold still' }).click();
});

for (const colorScheme of typical(['light', 'dark'] as const))
  test(`axe finds nothing in the opened part, in ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await open(page, '#S_T');
    await openResponse(page);
    const field = page.locator('.two-ends').getByRole('textbox', { name: 'Frequency' });
    await field.fill('soon');
    await field.press('Enter');
    const { violations } = await new AxeBuilder({ page }).include('.two-ends').analyze();
    expect(violations).toEqual([]);
  });

test('nothing of it is wider than a phone, and all of it is reached by Tab', async ({ page }) => {
  await page.setViewportSize({ width: 375, height: 812 });
  await open(page);
  const part = await openResponse(page);
  expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
  await part.locator('summary').focus();
  const reached = new Set<string>();
  for (let step = 0; step < 12; step++) {
    await page.keyboard.press('Tab');
    const name = await page.evaluate(() => {
      const at = document.activeElement;
      return at?.closest('.two-ends') ? (at.getAttribute('aria-label') ?? at.textContent ?? at.tagName) : '';
    });
    reached.add(name.replace(/ [\d.]+\s?Hz$/, ''));
  }
  for (const name of ['Frequency, slider', 'Frequency', '1 % limit', 'peak', 'mode', 'Hold still'])
    expect([...reached], name).toContain(name);
});
