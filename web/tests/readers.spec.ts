// What a screen reader hears: changes of live regions, counted as a reader would speak them, while the spring plays, while somebody types,
// points or drags, and while the larger engine works.
import { expect, type Page } from '@playwright/test';
import { openModes } from './modes';
import { exact, MOVING, open, test } from './page';

test.use(MOVING);

interface Heard {
  at: number;
  where: string;
  words: string;
}

/** Counts what live regions of a page say from now on: one for each region and turn of the page's loop, as readers take changes together. */
async function listen(page: Page): Promise<void> {
  await page.evaluate(() => {
    const heard: Heard[] = [];
    Object.assign(window, { heard });
    const IMPLIED: Record<string, string> = { alert: 'assertive', status: 'polite', log: 'polite', timer: 'off' };
    /** The region that a change is in, as far as it speaks. */
    const region = (node: Node): Element | null => {
      const element = node instanceof Element ? node : node.parentElement;
      const found = element?.closest('[aria-live], [role=alert], [role=status], [role=log], output') ?? null;
      if (!found) return null;
      const role = found.getAttribute('role') ?? (found.tagName === 'OUTPUT' ? 'status' : '');
      const live = found.getAttribute('aria-live') ?? IMPLIED[role] ?? 'off';
      return live === 'off' || !(found as HTMLElement).checkVisibility() || !found.textContent?.trim() ? null : found;
    };
    new MutationObserver((records) => {
      const regions = new Set(records.map(({ target }) => region(target)).filter((found) => found !== null));
      for (const found of regions)
        heard.push({
          at: performance.now(),
          where: found.id || `${found.parentElement?.className} ${found.className}`,
          words: found.textContent ?? '',
        });
    }).observe(document.body, {
      subtree: true,
      childList: true,
      characterData: true,
      attributes: true,
      attributeFilter: ['hidden', 'aria-live', 'role'],
    });
  });
}

const heard = (page: Page): Promise<Heard[]> =>
  page.evaluate(() => (window as unknown as { heard: Heard[] }).heard.splice(0));

/** No region speaks twice within a second; the clocks of timers and of what is heard differ by a frame. */
function calm(all: Heard[]): void {
  for (const where of new Set(all.map((one) => one.where))) {
    const times = all.filter((one) => one.where === where).map(({ at }) => at);
    times.slice(1).forEach((at, index) => expect(at - times[index]!, `${where} speaks again`).toBeGreaterThan(950));
  }
}

