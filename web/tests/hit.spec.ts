// The spring is hit by mouse, finger and keys: what is computed is that very hit, what is drawn first is of it, and what was no hit is none.
import { after, begun, coil, flick, hand, ready, said, speedOfMiddle, undo, velocity } from './hits';
import { typical } from './long';
import { exact, expect, facts, MOVING, open, series, test } from './page';

test.use(MOVING);

test('a click hits as hard as what is shown says, from t = 0, and the wave runs', async ({ page }) => {
  await open(page, '#S_T&condition.0.velocity=0.4+m/s');
  await ready(page);
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.getByRole('slider', { name: 'Time', exact: true }).fill('900');
  const { x, y } = await coil(page);
  await page.mouse.click(x, y);
  await after(page, 0);
  await expect(velocity(page)).toHaveValue('0.4 m/s');
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
  // From the beginning: nine tenths of 111 ms are 100.
  expect(parseFloat((await page.locator('.clock').textContent())!)).toBeLessThan(90);
  await expect(said(page)).toHaveText('Your hit: 0.4 m/s towards end 2.');
  // The same once more changes nothing: there is nothing to undo.
  await expect(undo(page)).toBeDisabled();
});

test('a flick is as fast as the hand, in the coil’s own metres, either way', async ({ page }) => {
  await open(page);
  await ready(page);
  const { scale } = await coil(page);
  for (const [pixels, milliseconds] of [
    [120, 100],
    [-90, 150],
  ] as const) {
    const hits = await begun(page);
    await hand(page, flick(pixels, milliseconds));
    await after(page, hits);
    const speed = Math.round((1e6 * pixels) / scale / milliseconds) / 1e3;
    await expect(velocity(page)).toHaveValue(`${speed} m/s`);
    // The engine's windings move as fast.
    // Positions are written with 24 bits: 8e-9 m of 0.1 m, here over a millisecond.
    expect(Math.abs((await speedOfMiddle(page)) - speed)).toBeLessThan(2e-5);
  }
  await undo(page).click();
  await expect(velocity(page)).toHaveValue(`${Math.round(1.2e6 / scale) / 1e3} m/s`);
  await undo(page).click();
  await expect(velocity(page)).toHaveValue('0.25 m/s');
  await expect(undo(page)).toBeDisabled();
});

test('only the last 80 ms count, and a hand at rest is no hit', async ({ page }) => {
  await open(page);
  await ready(page);
  const { scale } = await coil(page);
  const slow = Array.from({ length: 50 }, (_, step): [number, number, number] => [-step * 4, 0, step * 8]);
  const quick = Array.from({ length: 12 }, (_, step): [number, number, number] => [
    -196 + step * 10,
    0,
    400 + step * 8,
  ]);
  await hand(page, [...slow, ...quick]);
  await after(page, 0);
  await expect(velocity(page)).toHaveValue(`${Math.round(1e3 * (10 / 0.008 / scale)) / 1e3} m/s`);
  await page.getByRole('button', { name: 'Undo' }).click();
  await exact(page);
  const hits = await begun(page);
  const track = flick(150, 100);
  await hand(page, [...track, [150, 0, 100.5], [150, 0, 300]]);
  await expect(said(page)).toContainText('No hit: the hand was still');
  await expect(velocity(page)).toHaveValue('0.25 m/s');
  expect(await begun(page)).toBe(hits);
});

test('what meant to scroll, to select, or was let be is no hit', async ({ page }) => {
  await open(page);
  await ready(page);
  const { x, y } = await coil(page);
  const before = page.url();
  // Up and down; the wrong button; cancelled by the browser, which scrolls; a drag that began elsewhere and ends here.
  await hand(page, [
    [0, 0, 0],
    [3, 20, 20],
    [60, 30, 40],
  ]);
  await page.mouse.click(x, y, { button: 'right' });
  await page.keyboard.press('Escape');
  await hand(page, flick(100, 80), 'pointercancel');
  await page.mouse.move(x, y + 330);
  await page.mouse.down();
  await page.mouse.move(x, y, { steps: 4 });
  await page.mouse.up();
  // Escape while it is in the hand.
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y, { steps: 3 });
  await expect(page.locator('.how')).toHaveText(/^−?\d\.\d\d m\/s$/);
  await page.keyboard.press('Escape');
  await expect(page.locator('.how')).toBeHidden();
  await page.mouse.up();
  await expect(said(page)).toHaveText('Left alone: nothing was hit.');
  await expect(undo(page)).toBeDisabled();
  expect(await begun(page)).toBe(0);
  expect(page.url()).toBe(before);
});

