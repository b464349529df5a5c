// Back, Forward, Undo, Reset and links: each does what it says where it is pressed.
import type { Page } from '@playwright/test';
import { exact, expect, facts, open, test } from './page';

const tab = (page: Page, name: string) => page.getByRole('tab', { name });
const chosen = (page: Page) => page.getByRole('tab', { selected: true });
const mass = (page: Page) => page.getByLabel('Mass m', { exact: true });

test('Back goes to the tab before, Forward to the one after, and neither takes back what was edited', async ({
  page,
}) => {
  await page.goto('about:blank');
  await open(page);
  await mass(page).fill('70 g');
  await tab(page, 'Log').click();
  await tab(page, 'Mitigate').click();
  await page.getByLabel('Most lag').fill('40 deg');
  await expect.poll(() => page.url()).toContain('mitigate');
  await page.goBack();
  await expect(chosen(page)).toHaveText('Log');
  await page.goBack();
  await expect(chosen(page)).toHaveText('Spring');
  await expect(mass(page)).toHaveValue('70 g');
  await mass(page).fill('71 g');
  await page.goForward();
  await expect(chosen(page)).toHaveText('Log');
  await page.goForward();
  await expect(chosen(page)).toHaveText('Mitigate');
  await expect(page.getByLabel('Most lag')).toHaveValue('40 deg');
  await expect(mass(page)).toHaveValue('71 g');
  // The address is that of what is shown, not of what the step once was.
  await expect.poll(() => page.url()).toContain('spring.mass=71+g');
  for (let back = 0; back < 3; back++) await page.goBack();
  await expect.poll(() => page.url()).toBe('about:blank');
});

test('Back from an address that was typed gives the state before it, Forward that of the address', async ({ page }) => {
  await open(page);
  await mass(page).fill('70 g');
  await expect.poll(() => page.url()).toContain('spring.mass=70+g');
  await page.evaluate(() => (location.hash = '#valve&@tab=%22log%22'));
  await expect(chosen(page)).toHaveText('Log');
  await tab(page, 'Spring').click();
  await expect(page.locator('#preset')).toHaveValue('valve');
  await page.goBack();
  await expect(chosen(page)).toHaveText('Log');
  await page.goBack();
  await expect(chosen(page)).toHaveText('Spring');
  await expect(page.locator('#preset')).toHaveValue('S_T');
  await expect(mass(page)).toHaveValue('70 g');
  await page.goForward();
  await expect(page.locator('#preset')).toHaveValue('valve');
});

test('a page that is loaded again keeps its steps', async ({ page }) => {
  await open(page);
  await mass(page).fill('70 g');
  await tab(page, 'Log').click();
  await page.reload();
  await expect(chosen(page)).toHaveText('Log');
  await page.goBack();
  await expect(chosen(page)).toHaveText('Spring');
  await expect(mass(page)).toHaveValue('70 g');
});

test('Undo, Redo and Reset are of the tab that is shown', async ({ page }) => {
  await open(page);
  const [undo, redo, reset] = ['Undo', 'Redo', 'Reset'].map((name) => page.getByRole('button', { name }));
  await mass(page).fill('70 g');
  await tab(page, 'Log').click();
  await expect(undo!).toBeDisabled();
  await page.keyboard.press('Control+z');
  await expect(chosen(page)).toHaveText('Log');
  await reset!.click();
  await tab(page, 'Mitigate').click();
  await expect(undo!).toBeDisabled();
  const lag = page.getByLabel('Most lag');
  await lag.fill('40 deg');
  await lag.blur();
  await tab(page, 'Spring').click();
  await expect(mass(page)).toHaveValue('70 g');
  await undo!.click();
  await expect(mass(page)).toHaveValue('65 g');
  await expect(undo!).toBeDisabled();
  await redo!.click();
  await expect(mass(page)).toHaveValue('70 g');
  await tab(page, 'Mitigate').click();
  await expect(lag).toHaveValue('40 deg');
  await undo!.click();
  await expect(lag).toHaveValue('');
  await redo!.click();
  await expect(lag).toHaveValue('40 deg');
  await reset!.click();
  await expect(lag).toHaveValue('');
  await tab(page, 'Paper').click();
  await expect(reset!).toBeDisabled();
  await tab(page, 'Spring').click();
  await expect(mass(page)).toHaveValue('70 g');
  await reset!.click();
  await expect(mass(page)).toHaveValue('65 g');
});

test('the link is that of what is shown, at once after an edit, and it is said that it was copied', async ({
  page,
  context,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  // Letters are understood from a moment on that comes soon after the first picture.
  const understood = page.waitForResponse(/values-/);
  await open(page);
  await (await understood).finished();
  await exact(page);
  const copied = page.locator('.copied');
  await expect(copied).toBeEmpty();
  // Both in one turn of the page's loop: no address can have been written between them.
  await page.evaluate(() => {
    const input = document.querySelector<HTMLInputElement>('#spring-mass')!;
    input.focus();
    input.value = '70,5';
    input.dispatchEvent(new Event('input', { bubbles: true }));
    [...document.querySelectorAll('button')].find(({ textContent }) => textContent === 'Link')!.click();
  });
  await expect(copied).toHaveText('The link is copied.');
  await expect(copied).toHaveAttribute('role', 'status');
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toContain('spring.mass=70.5+g');
  const other = await context.newPage();
  await other.goto(link);
  expect((await facts(other)).spring.mass).toBeCloseTo(0.0705, 12);
  await other.close();
  await exact(page);
});

test('where nothing may be copied, the link is shown to be copied by hand', async ({ page }) => {
  await page.addInitScript(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
  await open(page);
  await mass(page).fill('70 g');
  await page.getByRole('button', { name: 'Link', exact: true }).click();
  const field = page.getByLabel('The link', { exact: true });
  await expect(field).toHaveValue(/spring\.mass=70\+g/);
  await expect(field).toBeFocused();
  const selected = await field.evaluate((one: HTMLInputElement) => one.selectionEnd! - one.selectionStart!);
  expect(selected).toBe((await field.inputValue()).length);
});
