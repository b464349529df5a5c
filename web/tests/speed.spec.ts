// How quick the page is, measured in the browser and printed. Goals are stated beside each figure. A shared machine may miss those of time, so a
// test holds them against something bare that the same browser does in the same run: a redraw of the same points, empty frames, the loading of
// the same files; sizes are held as they are.
import { cpus, loadavg } from 'node:os';
import { openModes } from './modes';
import { expect, open, test } from './page';

/** Times a bare redraw of the force plot that a move of the slider may take, at the median. Measured: 10 with nine busy processes on two cores. */
const MOST_REDRAWS = 20;
/** Hits that are measured, and how many times a move of the slider to the plots, with an empty frame, one may take to its first frame, at the median. */
const HITS = 20;
const MOST_MOVES = 3;
/** Share of the frames of an empty page that the animation holds at least. */
const LEAST_FRAMES = 0.5;
/** Times the bare loading of its own files that the first curves may take. Measured: 6. */
const MOST_LOADS = 12;
/** Times the modes at one length that the lines over 49 may take, in the engine's first call of either. Measured: 18 to 43. */
const MOST_SHAPES = 90;

// What else a shared machine does at that moment is no property of the page: one of three runs has to hold.
test.describe.configure({ retries: 2 });

const quantile = (values: number[], share: number): number =>
  [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))] ?? NaN;

for (const [what, hash] of [
  ['nothing kept', ''],
  ['beside a kept state', '#S_T&@kept="S_T%26spring.mass%3D80%2Bg"'],
] as const)
  test(`from the slider to redrawn plots, ${what}`, async ({ page }) => {
    await open(page, hash);
    await expect(page.locator('.beside')).toHaveCount(hash ? 1 : 0);
    // Its case is computed while the present one rests.
    if (hash) await expect(page.locator('.beside .status')).toHaveText(/exact|verdict/, { timeout: 30_000 });
    await page.getByRole('button', { name: 'Pause' }).click();
    // One input a frame, as a drag gives them, and between them a bare redraw now and then.
    const bare = await page.evaluate(async () => {
      const slider = document.querySelector<HTMLInputElement>('input[aria-label="How hard it is hit, slider"]')!;
      const bare: number[] = [];
      for (let step = 0; step < 200; step++) {
        slider.value = String(200 + (step % 100) * 3);
        slider.dispatchEvent(new Event('input', { bubbles: true }));
        await new Promise((resolve) => setTimeout(resolve, 50));
        if (step % 4 === 0) bare.push(await window.coilsense.redraw());
      }
      return bare;
    });
    const measured = await page.evaluate(() =>
      performance.getEntriesByName('slider to plots').map(({ duration }) => duration),
    );
    const [median, late] = [quantile(measured, 0.5), quantile(measured, 0.95)];
    const redraws = median / quantile(bare, 0.5);
    console.log(
      `slider to redrawn plots, S_T, four forces, ${what}: median ${median.toFixed(1)} ms (goal 16), 95 % within ${late.toFixed(1)} ms (goal 33), ` +
        `${redraws.toFixed(1)} times a bare redraw of ${quantile(bare, 0.5).toFixed(1)} ms, ${measured.length} moves`,
    );
    expect(measured.length).toBeGreaterThan(100);
    expect(redraws).toBeLessThan(MOST_REDRAWS);
  });

test('from the hand that lets go to the first frame of its hit', async ({ page }) => {
  await open(page);
  await expect(page.locator('.strike')).toBeVisible();
  const { hits, moves, frames } = await page.evaluate(async (many) => {
    const strike = document.querySelector<HTMLElement>('.strike')!;
    const slider = document.querySelector<HTMLInputElement>('input[aria-label="How hard it is hit, slider"]')!;
    const { left, top, width, height } = strike.getBoundingClientRect();
    strike.setPointerCapture = () => {};
    const send = (type: string, x: number) => {
      const place = { clientX: left + width / 2 + x, clientY: top + height / 2 };
      strike.dispatchEvent(new PointerEvent(type, { isPrimary: true, bubbles: true, ...place }));
    };
    const of = (name: string) => performance.getEntriesByName(name).map(({ duration }) => duration);
    const wait = (milliseconds: number) => new Promise((resolve) => setTimeout(resolve, milliseconds));
    const frame = () => new Promise<number>((resolve) => requestAnimationFrame(resolve));
    const more = async (name: string, than: number) => {
      for (const begun = performance.now(); of(name).length <= than && performance.now() - begun < 5000;) await wait(5);
    };
    const moves: number[] = [];
    const frames: number[] = [];
    for (let hit = 0; hit < many; hit++) {
      send('pointerdown', 0);
      for (let step = 1; step <= 5; step++) {
        await wait(10);
        send('pointermove', (8 + hit) * step);
      }
      send('pointerup', (8 + hit) * 5);
      await more('hit to first frame', hit);
      // Until the exact case is there, too: a hit at rest is what is measured.
      await wait(500);
      const before = of('slider to plots').length;
      slider.value = String(200 + 3 * hit);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
      await more('slider to plots', before);
      moves.push(of('slider to plots').at(-1) ?? NaN);
      await wait(500);
      frames.push(-(await frame()) + (await frame()));
    }
    return { hits: of('hit to first frame'), moves, frames };
  }, HITS);
  const [median, bare] = [quantile(hits, 0.5), quantile(moves, 0.5) + quantile(frames, 0.5)];
  console.log(
    `pointerup to the first frame of the hit, S_T: median ${median.toFixed(1)} ms (goal 50), 95 % within ${quantile(hits, 0.95).toFixed(1)} ms; ` +
      `slider to plots and one frame beside it ${bare.toFixed(1)} ms; ${hits.length} hits, load of the machine ${loadavg()[0]?.toFixed(1)} on ${cpus().length} cores`,
  );
  expect(hits).toHaveLength(HITS);
  expect(median / bare).toBeLessThan(MOST_MOVES);
});