test('an end that is pulled shows how far, and goes back from there when it is let go', async ({ page }) => {
  await open(page);
  await ready(page);
  const { ends, y, scale } = await coil(page);
  await page.mouse.move(ends[0] - 2, y);
  await page.mouse.down();
  await page.mouse.move(ends[0] - 2 - 0.012 * scale, y, { steps: 5 });
  await expect(page.locator('.how')).toHaveText(/^−1[12]\.\d mm$/);
  const pulled = parseFloat((await page.locator('.how').textContent())!.replace('−', '-'));
  await page.mouse.up();
  await after(page, 0);
  const told = await facts(page);
  expect(told.conditions[told.condition]).toMatchObject({ name: 'your pull', kind: 'ramp' });
  expect(told.meanLength).toBeCloseTo(0.23 - 1e-3 * pulled, 6);
  const [u1, last] = [await series(page, 'u1'), (await series(page, 'L')).at(-1)!];
  expect(u1[0]).toBe(0);
  expect(u1.at(-1)).toBeCloseTo(-1e-3 * pulled, 6);
  expect(last).toBeGreaterThan(0);
  // Back within a quarter of a wave's way.
  const times = await series(page, 'time');
  const arrived = times[u1.findIndex((at) => Math.abs(at + 1e-3 * pulled) < 1e-9)]!;
  expect(arrived).toBeGreaterThan(0.2 * told.spring.transitTime);
  expect(arrived).toBeLessThan(0.3 * told.spring.transitTime);
  await undo(page).click();
  await expect(page.locator('#condition option:checked')).toHaveText('heel strike');
  await expect(undo(page)).toBeDisabled();
});

test('a pull stays within the lengths in use, and an end in the hand that Escape lets go is back', async ({ page }) => {
  await open(page);
  await ready(page);
  await page.getByRole('button', { name: 'Pause' }).click();
  const { ends, y } = await coil(page);
  await page.mouse.move(ends[1] + 2, y);
  await page.mouse.down();
  await page.mouse.move(ends[1] - 250, y, { steps: 5 });
  // 230 mm less 196 mm.
  await expect(page.locator('.how')).toHaveText('−34.0 mm');
  await page.keyboard.press('Escape');
  await page.mouse.up();
  expect(await begun(page)).toBe(0);
  // What is drawn is the motion again.
  await page.getByRole('button', { name: 'Play' }).click();
  const clock = page.locator('.clock');
  const at = await clock.textContent();
  await expect(clock).not.toHaveText(at!);
});

for (const [hash, name] of typical([
  ['#S_T&@condition=3', 'harmonic'],
  ['#valve', 'recorded'],
  ['#suspension', 'recorded, on a mass'],
] as const))
  test(`a hit where what is shown is ${name} is a condition of its own, and the second one the same`, async ({
    page,
  }) => {
    await open(page, hash);
    await ready(page);
    const many = (await facts(page)).conditions.length;
    await page.getByRole('button', { name: 'Hit', exact: true }).click();
    await after(page, 0);
    const hit = await facts(page);
    expect(hit.conditions).toHaveLength(many + 1);
    expect(hit.conditions[hit.condition]).toMatchObject({ name: 'your hit', kind: 'impact' });
    await expect(velocity(page)).toHaveValue('0.25 m/s');
    const hits = await begun(page);
    await page.locator('.strike').focus();
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Enter');
    await after(page, hits);
    expect((await facts(page)).conditions).toHaveLength(many + 1);
    await expect(velocity(page)).toHaveValue('0.3 m/s');
    await undo(page).click();
    await undo(page).click();
    await expect(undo(page)).toBeDisabled();
    expect((await facts(page)).conditions).toHaveLength(many);
  });

