// Films of what is shown: as long and as large as they say, of pictures that move, the same again and again; cancelled, and where a browser writes none.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import AxeBuilder from '@axe-core/playwright';
import type { Download, Page } from '@playwright/test';
import type * as Gif from '../src/record/gif';
import { gif, webm } from './films';
import { typical } from './long';
import { expect, MOVING, open, test } from './page';

test.use(MOVING);

const MOST = 20e6;
const bytes = async (download: Download): Promise<Buffer> => readFileSync(await download.path());
const filmed = (page: Page) => page.locator('.filmed');
const press = (page: Page, kind: 'WebM' | 'GIF') => page.getByRole('button', { name: `Film (${kind})` }).click();

async function film(page: Page, kind: 'WebM' | 'GIF'): Promise<Download> {
  const coming = page.waitForEvent('download', { timeout: 90_000 });
  await press(page, kind);
  return coming;
}

/** What a browser makes of a file: its size, how long it is, how many dots differ from each looked-at picture to the next, and one of them as a PNG. */
const played = (page: Page, file: Buffer, type: string, shares: number[]) =>
  page.evaluate(
    async ([base64, type, shares]) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const canvas = document.createElement('canvas');
      const context = canvas.getContext('2d', { willReadFrequently: true })!;
      const apart: number[] = [];
      let [before, corner, png]: [Uint8ClampedArray | null, number[], string] = [null, [], ''];
      const look = (image: CanvasImageSource, width: number, height: number) => {
        [canvas.width, canvas.height] = [width, height];
        context.drawImage(image, 0, 0);
        const { data } = context.getImageData(0, 0, width, height);
        let count = 0;
        // Dots that differ by more than a tenth of the scale.
        if (before) for (let at = 0; at < data.length; at++) if (Math.abs(data[at]! - before[at]!) > 25) count++;
        if (before) apart.push(count);
        if (apart.length === 1) png = canvas.toDataURL().split(',')[1]!;
        before = data;
        corner = [...context.getImageData(width / 2, 3, 1, 1).data];
      };
      const told = () => ({ width: canvas.width, height: canvas.height, apart, corner, png });
      if (type === 'image/gif') {
        const decoder = new ImageDecoder({ data: bytes, type });
        await decoder.tracks.ready;
        await decoder.completed;
        const count = decoder.tracks.selectedTrack!.frameCount;
        for (const share of shares) {
          const { image } = await decoder.decode({ frameIndex: Math.round(share * (count - 1)) });
          look(image, image.displayWidth, image.displayHeight);
        }
        return { ...told(), duration: NaN };
      }
      const video = document.createElement('video');
      video.muted = true;
      video.src = URL.createObjectURL(new Blob([bytes], { type }));
      await new Promise((done, failed) => {
        video.onloadeddata = done;
        video.onerror = () => failed(new Error(video.error?.message));
      });
      for (const share of shares) {
        // A seek is over before its picture is there.
        const shown = new Promise<void>((done) => {
          video.requestVideoFrameCallback(() => done());
          setTimeout(done, 1000);
        });
        const sought = new Promise((done) => (video.onseeked = done));
        video.currentTime = Math.max(0.01, share * (video.duration - 0.02));
        await Promise.all([sought, shown]);
        look(video, video.videoWidth, video.videoHeight);
      }
      return { ...told(), duration: video.duration };
    },
    [file.toString('base64'), type, shares] as const,
  );

/** Keeps a picture for people to look at. */
function keep(name: string, png: string): void {
  const folder = process.env['COILSENSE_PICTURES'];
  if (folder) writeFileSync(`${folder}/${name}.png`, Buffer.from(png, 'base64'));
}

