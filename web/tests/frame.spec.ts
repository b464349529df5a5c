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
  await expect(page.locator('#sentence')).toContainText(/differ by up to [\d.]+\u00a0N/);
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
  await expect(page.locator('footer a').first()).toHaveAttribute('href', /^https:\/\//);
  await expect(page.locator('footer')).toContainText(/coilsense \d+\.\d+\.\d+, MIT/);
  for (const name of ['og:title', 'og:description'])
    await expect(page.locator(`meta[property="${name}"]`)).toHaveAttribute('content', /.{20,}/);
});

test('a tab has its own title', async ({ page }) => {
  await open(page);
  await expect(page).toHaveTitle('coilsense: hit the spring');
  await page.getByRole('tab', { name: 'Log' }).click();
  await expect(page).toHaveTitle('Log – coilsense');
  await page.getByRole('tab', { name: 'Spring' }).click();
  await expect(page).toHaveTitle('coilsense: hit the spring');
});

test('the licences of all that is shipped are a file beside the page', async ({ page, request }) => {
  await open(page);
  const href = await page.getByRole('link', { name: 'Third-party licences' }).getAttribute('href');
  const reply = await request.get(new URL(href ?? '', page.url()).href);
  expect(reply.ok()).toBe(true);
  const text = await reply.text();
  for (const work of ['uplot 1.6.32, MIT', 'smol-toml', 'nalgebra', 'wasm-bindgen', 'serde_json', 'realfft'])
    expect(text).toContain(work);
  expect(text).toContain('THE SOFTWARE IS PROVIDED "AS IS"');
});

test('embedded, the spring and its forces stand alone, with a way to all of it', async ({ page }) => {
  await page.goto('./?embed#S_T&spring.mass=70+g');
  await page.waitForFunction(() => document.body.dataset['exact'] === 'true');
  await expect(page.locator('.play').first()).toBeVisible();
  for (const gone of ['#tabs', '.choose', '.controls', '.trust', '.results', 'footer'])
    await expect(page.locator(gone)).toBeHidden();
  const [whole] = await Promise.all([
    page.waitForEvent('popup'),
    page.getByRole('link', { name: 'Open in coilsense' }).click(),
  ]);
  await expect(whole.locator('#spring-mass')).toHaveValue('70 g');
  expect(new URL(whole.url()).search).toBe('');
});

test('on paper there is the answer and no control', async ({ page }) => {
  await open(page);
  await page.emulateMedia({ media: 'print' });
  await expect(page.locator('.trust')).toBeVisible();
  await expect(page.getByRole('region', { name: 'How far each force is off' })).toBeVisible();
  for (const gone of ['#tabs', '.choose', '.controls', '.downloads'])
    await expect(page.locator(gone).first()).toBeHidden();
});
