// Large logs: read piece by piece in bounded memory, with progress and a Cancel that leaves the page as it was.
//
// Next door: which columns are what without being told (`log-opens`), what is said of a log (`log`).
import {
  existsSync,
  readFileSync,
  writeFileSync,
  openSync,
  writeSync,
  closeSync,
  statSync,
  appendFileSync,
} from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { drop } from './jobs';
import { folder, rigLogs, settled } from './logs';
import { expect, test } from './page';

const large = join(folder, 'large.csv');
/** Rows of 51 bytes: 100 MB. */
const ROWS = 1_950_000;
const RATE = 2500;

/** A coil that is moved slowly and struck every 20 s: time, positions, and forces that ring. */
function writeLarge(): void {
  if (existsSync(large) && statSync(large).size > 1e8) return;
  const file = openSync(large, 'w');
  let state = 1;
  const noise = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 31 - 1;
  };
  let text = 'time [s],u1 [mm],u2 [mm],F_i [N],F_o [N]\n';
  for (let row = 0; row < ROWS; row++) {
    const t = row / RATE;
    const since = (t % 20) - 5;
    let ring = 0;
    if (since > 0 && since < 4)
      for (let mode = 1; mode < 4; mode++) {
        const turn = 2 * Math.PI * 54.06 * mode;
        ring += (2 / mode) * Math.exp(-0.005 * turn * since) * Math.sin(turn * since);
      }
    const u1 = 10 + Math.sin(2 * Math.PI * 0.3 * t);
    const still = 30 - 0.76 * (u1 - 10);
    const values = [t, u1, 110 + 1e-3 * noise(), still - ring + 0.01 * noise(), still + ring + 0.01 * noise()];
    text += `${values.map((value) => value.toFixed(6)).join(',')}\n`;
    if (text.length > 1 << 20) {
      writeSync(file, text);
      text = '';
    }
  }
  writeSync(file, text);
  closeSync(file);
}

const words = (page: Page) => page.locator('#panel-log .underway');
const cancel = (page: Page) => words(page).getByRole('button', { name: 'Cancel' });
const refusal = (page: Page) => page.locator('#panel-log .asked > .refusal');
const verdict = (page: Page) => page.locator('#panel-log .verdict');
const hit = () => readFileSync(join(folder, 'hit.csv'), 'utf8');

/** A good log, and what stands there of it. */
async function withGood(page: Page): Promise<string[]> {
  await page.goto('./#S_T&@tab="log"');
  await drop(page, { 'hit.csv': hit() });
  await expect(verdict(page)).toContainText('spring: 13', { timeout: 60_000 });
  await settled(page);
  return stands(page);
}

const stands = async (page: Page): Promise<string[]> => [
  await page.locator('#panel-log .told').innerText(),
  await page.locator('#panel-log .columns').innerText(),
  await page.locator('#panel-log .asked > .hint').allInnerTexts().then(String),
];

test.beforeAll(() => {
  rigLogs();
  writeLarge();
});

test('100 MB are identified within 700 MB, with progress', async ({ page, browser }) => {
  test.skip(!existsSync('/proc/self/status'), 'memory is read from /proc');
  await page.goto('./#S_T&@tab="log"');
  await page.locator('#log-file').setInputFiles(large);
  await expect(words(page)).toContainText(/Reading large\.csv … \d+ of 100 MB/, { timeout: 30_000 });
  const bar = words(page).getByRole('progressbar');
  await expect.poll(() => bar.evaluate((bar: HTMLProgressElement) => bar.position)).toBeGreaterThan(0.1);
  await expect(verdict(page)).toContainText('f1 = (54.06', { timeout: 90_000 });
  await expect(bar).toBeHidden();
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const peaks = processInfo
    .filter(({ type }) => type === 'renderer')
    .map(({ id }) => Number(/VmHWM:\s+(\d+)/.exec(readFileSync(`/proc/${id}/status`, 'utf8'))?.[1]) / 1024);
  console.log(`100 MB: the largest renderer took ${Math.max(...peaks).toFixed(0)} MiB at its peak`);
  expect(Math.max(...peaks)).toBeLessThan(700);
});

