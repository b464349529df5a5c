// Why the ends disagree: four steps whose numbers are those of the curves, and whose links show the moment.
import { expect, facts, open, series, test } from './page';

test('each step names what the curves show, and shows it', async ({ page }) => {
  await open(page, '#S_T');
  const why = page.getByRole('region', { name: 'Why the ends disagree' });
  await why.getByText('Why the ends disagree, in four steps').click();
  await expect(why.getByRole('listitem')).toHaveCount(4);
  const { spring, staticForce } = await facts(page);
  await expect(why).toContainText(`${staticForce?.toFixed(1)}`);
  // One way through S_T's coil.
  await expect(why).toContainText(`${(1e3 * spring.transitTime).toFixed(2)}\u00a0ms`);
  const [time, one, two] = [await series(page, 'time'), await series(page, 'F_i'), await series(page, 'F_o')];
  const at = time.findIndex((t) => t >= 0.5 * spring.transitTime);
  const apart = Math.abs((one[at] ?? NaN) - (two[at] ?? NaN));
  // 2 √(k m) v: an end is run up against, the other away from. Waves of a few windings ripple about it.
  expect(Math.abs(apart / (2 * Math.sqrt(spring.stiffness * spring.mass) * 0.25) - 1)).toBeLessThan(0.15);
  await expect(why.getByRole('listitem').nth(1)).toContainText(`${Number(apart.toPrecision(3))}\u00a0N`);
  await why.getByRole('link', { name: 'Show it: The wave meets the other end' }).click();
  await expect.poll(() => page.url()).toContain('times');
  await expect(page.locator('.see')).toContainText(`${(1.5e3 * spring.transitTime).toFixed(1)} ms`);
  // A link is one: what is copied opens the same times.
  const href = await why.getByRole('link', { name: 'Show it: Blow' }).getAttribute('href');
  await page.goto('about:blank');
  await open(page, href ?? '');
  const shown = await page.evaluate(() => window.coilsense.last()?.times);
  expect(shown?.[1]).toBeCloseTo(spring.transitTime, 6);
});

test('the numbers are of the state that is shown, and another motion has no steps of a hit', async ({ page }) => {
  await open(page, '#S_T');
  const why = page.getByRole('region', { name: 'Why the ends disagree' });
  await why.getByText('Why the ends disagree, in four steps').click();
  await expect(why.getByRole('listitem')).toHaveCount(4);
  const before = await why.getByRole('listitem').nth(1).textContent();
  await page.getByRole('textbox', { name: 'How hard it is hit' }).fill('0.5 m/s');
  await expect(why.getByRole('listitem').nth(1)).not.toHaveText(before ?? '');
  await page.goto('about:blank');
  await open(page, '#suspension');
  await why.getByText('Why the ends disagree, in four steps').click();
  await expect(why.getByRole('listitem')).toHaveCount(0);
  await expect(why.getByRole('link')).toHaveAttribute('href', /^#S_T/);
});