test('keys alone choose the speed, hit, pull an end and let it go', async ({ page }) => {
  await open(page);
  await ready(page);
  const strike = page.getByRole('slider', { name: /^Your hit/ });
  await strike.focus();
  for (const key of ['ArrowLeft', 'Shift+ArrowLeft', 'ArrowUp']) await page.keyboard.press(key);
  // 0.25 less 0.05 less 0.25 and 0.05.
  await expect(strike).toHaveAttribute('aria-valuetext', '0 m/s towards end 2');
  await page.keyboard.press('Enter');
  await expect(said(page)).toContainText('Nothing happens at zero');
  await page.keyboard.press('ArrowLeft');
  await expect(page.locator('.how')).toHaveText('−0.05 m/s');
  await page.keyboard.press('Enter');
  await after(page, 0);
  await expect(velocity(page)).toHaveValue('-0.05 m/s');
  await page.keyboard.press('2');
  await page.keyboard.press('Shift+ArrowRight');
  await expect(strike).toHaveAttribute('aria-valuetext', 'end 2 by 5 mm towards end 2');
  await page.keyboard.press('Escape');
  await expect(strike).toHaveAttribute('aria-valuetext', '0.05 m/s towards end 1');
  await page.keyboard.press('2');
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Enter');
  await after(page, 1);
  const told = await facts(page);
  expect(told.conditions[told.condition]!.name).toBe('your pull');
  expect(told.meanLength).toBeCloseTo(0.235, 9);
  await page.getByRole('button', { name: 'Hit', exact: true }).focus();
  await page.keyboard.press('Enter');
  await after(page, 2);
  expect((await facts(page)).conditions.at(-1)!.name).toBe('your hit');
});

test('end 2 with a mass cannot be pulled, and that is said', async ({ page }) => {
  await open(page, '#suspension');
  await ready(page);
  await page.locator('.strike').focus();
  await page.keyboard.press('2');
  await expect(said(page)).toContainText('End 2 is not held');
  await expect(undo(page)).toBeDisabled();
});

test('a hit while the spring cannot be computed is none, and one that puts it right is one', async ({ page }) => {
  await open(page);
  await ready(page);
  const mass = page.getByLabel('Mass m', { exact: true });
  await mass.fill('-3 g');
  await expect(page.locator('#spring-mass-error')).toBeVisible();
  await page.getByRole('button', { name: 'Hit', exact: true }).click();
  await expect(said(page)).toContainText('Not hit: the spring cannot be computed');
  expect(await begun(page)).toBe(0);
  await mass.fill('65 g');
  await exact(page);
  await velocity(page).fill('very');
  await expect(page.locator('#condition-0-velocity-error')).toBeVisible();
  await page.getByRole('button', { name: 'Hit', exact: true }).click();
  await after(page, 0);
  await expect(velocity(page)).toHaveValue('0.25 m/s');
  await exact(page);
});

test('of two hits at once the second is shown, and each is undone by itself', async ({ page }) => {
  await open(page);
  await ready(page);
  const { scale } = await coil(page);
  await hand(page, flick(60, 100));
  await hand(page, flick(140, 100));
  const second = Math.round((1e4 * 140) / scale) / 1e3;
  await expect(velocity(page)).toHaveValue(`${second} m/s`);
  await after(page, 0);
  expect(Math.abs((await speedOfMiddle(page)) - second)).toBeLessThan(2e-5);
  await undo(page).click();
  await expect(velocity(page)).toHaveValue(`${Math.round((1e4 * 60) / scale) / 1e3} m/s`);
  await undo(page).click();
  await expect(velocity(page)).toHaveValue('0.25 m/s');
  await expect(undo(page)).toBeDisabled();
});

