// Around the tabs: what stands above them, what to begin with, whose page it is.
import { expect, open, test } from './page';

test('who has just come is shown what to drag, until it was dragged', async ({ page }) => {
  await open(page);
  const cue = page.locator('.cue');
  await expect(cue).toHaveCount(1);
  const words = await cue
    .locator('.field')
    .first()
    .evaluate((field) => getComputedStyle(field, '::before').content);
  expect(words).toContain('drag the slider');
  await page.getByRole('slider', { name: 'How hard it is hit, slider' }).fill('400');
  await expect(cue).toHaveCount(0);
  await expect.poll(() => page.url()).toContain('velocity');
  await page.reload();
  await expect(page.locator('#condition')).toBeVisible();
  await expect(cue).toHaveCount(0);
});

test('each tab says what it is for; the sentence about the spring stands where it is about', async ({ page }) => {
  await open(page);
  await expect(page.locator('#sentence')).toContainText(/N apart/);
  for (const [tab, words] of [
    ['Log', 'recording'],
    ['Paper', 'paper'],
  ] as const) {
    await page.getByRole('tab', { name: tab }).click();
    await expect(page.locator('#sentence')).toBeHidden();
    await expect(page.locator('#lead')).toContainText(words);
  }
  await page.getByRole('tab', { name: 'Spring' }).click();
  await expect(page.locator('#sentence')).toBeVisible();
  await expect(page.locator('#lead')).toBeHidden();
});

test('the footer leads to the project, and other sites are told what the page is', async ({ page }) => {
  await open(page);
  await expect(page.locator('footer a')).toHaveAttribute('href', /^https:\/\//);
  await expect(page.locator('footer')).toContainText(/coilsense \d+\.\d+\.\d+, MIT/);
  for (const name of ['og:title', 'og:description'])
    await expect(page.locator(`meta[property="${name}"]`)).toHaveAttribute('content', /.{20,}/);
});
