// Small screens and fingers: what the first screen shows, how little it jumps while it loads, and what two fingers do to a plot.
import type { CDPSession, Locator, Page } from '@playwright/test';
import { typical } from './long';
import { expect, MOVING, open, test } from './page';

test.use(MOVING);

/** Top and bottom of an element on the screen as it comes [CSS pixels]. */
const reach = async (found: Locator): Promise<[number, number]> => {
  const box = await found.boundingBox();
  if (!box) throw new Error('not shown');
  return [box.y, box.y + box.height];
};

test('a phone’s first screen has the spring, its first slider and the whole plot', async ({ page }) => {
  for (const [width, height] of [
    [390, 844],
    [375, 812],
  ] as const) {
    await page.setViewportSize({ width, height });
    await open(page);
    expect(await page.evaluate(() => scrollY)).toBe(0);
    for (const [what, found] of [
      ['slider', page.getByRole('slider', { name: 'How hard it is hit, slider' })],
      ['spring', page.locator('.coil')],
      ['plot', page.locator('.plot.forces')],
    ] as const) {
      const [top, bottom] = await reach(found);
      expect(top, what).toBeGreaterThan(0);
      expect(bottom, what).toBeLessThan(height);
    }
    // The plot is drawn, and not only its frame.
    const [top, bottom] = await reach(page.locator('.plot.forces .u-over'));
    expect(bottom - top).toBeGreaterThan(100);
  }
});

for (const preset of typical(['S_T', 'S_A', 'valve', 'suspension']))
  test(`${preset}, enlarged twice on a desk of 1280 × 800: the spring is on the first screen`, async ({ browser }) => {
    const context = await browser.newContext({ viewport: { width: 640, height: 400 }, deviceScaleFactor: 2 });
    const page = await context.newPage();
    await open(page, `#${preset}`);
    expect((await reach(page.locator('.coil')))[1]).toBeLessThan(400);
    expect((await reach(page.locator('#condition')))[1]).toBeLessThan(400);
    await context.close();
  });

for (const [width, height] of [
  [390, 844],
  [640, 400],
  [1280, 800],
] as const)
  for (const preset of typical(['', '#S_A', '#suspension']))
    test(`${width} × ${height} ${preset}: what is seen does not jump while the page loads`, async ({ page }) => {
      await page.setViewportSize({ width, height });
      await page.addInitScript(() => {
        const shifts: number[] = [];
        Object.assign(window, { shifts });
        new PerformanceObserver((list) => {
          for (const entry of list.getEntries() as (PerformanceEntry & { value: number; hadRecentInput: boolean })[])
            if (!entry.hadRecentInput) shifts.push(entry.value);
        }).observe({ type: 'layout-shift', buffered: true });
      });
      await open(page, preset);
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      const total = () =>
        page.evaluate(() => (window as unknown as { shifts: number[] }).shifts.reduce((sum, one) => sum + one, 0));
      const loaded = await total();
      console.log(`layout shift at ${width} × ${height} ${preset}: ${loaded.toFixed(4)} (goal 0.05)`);
      expect(loaded).toBeLessThan(0.05);
      // What is measured is measured: a line above all of it counts.
      await page.evaluate(() =>
        document.body.prepend(Object.assign(document.createElement('p'), { textContent: 'x' })),
      );
      await expect.poll(total).toBeGreaterThan(loaded);
    });