test('what is counted is counted: a region that says five things in five turns is heard five times', async ({
  page,
}) => {
  await open(page);
  await listen(page);
  await page.evaluate(async () => {
    const told = document.body.appendChild(document.createElement('output'));
    told.className = 'noisy';
    for (let word = 0; word < 5; word++) {
      told.textContent = String(word);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  });
  expect((await heard(page)).filter(({ where }) => where.endsWith('noisy'))).toHaveLength(5);
});

test('nothing is said while the spring plays, with every sensor drawn', async ({ page }) => {
  await open(page);
  const toDraw = page.locator('button.toggle[aria-pressed=false]');
  for (let left = await toDraw.count(); left > 0; left--) await toDraw.first().click();
  await exact(page);
  // It plays while it is in sight.
  await page.locator('.coil').scrollIntoViewIfNeeded();
  await listen(page);
  const clock = page.locator('.clock');
  const before = await clock.textContent();
  await page.waitForTimeout(3000);
  // It plays: 273 changes came of that once.
  await expect(clock).not.toHaveText(before ?? '');
  const all = await heard(page);
  console.log(`heard in 3 s of playing: ${all.length}`);
  expect(all).toEqual([]);
});

test('a quantity that is typed letter by letter raises no alert, and a wrong one raises a single one, once typing rests', async ({
  page,
}) => {
  await open(page);
  await listen(page);
  const stiffness = page.getByLabel('Stiffness k', { exact: true });
  await stiffness.selectText();
  await stiffness.pressSequentially('800 N/m', { delay: 150 });
  await exact(page);
  expect(await heard(page)).toEqual([]);
  await stiffness.selectText();
  await stiffness.pressSequentially('800 newtons a metre', { delay: 100 });
  // Half of it was refused for a second and more by now.
  expect(await heard(page)).toEqual([]);
  await expect(page.locator('#spring-stiffness-error')).toBeVisible();
  const all = await heard(page);
  expect(all.map(({ where }) => where).sort()).toEqual(['controls refusal', 'spring-stiffness-error']);
});

test('a field that is left says at once what is wrong; one that is right again is so at once', async ({ page }) => {
  await open(page);
  await listen(page);
  const mass = page.getByLabel('Mass m', { exact: true });
  await mass.fill('x');
  await page.waitForTimeout(300);
  expect(await heard(page)).toEqual([]);
  const left = await page.evaluate(() => {
    (document.activeElement as HTMLElement).blur();
    return performance.now();
  });
  await expect(page.locator('#spring-mass-error')).toBeVisible();
  const all = await heard(page);
  expect(all.find(({ where }) => where === 'spring-mass-error')!.at - left).toBeLessThan(500);
  await mass.fill('70 g');
  await expect(page.locator('#spring-mass-error')).toBeHidden({ timeout: 900 });
});

test('the mark that is moved by keys says its forces, once a second', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Pause' }).click();
  await listen(page);
  await page.locator('.plot.forces').focus();
  const begun = Date.now();
  for (let press = 0; press < 25; press++) {
    await page.keyboard.press('ArrowRight');
    await page.waitForTimeout(80);
  }
  await page.waitForTimeout(1100);
  const all = await heard(page);
  calm(all);
  expect(all.length).toBeGreaterThan(1);
  expect(all.length).toBeLessThanOrEqual(1 + (Date.now() - begun) / 1000);
  const clock = await page.locator('.clock').textContent();
  expect(all.at(-1)!.words).toMatch(new RegExp(`^${clock}: F_i [−\\d.]+ N, F_o [−\\d.]+ N`));
});

test('dragging a slider of the spring or of its modes is not spoken of but by the slider', async ({ page }) => {
  await open(page);
  const part = await openModes(page);
  await page.getByRole('button', { name: 'Pause' }).click();
  await listen(page);
  const hit = page.getByRole('slider', { name: 'How hard it is hit, slider' });
  const length = part.getByRole('slider', { name: 'Length' });
  for (let step = 0; step < 15; step++) {
    await hit.fill(String(300 + 10 * step));
    await length.fill(String(step));
    await page.waitForTimeout(60);
  }
  await exact(page);
  expect(await heard(page)).toEqual([]);
});

test('Mitigate: typing is left in peace, and progress is told once a second', async ({ page }) => {
  await open(page, '#S_T&@tab=%22mitigate%22');
  const noise = page.getByLabel('Noise of');
  await page.getByText('Sampling, noise, tolerances').click();
  await listen(page);
  await noise.pressSequentially('0,2 N', { delay: 250 });
  await noise.selectText();
  await noise.pressSequentially('loud', { delay: 250 });
  expect((await heard(page)).filter(({ where }) => where.includes('error') || where.includes('refusal'))).toEqual([]);
  await expect(page.locator('#mitigate-noise-error')).toBeVisible();
  expect((await heard(page)).filter(({ where }) => where.includes('error'))).toHaveLength(1);
  await noise.fill('0,25');
  await noise.blur();
  await expect(noise).toHaveValue(/^0\.25 N$/);
  await page.getByLabel('Series of noise').fill('2');
  await heard(page);
  await page.getByRole('button', { name: 'Judge', exact: true }).click();
  await expect(page.locator('[role=status]').filter({ hasText: 'Judged in' })).toBeVisible({ timeout: 100_000 });
  calm((await heard(page)).filter(({ where }) => where.startsWith('progress')));
});
