// What the page leaves out of a spec by itself is said, and can be had back.
import { expect, exact, open, test } from './page';

test('an end 2 under a force puts the table [control] aside, says so, and gives it back', async ({ page }) => {
  await open(page, '#S_T');
  const note = page.locator('#notices .said').filter({ hasText: '[control]' });
  await page.getByLabel('End 2', { exact: true }).selectOption('mass');
  await exact(page);
  await expect(note).toHaveCount(0);
  await page.getByLabel('End 2', { exact: true }).selectOption('force');
  await expect(note).toContainText('left out of the spec');
  await exact(page);
  expect(decodeURIComponent(page.url())).toContain('-control');
  await note.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByLabel('End 2', { exact: true })).toHaveValue('mass');
  await expect.poll(() => decodeURIComponent(page.url())).not.toContain('-control');
});
