// The strip has the wave where the engine has it, and the sound is the force at end 2.
import AxeBuilder from '@axe-core/playwright';
import { ready } from './hits';
import { typical } from './long';
import { expect, facts, MOVING, open, test } from './page';

test.use(MOVING);

test('the strip tells the way of the wave, goes with the player, and is read by pointer and keys', async ({ page }) => {
  await open(page);
  await ready(page);
  const wave = page.getByRole('region', { name: 'The wave over position and time' });
  const { spring } = await facts(page);
  await expect(wave).toContainText(`One way, end to end: ${Number((1e3 * spring.transitTime).toPrecision(3))} ms`);
  expect(spring.transitTime).toBeCloseTo(9.25e-3, 5);
  await page.getByRole('button', { name: 'Pause' }).click();
  const time = page.getByRole('slider', { name: 'Time', exact: true });
  const line = wave.locator('.now');
  const at = () => line.evaluate((one) => one.getBoundingClientRect().top);
  await time.fill('30');
  const first = await at();
  await time.fill('60');
  await expect.poll(at).toBeGreaterThan(first + 3);
  const strip = wave.getByRole('group');
  await strip.focus();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowLeft');
  await expect(wave).toContainText(/At \d+ mm and \d+\.\d ms: [\d.]+ % (closer|wider)/);
  await page.keyboard.press('Enter');
  const told = Number(/and ([\d.]+) ms/.exec((await wave.textContent())!)![1]);
  await expect(page.locator('.clock')).toHaveText(`${told.toFixed(1)} ms`);
  const box = (await strip.boundingBox())!;
  await page.mouse.click(box.x + 0.8 * box.width, box.y + 0.4 * box.height);
  await expect(page.locator('.clock')).not.toHaveText(`${told.toFixed(1)} ms`);
});

test('a key that comes while the strip changes its size is told as soon as there is a picture', async ({ page }) => {
  await open(page);
  await ready(page);
  await page.getByRole('button', { name: 'Pause' }).click();
  const strip = page.getByRole('region', { name: 'The wave over position and time' }).getByRole('group');
  await strip.focus();
  // The keys come with the change itself, before the next picture.
  await strip.evaluate(async (host) => {
    const canvas = host.querySelector('canvas')!;
    const press = (key: string) => host.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
    press('ArrowLeft');
    await new Promise<void>((done) => {
      new ResizeObserver((_, observer) => {
        if (canvas.clientWidth > 150) return;
        observer.disconnect();
        for (let once = 0; once < 5; once++) press('ArrowLeft');
        done();
      }).observe(canvas);
      (host as HTMLElement).style.width = '150px';
    });
  });
  const { meanLength } = await facts(page);
  const place = (1e3 * meanLength * (0.5 - 6 * 0.02)).toFixed(0);
  await expect(page.getByRole('region', { name: 'The wave over position and time' })).toContainText(`At ${place} mm`);
});

test('the strip has the wave where the engine has it: its front is half way after half a way', async ({ page }) => {
  await open(page);
  await ready(page);
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.getByRole('slider', { name: 'Time', exact: true }).fill('0');
  const strip = page.locator('.strip');
  const colours = await strip.evaluate(async (host) => {
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const canvas = host.querySelector('canvas')!;
    const context = canvas.getContext('2d')!;
    // 46 and 8 pixels beside it, 18 above and 40 below; four ways from top to foot.
    const [width, height] = [canvas.width - 54, canvas.height - 58];
    const { data } = context.getImageData(46, 18, width, height);
    const at = (along: number, ways: number) => {
      const dot = 4 * (Math.round((ways / 4) * height) * width + Math.round(along * width));
      return [...data.slice(dot, dot + 3)];
    };
    const warmth = ([red = 0, , blue = 0]: number[]) => red - blue;
    return {
      behind: warmth(at(0.1, 0.3)),
      ahead: warmth(at(0.45, 0.15)),
      mirrored: warmth(at(0.9, 0.3)),
      later: warmth(at(0.1, 1.4)),
    };
  });
  // Hit towards end 2: wider behind end 1, closer before end 2, nothing yet in the middle; after one way the other way round.
  expect(colours.behind).toBeGreaterThan(60);
  expect(colours.mirrored).toBeLessThan(-60);
  expect(Math.abs(colours.ahead)).toBeLessThan(40);
  expect(colours.later).toBeLessThan(-60);
});

