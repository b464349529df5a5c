// A page that watches itself: a test fails on any console error and on any request that leaves the page's own origin.
import { test as base, expect, type Page } from '@playwright/test';
import type { ExactFacts } from '../src/answer';
import type { Shown } from '../src/compute';
import type { Outcome } from '../src/results/outcome';

export { expect };

export const test = base.extend<{ watched: string[] }>({
  watched: [
    async ({ page, baseURL }, use) => {
      const complaints: string[] = [];
      const origin = new URL(baseURL ?? '').origin;
      page.on(
        'console',
        (message) =>
          ['error', 'warning'].includes(message.type()) &&
          // As `playwright.config` has it.
          !message.text().includes('Service Worker registration blocked by Playwright') &&
          complaints.push(`console: ${message.text()}`),
      );
      page.on('pageerror', (error) => complaints.push(`error: ${error.message}`));
      page.on('request', (request) => {
        const { protocol, origin: asked } = new URL(request.url());
        if (asked !== origin && !['data:', 'blob:', 'file:'].includes(protocol))
          complaints.push(`request: ${request.url()}`);
      });
      await use(complaints);
      expect(complaints, 'what the page complained of or asked for elsewhere').toEqual([]);
    },
    { auto: true },
  ],
});

/** For `test.use` where what moves by itself is looked at: else it stands still, but in the long proof. */
export const MOVING = { contextOptions: { reducedMotion: 'no-preference' } } as const;

declare global {
  interface Window {
    coilsense: {
      framesPerSecond(): number;
      last(): Shown | null;
      verdict(): Outcome | null;
      redraw(): Promise<number>;
    };
  }
}

/** Opens the page with a state in its address and waits for exact numbers. */
export async function open(page: Page, hash = ''): Promise<void> {
  await page.goto(`./${hash}`);
  await exact(page);
}

/** Waits until what is shown is exact. */
export async function exact(page: Page): Promise<void> {
  await page.waitForFunction(() => document.body.dataset['exact'] === 'true', null, { timeout: 30_000 });
}

/** Opens all that is folded, the verdict's details with it: they come later than the rest. */
export async function unfold(page: Page): Promise<void> {
  await expect(page.locator('.trust .answer')).toBeVisible({ timeout: 60_000 });
  const closed = page.locator('details:not([open]) > summary:visible');
  for (let left = await closed.count(); left > 0; left = await closed.count()) await closed.first().click();
}

/** The exact facts of what is shown. */
export async function facts(page: Page): Promise<ExactFacts> {
  await exact(page);
  const found = await page.evaluate(() => window.coilsense.last()?.exact?.facts ?? null);
  if (!found) throw new Error('no exact case');
  return found;
}

/** A series of the curves that are shown. */
export const series = (page: Page, name: string): Promise<number[]> =>
  page.evaluate((name) => [...(window.coilsense.last()?.answer.series[name] ?? [])], name);