for (const [colorScheme, hash, ground] of typical([
  ['light', '#S_T&@slow=0.05', [255, 255, 255]],
  ['dark', '#S_A&@condition=4&@slow=0.1', [20, 22, 26]],
] as const))
  test(`WebM of ${hash} in ${colorScheme}: every picture at its time, and it moves`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await open(page, hash);
    const download = await film(page, 'WebM');
    expect(download.suggestedFilename()).toMatch(/^S_[TA]-.*\.webm$/);
    const file = await bytes(download);
    expect(file.length).toBeLessThan(MOST);
    const told = webm(file);
    // As fast as the player: what is shown at its speed.
    const [seconds, slow] = await page.evaluate(() => {
      const [from, to] = window.coilsense.last()!.times;
      return [to - from, Number(document.querySelector<HTMLSelectElement>('.player select')!.value)];
    });
    expect(told.duration).toBeCloseTo(1e3 * Math.min(12, Math.max(2, seconds! / slow!)), -2);
    expect(told.times).toHaveLength(Math.round(0.03 * told.duration));
    // Deterministic: thirty a second, whatever the machine did meanwhile.
    expect(told.times.every((time, number) => Math.abs(time - (1e3 * number) / 30) <= 1)).toBe(true);
    expect([told.width, told.height]).toEqual([1280, 720]);
    expect(told.cues).toEqual(told.clusters);
    expect(told.title).toContain(hash.slice(1, 4));
    const { width, height, duration, apart, corner, png } = await played(page, file, 'video/webm', [0, 0.13, 0.5, 1]);
    keep(`webm-${colorScheme}`, png);
    expect([width, height]).toEqual([1280, 720]);
    expect(1e3 * duration).toBeCloseTo(told.duration, -2);
    for (const dots of apart) expect(dots).toBeGreaterThan(500);
    // The ground, as the page is.
    for (const at of [0, 1, 2]) expect(Math.abs(corner[at]! - ground[at]!)).toBeLessThan(6);
    await expect(filmed(page)).toHaveText(/^Saved: \d.*s, [\d.]+ MB\.$/);
    console.log(`WebM of ${hash}: ${told.times.length} pictures, ${(file.length / 1e6).toFixed(2)} MB`);
    expect((await new AxeBuilder({ page }).include('.downloads').analyze()).violations).toEqual([]);
  });

test('GIF: the same film is the same bytes, its pictures move, and one goes on where the one before was', async ({
  page,
}) => {
  test.setTimeout(240_000);
  await open(page, '#S_T&@times=[0,0.02]&@slow=0.005');
  const file = await bytes(await film(page, 'GIF'));
  const told = gif(file);
  expect([told.width, told.height]).toEqual([800, 450]);
  expect(told.duration).toBe(60 * told.times.length);
  expect(told.duration).toBeCloseTo(4000, -2);
  expect(file.length).toBeLessThan(MOST);
  const { apart, corner, png } = await played(page, file, 'image/gif', [0, 0.4, 1]);
  keep('gif', png);
  for (const dots of apart) expect(dots).toBeGreaterThan(500);
  // A picture holds what has changed only: what has not is there all the same.
  expect(corner).toEqual([255, 255, 255, 255]);
  await expect(filmed(page)).toHaveText(/^Saved/);
  // Play, sound and size of the window change nothing.
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.setViewportSize({ width: 390, height: 844 });
  const again = await bytes(await film(page, 'GIF'));
  expect(again.equals(file)).toBe(true);
  console.log(`GIF: ${told.times.length} pictures, ${(file.length / 1e6).toFixed(2)} MB`);
});

test('what is edited while a film is made does not change it, and the film says the state of before', async ({
  page,
}) => {
  await open(page, '#S_T&@times=[0,0.01]&@slow=0.005');
  const whole = await bytes(await film(page, 'GIF'));
  await expect(filmed(page)).toHaveText(/^Saved/);
  const coming = page.waitForEvent('download', { timeout: 90_000 });
  await press(page, 'GIF');
  await expect(filmed(page)).toContainText('Recording');
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.getByLabel('Mass m', { exact: true }).fill('90 g');
  expect((await bytes(await coming)).equals(whole)).toBe(true);
});

test('cancelled, nothing is saved, and the next one is whole', async ({ page }) => {
  await open(page, '#S_T&@slow=0.01');
  let saved = 0;
  page.on('download', () => (saved += 1));
  await press(page, 'WebM');
  const bar = page.getByRole('progressbar', { name: 'Pictures of the film' });
  await expect.poll(() => bar.evaluate((one: HTMLProgressElement) => one.value)).toBeGreaterThan(0);
  // A second press meanwhile begins no second film.
  await press(page, 'GIF');
  const cancel = filmed(page).getByRole('button', { name: 'Cancel' });
  await cancel.focus();
  await page.keyboard.press('Enter');
  await expect(filmed(page)).toHaveText('Cancelled: nothing is saved.');
  await expect(bar).toHaveCount(0);
  await expect(page.getByRole('button', { name: /^Film/ }).first()).toBeVisible();
  expect(saved).toBe(0);
  await page.goto('about:blank');
  await open(page, '#S_T&@times=[0,0.01]&@slow=0.005');
  expect(webm(await bytes(await film(page, 'WebM'))).times).toHaveLength(60);
});

test('an encoder that is slow has the processor for itself: it is not asked again and again', async ({ page }) => {
  await page.addInitScript(() => {
    const post = MessagePort.prototype.postMessage;
    const counted = window as unknown as { posts: number };
    counted.posts = 0;
    MessagePort.prototype.postMessage = function (this: MessagePort, ...content: [unknown]) {
      counted.posts++;
      post.apply(this, content);
    };
  });
  await open(page, '#S_T&@times=[0,0.01]&@slow=0.005');
  const before = await page.evaluate(() => (window as unknown as { posts: number }).posts);
  expect(webm(await bytes(await film(page, 'WebM'))).times).toHaveLength(60);
  const posts = (await page.evaluate(() => (window as unknown as { posts: number }).posts)) - before;
  expect(posts).toBeGreaterThan(59);
  expect(posts).toBeLessThan(60 * 100);
});

