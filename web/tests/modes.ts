// The part of the page with every mode of the coil: opened, and moved to a length.
import { expect, type Locator, type Page } from '@playwright/test';

/** The part once all of it is there. */
export async function openModes(page: Page): Promise<Locator> {
  const part = page.locator('.every');
  if (!(await part.locator('details').getAttribute('open'))) await part.locator('summary').click();
  await settled(page);
  return part;
}

/** Waits until what is shown is of the state. */
export async function settled(page: Page): Promise<void> {
  await expect(page.locator('.every-mode')).toHaveAttribute('aria-busy', 'false', { timeout: 30_000 });
}

/** A length as a share of the way from the shortest to the longest in use, or the nearest to it that can be chosen. */
export async function moveTo(page: Page, share: number): Promise<void> {
  const slider = page.locator('.every').getByRole('slider', { name: 'Length' });
  await slider.focus();
  await page.keyboard.press('Home');
  const last = Number(await slider.getAttribute('max'));
  // 49 lengths in use, and that of the condition where it is none of them: the stop whose words are nearest.
  const of = async () => parseFloat((await slider.getAttribute('aria-valuetext')) ?? '');
  const shortest = await of();
  await page.keyboard.press('End');
  const wanted = shortest + share * ((await of()) - shortest);
  let best = last;
  for (let stop = last, least = Infinity; stop >= 0; stop--) {
    await slider.fill(String(stop));
    const off = Math.abs((await of()) - wanted);
    if (off < least) [least, best] = [off, stop];
  }
  await slider.fill(String(best));
}
