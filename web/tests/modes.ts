// The part of the page with every mode of the coil: opened, and moved to a length.
import { expect, type Locator, type Page } from '@playwright/test';

/** The part once all of it is there. */
export async function openModes(page: Page): Promise<Locator> {
  const part = page.locator('.every');
  if ((await part.locator('details').getAttribute('open')) === null) await part.locator('summary').click();
  await settled(page);
  return part;
}

/** Waits until what is shown is of the state. */
export async function settled(page: Page): Promise<void> {
  await expect(page.locator('.every-mode')).toHaveAttribute('aria-busy', 'false', { timeout: 30_000 });
}

/** A length as a share of the way from the shortest to the longest in use; that of the condition is one of those. */
export async function moveTo(page: Page, share: number): Promise<void> {
  const slider = page.locator('.every').getByRole('slider', { name: 'Length' });
  await slider.fill(String(share * Number(await slider.getAttribute('max'))));
}
