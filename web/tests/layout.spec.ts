// On every screen: nothing wider than it, no words cut off, no two things to press above each other. All tabs, and states with long words.
import { type Page } from '@playwright/test';
import { typical } from './long';
import { expect, exact, open, test, unfold } from './page';

/** A desk enlarged four times, as far as WCAG 1.4.10 goes, a phone upright and on its side, a desk enlarged twice, a tablet, a desk, a large one, a wall. */
const SCREENS = [
  [320, 640],
  [375, 812],
  [667, 375],
  [640, 400],
  [1024, 768],
  [1280, 800],
  [2560, 1440],
  [3840, 2160],
] as const;

/** What is wrong with what is shown: one line each. */
const faults = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const found: string[] = [];
    const shown = [...document.body.querySelectorAll<HTMLElement>('*')].filter(
      (element) => element.checkVisibility({ visibilityProperty: true }) && !element.closest('.visually-hidden, .u-hz'),
    );
    const words = (element: Element) =>
      `<${element.tagName.toLowerCase()}${element.id && `#${element.id}`}> ${(element.textContent || element.getAttribute('aria-label') || '').trim().slice(0, 40)}`;
    const scrolls = (element: Element) => /auto|scroll/.test(getComputedStyle(element).overflowX);
    const scroller = (element: Element): Element | null => {
      for (let at = element.parentElement; at; at = at.parentElement) if (scrolls(at)) return at;
      return null;
    };
    for (const element of shown) {
      const { left, right, width } = element.getBoundingClientRect();
      if (width > 0 && (right > innerWidth + 1 || left < -1) && !scroller(element))
        found.push(`wider than the screen by ${Math.max(right - innerWidth, -left).toFixed(0)}: ${words(element)}`);
      const hides = /hidden|clip/.test(getComputedStyle(element).overflowX);
      const says = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent?.trim());
      const cut = element.scrollWidth > element.clientWidth + 1 && element.clientWidth > 0;
      const inline = getComputedStyle(element).display === 'inline';
      // What is typed scrolls in its field.
      if (cut && (hides || (says && !inline)) && !scrolls(element) && element.tagName !== 'INPUT')
        found.push(`cut off: ${words(element)}`);
    }
    const pressed = shown.filter((element) =>
      element.matches('button, input, select, summary, a[href], [tabindex="0"]'),
    );
    const area = (element: Element) => {
      const box = element.getBoundingClientRect();
      const frame = scroller(element)?.getBoundingClientRect() ?? { left: -1e6, right: 1e6, top: -1e6, bottom: 1e6 };
      return {
        left: Math.max(box.left, frame.left),
        right: Math.min(box.right, frame.right),
        top: Math.max(box.top, frame.top),
        bottom: Math.min(box.bottom, frame.bottom),
      };
    };
    const areas = pressed.map(area);
    pressed.forEach((one, index) => {
      pressed.slice(index + 1).forEach((other, after) => {
        if (one.contains(other) || other.contains(one)) return;
        const [a, b] = [areas[index]!, areas[index + 1 + after]!];
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        if (across > 1 && down > 1) found.push(`${words(one)} and ${words(other)} meet`);
      });
    });
    return found;
  });

async function onEveryScreen(page: Page, more = async (_: string) => {}): Promise<void> {
  for (const [width, height] of SCREENS) {
    await page.setViewportSize({ width, height });
    // Two frames: one to lay out, one in which what watches sizes has drawn.
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    expect(await faults(page), `${width} × ${height}`).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    await more(`${width} × ${height}`);
  }
}

test.setTimeout(120_000);

test('the faults that are looked for are found', async ({ page }) => {
  await open(page);
  await page.evaluate(() => {
    document.body.insertAdjacentHTML(
      'beforeend',
      `<p style="width: 4000px">far</p><p style="width: 20px; overflow: hidden; white-space: nowrap">too many words</p>
       <button style="position: absolute; top: 100px; left: 0">one</button><button style="position: absolute; top: 105px; left: 5px">other</button>`,
    );
  });
  const found = (await faults(page)).join('\n');
  for (const words of ['far', 'cut off: <p> too many words', '<button> one and <button> other meet'])
    expect(found).toContain(words);
});

test('the spring as it comes', async ({ page }) => {
  await open(page);
  // A table that is wider than its card can be scrolled, but this one need not be.
  const table = page.getByRole('region', { name: 'How far each force is off' });
  await onEveryScreen(page, async (screen) => {
    // At 320 it scrolls in its card, as tables may.
    const more = screen.startsWith('320') ? 80 : 1;
    expect(await table.evaluate((one) => one.scrollWidth - one.clientWidth), screen).toBeLessThanOrEqual(more);
  });
});

for (const hash of typical([
  '#S_A&@condition=4',
  '#S_T&@kept="S_A"',
  '#valve',
  '#suspension',
  '#S_T&condition.0.velocity=8+m/s',
]))
  test(`${hash} with everything opened and every sensor drawn`, async ({ page }) => {
    await open(page, hash);
    const toDraw = page.locator('button.toggle[aria-pressed=false]');
    for (let left = await toDraw.count(); left > 0; left--) await toDraw.first().click();
    await unfold(page);
    await onEveryScreen(page);
  });

test('a wrong value and its reason', async ({ page }) => {
  await open(page);
  await page.getByLabel('Mass m', { exact: true }).fill('sixty-five grammes of the finest music wire');
  await expect(page.locator('#spring-mass-error')).toBeVisible();
  await onEveryScreen(page);
});

for (const tab of typical(['Log', 'Mitigate', 'Paper']))
  test(`the tab ${tab}`, async ({ page }) => {
    await open(page);
    await page.getByRole('tab', { name: tab }).click();
    if (tab === 'Paper') await expect(page.locator('.paper[aria-busy=false]')).toBeVisible({ timeout: 60_000 });
    else await exact(page);
    await onEveryScreen(page);
  });
