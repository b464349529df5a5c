// What the page leaves out of a spec by itself is said, and can be had back.
import { expect, exact, open, test } from './page';

test('an end 2 under a force puts the table [control] aside, says so, and gives it back', async ({ page }) => {
  await open(page, '#S_T');
  const end = page.getByLabel('End 2', { exact: true });
  const note = page.locator('#notices .said').filter({ hasText: '[control]' });
  const address = () => decodeURIComponent(page.url());
  await end.selectOption('force');
  await expect(note).toContainText('left out of the spec');
  await expect.poll(address).toContain('-control');
  await exact(page);
  await note.getByRole('button', { name: 'Undo' }).click();
  await expect(end).toHaveValue('held');
  await expect.poll(address).not.toContain('-control');
});

test('nothing is said where nothing is put aside', async ({ page }) => {
  await open(page, '#S_T');
  await page.getByLabel('End 2', { exact: true }).selectOption('mass');
  await expect.poll(() => page.url()).toContain('mass');
  await exact(page);
  await expect(page.locator('#notices .said')).toHaveCount(0);
});