test('what end 2 feels is heard on request, softly, for three seconds at most', async ({ page }) => {
  await open(page);
  await ready(page);
  await page.evaluate(() => {
    const heard: { most: number; seconds: number; first: number; gains: number[] } = {
      most: 0,
      seconds: 0,
      first: 1,
      gains: [],
    };
    const copy = AudioBuffer.prototype.copyToChannel;
    AudioBuffer.prototype.copyToChannel = function (values, channel) {
      heard.most = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
      heard.seconds = values.length / this.sampleRate;
      heard.first = Math.abs(values[0]!) + Math.abs(values.at(-1)!);
      return copy.call(this, values, channel);
    };
    const ramp = AudioParam.prototype.linearRampToValueAtTime;
    AudioParam.prototype.linearRampToValueAtTime = function (value, time) {
      heard.gains.push(value);
      return ramp.call(this, value, time);
    };
    Object.assign(window, { heard });
  });
  const listen = page.getByRole('button', { name: 'Listen' });
  await listen.click();
  const stop = page.getByRole('button', { name: 'Stop', exact: true });
  await expect(stop).toHaveAttribute('aria-pressed', 'true');
  const wave = page.locator('.wave');
  // A blow to all windings at once swings in every second mode.
  const { lines } = await facts(page);
  const odd = [0, 2, 4].map((mode) => lines[mode]!.toFixed(0)).join(', ');
  await expect(wave).toContainText(`loudest at ${odd}`);
  const heard = await page.evaluate(
    () => (window as unknown as { heard: { most: number; seconds: number; first: number; gains: number[] } }).heard,
  );
  expect(heard.most).toBeGreaterThan(0.5);
  expect(heard.most).toBeLessThanOrEqual(1);
  expect(heard.gains).toEqual([0.3]);
  expect(heard.first).toBe(0);
  // The record lasts a second.
  expect(heard.seconds).toBeCloseTo(1, 2);
  await stop.click();
  await expect(listen).toHaveAttribute('aria-pressed', 'false');
  // Another spring ends it.
  await listen.click();
  await page.getByRole('button', { name: 'Hit', exact: true }).click();
  await page.getByRole('slider', { name: 'How hard it is hit, slider' }).fill('600');
  await expect(listen).toBeVisible();
  await expect(wave).not.toContainText('loudest');
});

for (const colorScheme of typical(['light', 'dark'] as const))
  test(`axe finds nothing in spring and strip while they are used, in ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await open(page);
    await ready(page);
    await page.getByRole('button', { name: 'Listen' }).click();
    await page.locator('.strip').focus();
    await page.keyboard.press('ArrowDown');
    await page.locator('.strike').focus();
    await page.keyboard.press('ArrowRight');
    await expect(page.locator('.how')).toBeVisible();
    const { violations } = await new AxeBuilder({ page }).include('.see').include('.wave').analyze();
    expect(violations).toEqual([]);
  });

test('a force that is steady is not heard, and where nothing can sound there is no button', async ({
  page,
  context,
}) => {
  await open(page, '#S_T&condition.0.velocity=0+m/s');
  await ready(page);
  await page.getByRole('button', { name: 'Listen' }).click();
  await expect(page.locator('.wave')).toContainText('Nothing to hear');
  await expect(page.getByRole('button', { name: 'Listen' })).toHaveAttribute('aria-pressed', 'false');
  const silent = await context.newPage();
  await silent.addInitScript(() => Reflect.deleteProperty(window, 'AudioContext'));
  await open(silent);
  await ready(silent);
  await expect(silent.getByRole('button', { name: 'Listen' })).toBeHidden();
  await silent.close();
});