test.describe('fingers', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 844 } });

  type Finger = { x: number; y: number };
  const touch = async (client: CDPSession, type: 'touchStart' | 'touchMove' | 'touchEnd', fingers: Finger[]) =>
    client.send('Input.dispatchTouchEvent', { type, touchPoints: fingers.map((finger, id) => ({ ...finger, id })) });

  /** Fingers that go evenly from some places to others. */
  async function drag(client: CDPSession, from: Finger[], to: Finger[], steps = 8): Promise<void> {
    await touch(client, 'touchStart', from);
    for (let step = 1; step <= steps; step++) {
      const along = (a: number, b: number) => a + ((b - a) * step) / steps;
      const fingers = from.map(({ x, y }, index) => ({ x: along(x, to[index]!.x), y: along(y, to[index]!.y) }));
      await touch(client, 'touchMove', fingers);
    }
    await touch(client, 'touchEnd', []);
  }

  const times = (page: Page) => page.evaluate(() => window.coilsense.last()!.times);

  async function begin(page: Page, hash = '') {
    await open(page, hash);
    await page.getByRole('button', { name: 'Pause' }).click();
    const over = page.locator('.plot.forces .u-over');
    await expect(over).toHaveCSS('touch-action', 'pan-x pan-y');
    const box = (await over.boundingBox())!;
    const client = await page.context().newCDPSession(page);
    const at = (part: number, y = 0.5): Finger => ({ x: box.x + part * box.width, y: box.y + y * box.height });
    return { client, at };
  }

  test('two that part zoom in about their middle, two that go along shift, and the page stays', async ({ page }) => {
    const { client, at } = await begin(page);
    const [from, to] = await times(page);
    await drag(client, [at(0.4), at(0.6)], [at(0.3), at(0.7)]);
    // Twice as far apart: half the time, the middle where it was.
    await expect.poll(async () => (await times(page))[1] - (await times(page))[0]).toBeCloseTo((to - from) / 2, 4);
    const [start, end] = await times(page);
    expect((start + end) / 2).toBeCloseTo((from + to) / 2, 4);
    await drag(client, [at(0.4), at(0.6)], [at(0.5), at(0.7)]);
    // A tenth of the width to the right: what is shown begins earlier.
    await expect.poll(async () => (await times(page))[0]).toBeCloseTo(start - 0.1 * (end - start), 4);
    expect((await times(page))[1] - (await times(page))[0]).toBeCloseTo(end - start, 4);
    expect(await page.evaluate(() => [scrollY, visualViewport?.scale])).toEqual([0, 1]);
    // As an address it is the state, like every other zoom.
    await expect.poll(() => page.url()).toContain('@times=');
  });

  test('pinched beyond all that there is, all is shown; fingers on one spot do no harm', async ({ page }) => {
    const { client, at } = await begin(page);
    for (let pinch = 0; pinch < 6; pinch++) await drag(client, [at(0.1), at(0.9)], [at(0.45), at(0.55)], 4);
    await expect.poll(() => times(page)).toEqual([0, 1]);
    await drag(client, [at(0.5, 0.3), at(0.5, 0.7)], [at(0.5, 0.2), at(0.5, 0.8)]);
    expect((await times(page)).every((time) => Number.isFinite(time))).toBe(true);
  });

  test('a double tap shows what was shown at first; two taps apart do not', async ({ page }) => {
    const { client, at } = await begin(page, '#S_T&@times=[0.2,0.3]');
    expect(await times(page)).toEqual([0.2, 0.3]);
    const tap = async (finger: Finger) => {
      await touch(client, 'touchStart', [finger]);
      await touch(client, 'touchEnd', []);
    };
    await tap(at(0.2));
    await tap(at(0.8));
    await page.waitForTimeout(500);
    expect(await times(page)).toEqual([0.2, 0.3]);
    // A tap moves the mark, as a click does.
    await expect(page.locator('.clock')).toHaveText(/^280\.[01] ms$/);
    await tap(at(0.5));
    await tap(at(0.5));
    await expect.poll(async () => (await times(page))[0]).toBe(0);
    await expect.poll(() => page.url()).not.toContain('@times');
  });

  test('one finger scrolls the page over the plot, and zooms nothing', async ({ page }) => {
    const { client, at } = await begin(page);
    const before = await times(page);
    await drag(client, [at(0.5, 0.9)], [{ x: at(0.5).x, y: at(0.5).y - 300 }], 12);
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(100);
    expect(await times(page)).toEqual(before);
  });
});

test('without a screen to touch nothing of it is loaded', async ({ page }) => {
  const asked: string[] = [];
  page.on('request', (request) => asked.push(request.url()));
  await open(page);
  expect(asked.filter((url) => /touch/.test(url))).toEqual([]);
});