test('nothing of the old motion is drawn once the hand has let go', async ({ page }) => {
  await open(page);
  await ready(page);
  await page.evaluate(() => {
    const drawn: { at: number; since: number }[] = [];
    const clear = CanvasRenderingContext2D.prototype.clearRect;
    CanvasRenderingContext2D.prototype.clearRect = function (...box) {
      if (this.canvas.classList.contains('coil'))
        drawn.push({ at: performance.now(), since: window.coilsense.last()?.since ?? 0 });
      return clear.apply(this, box);
    };
    Object.assign(window, { drawn });
  });
  // While it runs, the coil is drawn in every frame.
  await page.waitForFunction(() => (window as unknown as { drawn: unknown[] }).drawn.length > 5);
  for (let hit = 0; hit < 5; hit++) {
    const hits = await begun(page);
    await hand(page, flick(60 + 20 * hit, 100));
    await after(page, hits);
  }
  const { old, fresh } = await page.evaluate(() => {
    const drawn = (window as unknown as { drawn: { at: number; since: number }[] }).drawn;
    const spans = performance
      .getEntriesByName('hit to first frame')
      .map(({ startTime, duration }) => ({ from: startTime, to: startTime + duration }));
    const within = drawn.filter(({ at }) => spans.some(({ from, to }) => at > from && at <= to));
    const isOld = ({ at, since }: { at: number; since: number }) =>
      spans.some(({ from, to }) => at > from && at <= to && since < from - 1e-3);
    return { old: within.filter(isOld).length, fresh: within.filter((one) => !isOld(one)).length };
  });
  expect(old).toBe(0);
  expect(fresh).toBeGreaterThanOrEqual(5);
});

test('where motion is not wanted a hit is shown still, with the wave half way', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page);
  await ready(page);
  await page.getByRole('button', { name: 'Hit', exact: true }).click();
  await after(page, 0);
  // 9.25 ms for one way.
  await expect(page.locator('.clock')).toHaveText('4.6 ms');
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
});

test('a finger scrolls the page up and down, hits by a tap, and the strip is not above the plot', async ({
  browser,
  baseURL,
}) => {
  const context = await browser.newContext({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    ...(baseURL ? { baseURL } : {}),
  });
  const page = await context.newPage();
  await open(page);
  await ready(page);
  expect(await page.locator('.strike').evaluate((one) => getComputedStyle(one).touchAction)).toBe('pan-y pinch-zoom');
  const top = (of: string) => page.locator(of).evaluate((one) => one.getBoundingClientRect().top);
  expect(await top('.wave')).toBeGreaterThan(await top('.plot.forces'));
  const { x, y } = await coil(page);
  const client = await context.newCDPSession(page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', at: [number, number][]) =>
    client.send('Input.dispatchTouchEvent', { type, touchPoints: at.map(([x, y]) => ({ x, y })) });
  const before = await page.evaluate(() => scrollY);
  await touch('touchStart', [[x, y]]);
  for (let step = 1; step <= 8; step++) await touch('touchMove', [[x, y - 20 * step]]);
  await touch('touchEnd', []);
  await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(before + 50);
  expect(await begun(page)).toBe(0);
  await expect(undo(page)).toBeDisabled();
  // A scroll goes on for a moment, and where the coil is then is where it is hit.
  let last = NaN;
  const rests = async () => {
    const at = await page.evaluate(() => scrollY);
    const same = at === last;
    last = at;
    return same;
  };
  await expect.poll(rests).toBe(true);
  const now = await coil(page);
  await touch('touchStart', [[now.x - 60, now.y]]);
  for (let step = 1; step <= 8; step++) await touch('touchMove', [[now.x - 60 + 12 * step, now.y]]);
  await touch('touchEnd', []);
  await after(page, 0);
  await expect(undo(page)).toBeEnabled();
  await context.close();
});

test('what could not be loaded is said, and had at the second try', async ({ page, watched }) => {
  let broken = true;
  await page.route(/\/hands-.*\.js$/, (route) => (broken ? route.abort() : route.continue()));
  await open(page);
  const wave = page.locator('.wave');
  const note = page
    .getByRole('alert')
    .filter({ hasText: 'What hits the spring and shows its wave could not be loaded' });
  await expect(note).toBeVisible();
  broken = false;
  await note.getByRole('button', { name: 'Try again' }).click();
  await ready(page);
  await expect(wave).toContainText('One way');
  // The browser's own words about the file.
  watched.splice(0, watched.length, ...watched.filter((words) => !words.includes('ERR_FAILED')));
});