test('Cancel while it is read, and while it is computed, leaves the page as it was', async ({ page }) => {
  const before = await withGood(page);
  for (const phase of [/Reading large\.csv/, /large\.csv is read/]) {
    await page.locator('#log-file').setInputFiles(large);
    await expect(words(page)).toContainText(phase, { timeout: 30_000 });
    const workers = page.workers().length;
    await cancel(page).click();
    await expect(cancel(page)).toBeHidden();
    await expect(words(page)).toContainText('Cancelled.');
    await expect.poll(() => page.workers().length, 'its worker has ended').toBeLessThan(workers);
    expect(await stands(page)).toEqual(before);
    await expect(page.locator('#log-file')).toBeFocused();
  }
  // What stands there is of the log as it was: a choice asks of that.
  await page.getByLabel('F_o [N] is', { exact: true }).selectOption('F_i');
  await expect(verdict(page)).toContainText('spring', { timeout: 60_000 });
  await settled(page);
  await expect(page.locator('#panel-log .asked')).toContainText('hit.csv: text');
});

test('Cancel while the engine is loaded, with no log before, leaves the tab empty', async ({ page }) => {
  let release = () => {};
  const held = new Promise<void>((resolve) => (release = resolve));
  await page.route(/job-.*\.js|coilsense_web_bg-.*\.wasm/, async (route) => {
    if (await page.evaluate(() => 'held' in globalThis)) await held;
    await route.continue();
  });
  await page.goto('./#S_T&@tab="log"');
  await page.evaluate(() => Object.assign(globalThis, { held: true }));
  await drop(page, { 'hit.csv': hit() });
  await cancel(page).click();
  release();
  await expect(page.locator('#panel-log .empty')).toBeVisible();
  await expect(page.locator('#panel-log .columns')).toBeHidden();
  await drop(page, { 'hit.csv': hit() });
  await expect(verdict(page)).toContainText('spring: 13', { timeout: 60_000 });
});

test('a drop while another is read takes its place', async ({ page }) => {
  await page.goto('./#S_T&@tab="log"');
  await page.locator('#log-file').setInputFiles(large);
  await expect(words(page)).toContainText('Reading large.csv', { timeout: 30_000 });
  await drop(page, { 'hit.csv': hit() });
  await expect(verdict(page)).toContainText('spring: 13', { timeout: 60_000 });
  await settled(page);
  await expect(page.locator('#panel-log .asked')).not.toContainText('large.csv');
  // The same one again is read again.
  await drop(page, { 'hit.csv': hit() });
  await expect(page.locator('#panel-log .told')).toContainText('Reading hit.csv');
  await expect(verdict(page)).toContainText('spring: 13', { timeout: 60_000 });
});

test('a wrong file after a good one leaves nothing of the good one', async ({ page }) => {
  const cut = `${hit().slice(0, 200_000).split('\n').slice(0, -1).join('\n')}\n1.`;
  const novel = join(folder, 'novel.txt');
  writeFileSync(novel, 'no number is in here, and it goes on and on\n'.repeat(2_400_000));
  for (const [name, content, reason] of [
    ['image.png', '\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x01', /image\.png: is no text/],
    ['empty.csv', '', /empty\.csv: is empty/],
    ['cut.csv', cut, /cut\.csv:\d+: it has 1 column where line \d+ has 3/],
    ['run.parquet', 'PAR1\0\0\0\0', /run\.parquet: is Parquet, which is not read here/],
    ['novel.txt', null, /novel\.txt: no row of numbers is in its first 500 lines/],
  ] as const) {
    await withGood(page);
    if (content === null) await page.locator('#log-file').setInputFiles(novel);
    else await drop(page, { [name]: content });
    await expect(refusal(page), name).toHaveText(reason, { timeout: 30_000 });
    await expect(verdict(page)).toHaveCount(0);
    await expect(page.locator('#panel-log .told')).not.toContainText('54.0');
    if (name !== 'cut.csv') await expect(page.locator('#panel-log .columns')).toBeHidden();
    await expect(cancel(page)).toBeHidden();
  }
});

test('a folder, and a file that was changed since it was chosen, are refused in words', async ({ page }) => {
  await withGood(page);
  const session = await page.context().newCDPSession(page);
  const box = (await page.locator('#panel-log .drop').first().boundingBox())!;
  const data = { items: [], files: [folder], dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop'] as const)
    await session.send('Input.dispatchDragEvent', { type, x: box.x + 20, y: box.y + 10, data });
  await expect(refusal(page)).toHaveText('log/ is a folder: drop the files that are in it.');
  await expect(verdict(page)).toHaveCount(0);
  const changing = join(folder, 'changing.csv');
  writeFileSync(changing, hit());
  await page.locator('#log-file').setInputFiles(changing);
  await expect(verdict(page)).toContainText('spring: 13', { timeout: 60_000 });
  await settled(page);
  appendFileSync(changing, '\n');
  await page.getByLabel('u1 [mm] is', { exact: true }).selectOption('u2');
  await expect(refusal(page)).toHaveText(/changing\.csv: cannot be read: it is a folder, or was moved or changed/, {
    timeout: 30_000,
  });
});
