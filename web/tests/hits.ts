// Hands on the spring of the page, and what it says of them.
import type { Page } from '@playwright/test';
import { expect } from './page';

interface Here {
  x: number;
  y: number;
  /** Ends, and pixels to a metre. */
  ends: [number, number];
  scale: number;
}

/** Where the coil is on the screen, at rest: the canvas leaves nine hundredths of its width free at either end, 44 to 110 pixels. */
export async function coil(page: Page): Promise<Here> {
  const strike = page.locator('.strike');
  await strike.scrollIntoViewIfNeeded();
  const { x, y, height } = (await strike.boundingBox())!;
  // As the page has it: in whole pixels, which is not what every browser makes of the layout.
  const width = await strike.evaluate((one) => one.clientWidth);
  const margin = Math.min(110, Math.max(44, 0.09 * width));
  const span = await page.evaluate(() => {
    const { positions, columns } = window.coilsense.last()!.frames;
    const one = [...positions].filter((_, index) => index % columns === 0);
    const two = [...positions].filter((_, index) => index % columns === columns - 1);
    return Math.max(...two) - Math.min(...one);
  });
  const scale = (width - 2 * margin) / span;
  return { x: x + width / 2, y: y + (height - 28) / 2, ends: [x + margin, x + width - margin], scale };
}

/** A hand as events of the page's own, with the times that they would have: no machine is too slow for it. Places from the middle. */
export const hand = (page: Page, track: [x: number, y: number, time: number][], last = 'pointerup'): Promise<void> =>
  page.evaluate(
    ([track, last]) => {
      const strike = document.querySelector<HTMLElement>('.strike')!;
      const { left, top, width, height } = strike.getBoundingClientRect();
      const begun = performance.now() - track[track.length - 1]![2];
      const send = (type: string, [x, y, time]: [number, number, number]) => {
        const event = new PointerEvent(type, {
          pointerId: 1,
          isPrimary: true,
          pointerType: 'mouse',
          bubbles: true,
          clientX: left + width / 2 + x,
          clientY: top + height / 2 + y,
        });
        Object.defineProperty(event, 'timeStamp', { value: begun + time });
        strike.dispatchEvent(event);
      };
      strike.setPointerCapture = () => {};
      send('pointerdown', track[0]!);
      for (const one of track.slice(1)) send('pointermove', one);
      send(last, track[track.length - 1]!);
    },
    [track, last] as const,
  );

/** Evenly along the coil, so many pixels in so many milliseconds. */
export const flick = (pixels: number, milliseconds: number): [number, number, number][] =>
  Array.from({ length: 11 }, (_, step) => [(pixels * step) / 10, 0, (milliseconds * step) / 10]);

/** How fast the middle winding moves in the first millisecond of what is shown [m/s]. */
export const speedOfMiddle = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const { times, positions, columns } = window.coilsense.last()!.frames;
    const middle = Math.floor(columns / 2);
    return (positions[10 * columns + middle]! - positions[middle]!) / (times[10]! - times[0]!);
  });

export const ready = (page: Page) => expect(page.locator('.strike')).toBeVisible();
export const velocity = (page: Page) => page.getByLabel('How hard it is hit', { exact: true });
export const said = (page: Page) => page.locator('.struck');
export const begun = (page: Page) => page.evaluate(() => performance.getEntriesByName('hit to first frame').length);
export const undo = (page: Page) => page.getByRole('button', { name: 'Undo' });

/** Waits for the first picture of a hit after so many. */
export const after = (page: Page, hits: number) => expect.poll(() => begun(page)).toBeGreaterThan(hits);