test('frames per second of the animation', async ({ page, context }) => {
  await open(page);
  await page.waitForTimeout(2500);
  const held = await page.evaluate(() => window.coilsense.framesPerSecond());
  const empty = await context.newPage();
  const possible = await empty.evaluate(async () => {
    const frame = () => new Promise<number>((resolve) => requestAnimationFrame(resolve));
    const begun = await frame();
    let now = begun;
    let count = 0;
    for (; now - begun < 2000; count++) now = await frame();
    return (1e3 * count) / (now - begun);
  });
  console.log(`animation: ${held.toFixed(1)} frames per second (goal 60), an empty page ${possible.toFixed(1)}`);
  expect(held / possible).toBeGreaterThan(LEAST_FRAMES);
});

test('first load and time until it can be used', async ({ page }) => {
  await page.addInitScript(() => {
    const mark = () => {
      if (document.body?.dataset['exact'] === 'true') performance.mark('exact case');
    };
    new MutationObserver(mark).observe(document, { subtree: true, attributeFilter: ['data-exact'] });
  });
  await open(page);
  const { bytes, whole, interactive, files } = await page.evaluate(() => {
    const [own] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[];
    const all = performance.getEntriesByType('resource') as PerformanceResourceTiming[];
    // What comes later than that keeps nobody waiting either; it may be here by now, or not.
    const exact = performance.getEntriesByName('exact case')[0]?.startTime ?? NaN;
    const interactive = performance.getEntriesByName('first curves')[0]?.startTime ?? NaN;
    const sizes = (of: PerformanceResourceTiming[]) =>
      (own?.encodedBodySize ?? 0) + of.reduce((sum, entry) => sum + entry.encodedBodySize, 0);
    // What comes after the first curves keeps nobody waiting for them.
    const first = all.filter(({ startTime }) => startTime < interactive);
    return {
      bytes: sizes(first),
      whole: sizes(all.filter(({ startTime }) => startTime < exact)),
      interactive,
      files: first.map(({ name }) => name),
    };
  });
  // The same files once more, and the engine compiled: nothing can be drawn before that.
  const bare = await page.evaluate(async (files) => {
    const begun = performance.now();
    const load = async (file: string) => {
      const reply = await fetch(file, { cache: 'reload' });
      await (file.endsWith('.wasm') ? WebAssembly.compileStreaming(reply) : reply.text());
    };
    await Promise.all(files.map(load));
    return performance.now() - begun;
  }, files);
  console.log(
    `first load ${(bytes / 1000).toFixed(0)} kB compressed by gzip, ${(whole / 1000).toFixed(0)} kB with what had come by the exact case (goal 500), first curves after ${interactive.toFixed(0)} ms (goal 1000), ` +
      `${(interactive / bare).toFixed(1)} times what its files take to load and compile`,
  );
  expect(bytes).toBeGreaterThan(100_000);
  // The goal is 500; what is left of it is not there to be used up unseen: the helix took 45 of it, since a spec's f1 is the helix's, and 8 what
  // its lines and shapes are asked by, what says and mends faults 2, hits, verdict and their places 2.5, the speed of a recording 0.4; the parts themselves are loaded later.
  expect(bytes).toBeLessThan(486_400);
  expect(whole).toBeLessThan(500_000);
  expect(interactive / bare).toBeLessThan(MOST_LOADS);
});

test('the lines of every mode over 49 lengths, and the modes at one', async ({ page }) => {
  await open(page);
  const part = await openModes(page);
  const slider = part.getByRole('slider', { name: 'Length' });
  for (let stop = 0; stop < 20; stop++) {
    await slider.fill(String(stop));
    await page.waitForTimeout(60);
  }
  const told = await page.evaluate(() => {
    const of = (name: string) => performance.getEntriesByName(name).map(({ duration }) => duration);
    return { lines: of('engine modes'), shapes: of('engine shape') };
  });
  const [lines, shape] = [quantile(told.lines, 0.5), quantile(told.shapes, 0.5)];
  console.log(
    `every mode of S_T: lines over 49 lengths with two ways of the ends ${lines.toFixed(0)} ms (goal 300), all modes at a length and one ` +
      `with its shape ${shape.toFixed(1)} ms, median of ${told.shapes.length}`,
  );
  expect(told.shapes.length).toBeGreaterThan(5);
  // 98 spots at less than half the cost, since kinds are looked at in every eighth length only.
  expect(lines / shape).toBeLessThan(MOST_SHAPES);
});