// An empty page, where these run before, is no place for an encoder in every browser.
for (const [what, without] of typical([
  ['without VideoEncoder', () => Reflect.deleteProperty(window, 'VideoEncoder')],
  [
    'without a codec',
    () => {
      if (window.isSecureContext) VideoEncoder.isConfigSupported = async (config) => ({ supported: false, config });
    },
  ],
  [
    'whose encoder fails',
    () => {
      if (window.isSecureContext)
        VideoEncoder.prototype.encode = () => {
          throw new DOMException('no memory', 'OperationError');
        };
    },
  ],
] as const))
  test(`a browser ${what} saves a GIF, and says so`, async ({ page }) => {
    await page.addInitScript(without);
    await open(page, '#S_T&@times=[0,0.01]&@slow=0.005');
    const download = await film(page, 'WebM');
    expect(download.suggestedFilename()).toMatch(/\.gif$/);
    expect(gif(await bytes(download)).times).toHaveLength(33);
    await expect(filmed(page)).toHaveText(/^This browser.* GIF\. Saved/);
  });

test('a spec that cannot be computed yet waits for its film, which can be cancelled', async ({ page }) => {
  await open(page, '#S_T');
  await page.getByLabel('Mass m', { exact: true }).fill('nothing');
  await expect(page.locator('#spring-mass-error')).toBeVisible();
  await page.evaluate(() => (window.coilsense.last()!.exact = null));
  await press(page, 'WebM');
  await expect(filmed(page)).toContainText('Waiting for the exact case');
  await filmed(page).getByRole('button', { name: 'Cancel' }).click();
  await expect(filmed(page)).toHaveText('Cancelled: nothing is saved.');
});

test('other presets: recorded motion, windings that touch, readings and hidden curves', async ({ page }) => {
  test.setTimeout(240_000);
  for (const hash of [
    '#valve&@slow=0.05',
    '#suspension&@slow=1',
    '#S_T&condition.0.velocity=8+m/s&@slow=0.05&@hidden=["F_L"]&@sensors=["load+cell,+load+side"]',
  ]) {
    await page.goto('about:blank');
    await open(page, hash);
    const file = await bytes(await film(page, 'WebM'));
    const { apart, png } = await played(page, file, 'video/webm', [0.3, 0.6]);
    expect(apart[0]).toBeGreaterThan(500);
    keep(`webm-${hash.replace(/\W+/g, '').slice(0, 12)}`, png);
  }
});

test('a GIF is made smaller until it is small enough; one that never is, is refused', async ({ page }) => {
  await open(page);
  const script = readdirSync(new URL('../dist/assets/', import.meta.url)).find((name) => name.startsWith('gif-'));
  const { base64, widths, refused } = await page.evaluate(async (script) => {
    const { gif } = (await import(new URL(script, location.href).href)) as typeof Gif;
    // Dots in sixteen levels at random: nothing is harder to compress.
    let seed = 1;
    const widths: number[] = [];
    const canvas = document.createElement('canvas');
    const draw = (_: number, width: number) => {
      if (!widths.includes(width)) widths.push(width);
      [canvas.width, canvas.height] = [width, Math.round(width / 8)];
      const image = new ImageData(canvas.width, canvas.height);
      image.data.forEach(
        (_, at) => (image.data[at] = at % 4 === 3 ? 255 : ((seed = (seed * 16807) % 2147483647) & 15) << 4),
      );
      canvas.getContext('2d', { willReadFrequently: true })!.putImageData(image, 0, 0);
      return canvas;
    };
    const source = { title: 'noise', seconds: 2, draw };
    const making = { told: () => {}, signal: new AbortController().signal };
    const { blob } = await gif(source, making, 7e5);
    const bytes = new Uint8Array(await blob.arrayBuffer());
    const refused = await gif(source, making, 1e4).then(
      () => '',
      (reason: Error) => reason.message,
    );
    return { base64: btoa(bytes.reduce((text, byte) => text + String.fromCharCode(byte), '')), widths, refused };
  }, `assets/${script}`);
  const file = Buffer.from(base64, 'base64');
  expect(file.length).toBeLessThan(7e5);
  expect(widths.slice(0, 3)).toEqual([800, 640, 480]);
  expect(gif(file).duration).toBeCloseTo(2000, -2);
  expect(refused).toContain('larger than 0.01 MB');
});
