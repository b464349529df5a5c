// For everyone: no violation that axe knows, nothing wider than the screen, still where motion is not wanted.
import AxeBuilder from '@axe-core/playwright';
import { typical } from './long';
import { expect, exact, open, test, unfold } from './page';

for (const colorScheme of typical(['light', 'dark'] as const)) {
  test(`axe finds nothing, in ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await open(page, '#S_A&@condition=4');
    await unfold(page);
    // What is of an earlier state, or of none yet, stands in grey on purpose.
    await expect(page.locator('.every [aria-busy=false]')).toBeVisible({ timeout: 60_000 });
    const spring = await new AxeBuilder({ page }).analyze();
    expect(spring.violations).toEqual([]);
    await page.getByRole('tab', { name: 'Paper' }).click();
    await expect(page.locator('.paper[aria-busy=false]')).toBeVisible({ timeout: 60_000 });
    const paper = await new AxeBuilder({ page }).analyze();
    expect(paper.violations).toEqual([]);
  });
}

for (const [width, height] of typical([
  [375, 812],
  [1280, 800],
  [2560, 1440],
  [3840, 2160],
] as const)) {
  test(`nothing is wider than ${width} pixels, nor cut off`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await open(page);
    const wider = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(await wider()).toBeLessThanOrEqual(0);
    // Words that do not fit their box.
    const cut = await page.evaluate(() =>
      [...document.querySelectorAll('button, label, h1, h2, p, td, th, summary')]
        .filter(
          (element) =>
            element.scrollWidth > element.clientWidth + 1 &&
            getComputedStyle(element).display !== 'inline' &&
            element.clientWidth > 0,
        )
        .map((element) => element.textContent),
    );
    expect(cut).toEqual([]);
    await page.getByRole('tab', { name: 'Paper' }).click();
    await expect(page.locator('.paper[aria-busy=false]')).toBeVisible({ timeout: 60_000 });
    expect(await wider()).toBeLessThanOrEqual(0);
  });
}

test('nothing moves by itself where motion is not wanted', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page);
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
  const clock = page.locator('.clock');
  const before = await clock.textContent();
  await page.waitForTimeout(600);
  await expect(clock).toHaveText(before ?? '');
  await exact(page);
});
