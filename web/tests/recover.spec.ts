// Faults that are no missing file: workers that end, no network, a slow one, hosts that send other types, a newer build, links and files that are
// wrong. Each is said within three seconds, and there is a way on.
import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { createHash } from 'node:crypto';
import { dropOn } from './drops';
import { dist, FILES, Host } from './host';
import { example } from './jobs';

/** Nothing may be silent for longer [ms]. */
const SILENT = 3000;
const host = new Host();

test.use({ serviceWorkers: 'allow' });
test.beforeAll(() => host.begin());
test.beforeEach(() => host.heal());
test.afterAll(() => host.end());

const exact = async (page: Page): Promise<void> => {
  await page.waitForFunction(() => document.body.dataset['exact'] === 'true', null, { timeout: 30_000 });
};
const notes = (page: Page) => page.getByRole('region', { name: 'Notes' });
const alert = (page: Page) => page.getByRole('alert').filter({ hasText: 'Try again' });
const hit = (page: Page) => page.getByRole('slider', { name: 'How hard it is hit, slider' });
/** Pages of a build that a service worker keeps. */
const kept = (page: Page) =>
  expect(page.locator('#offline')).toContainText('opens without a network', { timeout: 40_000 });

test('workers that end are noticed at once, replaced and said, and what was asked is answered', async ({ page }) => {
  await page.addInitScript(() => {
    const { Worker } = window;
    const all: Worker[] = [];
    Object.assign(window, {
      all,
      Worker: class extends Worker {
        constructor(...args: ConstructorParameters<typeof Worker>) {
          super(...args);
          all.push(this);
        }
      },
    });
  });
  await page.goto(`${host.address}#S_T`);
  await exact(page);
  const end = () =>
    page.evaluate(() => (window as unknown as { all: Worker[] }).all.splice(0).forEach((one) => one.terminate()));
  await end();
  await expect(notes(page)).toContainText('had stopped', { timeout: SILENT });
  await notes(page).getByRole('button', { name: 'OK' }).click();
  await hit(page).fill('500');
  await exact(page);
  await expect(page.getByLabel('How hard it is hit', { exact: true })).toHaveValue('0.5 m/s');
  // Those of a job, in the middle of it: the question is asked once more.
  await page.getByRole('tab', { name: 'Mitigate' }).click();
  await page.getByRole('button', { name: 'Judge', exact: true }).click();
  await expect(page.locator('#panel-mitigate [role=status]').filter({ hasText: /of \d+ candidates/ })).toBeVisible({
    timeout: 30_000,
  });
  await end();
  await expect(notes(page)).toContainText('was restarted', { timeout: SILENT });
  await expect(page.locator('#panel-mitigate [role=status]').filter({ hasText: /of \d+ candidates/ })).toBeVisible({
    timeout: 30_000,
  });
});

test('the worker that judges, ended or silent at a case that nobody waits for, is replaced, and the verdict comes', async ({
  page,
}) => {
  // Which workers judge is known by what they are asked.
  await page.addInitScript(() => {
    const post = Worker.prototype.postMessage;
    const judges = new Set<Worker>();
    Object.assign(window, { judges, deaf: false });
    Worker.prototype.postMessage = function (...args: unknown[]) {
      const asked = args[0] as { id?: number; text?: string };
      const judges = asked.id !== undefined && asked.text !== undefined;
      const seen = (window as unknown as { judges: Set<Worker>; deaf: boolean }).judges;
      if (judges && (window as unknown as { deaf: boolean }).deaf && seen.has(this)) return;
      if (judges) seen.add(this);
      (post as (...args: unknown[]) => void).apply(this, args);
    };
  });
  const judges = () => page.evaluate(() => (window as unknown as { judges: Set<Worker> }).judges.size);
  const judged = () => page.waitForFunction(() => window.coilsense.verdict() !== null, null, { timeout: 30_000 });
  const nominal = () => page.evaluate(() => window.coilsense.verdict()!.nominal_force_n);
  await page.goto(`${host.address}#S_T`);
  await judged();
  expect(await judges()).toBe(1);
  // Ended in the middle of a verdict.
  await page.getByLabel('Stiffness k', { exact: true }).fill('800 N/m');
  await exact(page);
  await page.evaluate(() =>
    (window as unknown as { judges: Set<Worker> }).judges.forEach((worker) => worker.terminate()),
  );
  await judged();
  expect(await nominal()).toBeCloseTo(800 * 0.16, 9);
  await expect(notes(page)).toContainText('The worker that judges had stopped and was restarted.');
  expect(await judges()).toBe(2);
  // Silent: the newest spec goes to another worker.
  await page.evaluate(() => Object.assign(window, { deaf: true }));
  await page.getByLabel('Stiffness k', { exact: true }).fill('900 N/m');
  await judged();
  expect(await nominal()).toBeCloseTo(900 * 0.16, 9);
  expect(await judges()).toBe(3);
});

test('workers that do not answer are said, and begun anew', async ({ page }) => {
  // The second question on, the engine's workers keep silent.
  await page.addInitScript(() => {
    const post = Worker.prototype.postMessage;
    Object.assign(window, { deaf: false });
    Worker.prototype.postMessage = function (...args: unknown[]) {
      const { question } = args[0] as { question?: { kind: string } };
      if (!(question?.kind === 'preview' && (window as unknown as { deaf: boolean }).deaf))
        (post as (...args: unknown[]) => void).apply(this, args);
    };
  });
  await page.goto(`${host.address}#S_T`);
  await exact(page);
  await page.evaluate(() => Object.assign(window, { deaf: true }));
  await hit(page).fill('500');
  const anew = notes(page).getByRole('button', { name: 'Restart it' });
  await expect(anew).toBeVisible({ timeout: SILENT + 500 });
  await page.evaluate(() => Object.assign(window, { deaf: false }));
  await anew.click();
  await expect(page.locator('.status')).toHaveText('exact', { timeout: 10_000 });
  await expect(anew).toHaveCount(0);
});

test('after the first visit everything works without a network, and no build is mixed with another', async ({
  page,
  context,
}) => {
  await page.goto(`${host.address}#S_T&spring.mass=66+g`);
  await exact(page);
  await kept(page);
  await context.setOffline(true);
  await page.reload();
  await exact(page);
  await expect(page.getByLabel('Mass m', { exact: true })).toHaveValue('66 g');
  await page.getByRole('tab', { name: 'Log' }).click();
  await page.getByRole('button', { name: 'Try it with a simulated log' }).click();
  await expect(page.locator('#panel-log .verdict')).toBeVisible({ timeout: 40_000 });
  await page.goto(`${host.address}#suspension`);
  await exact(page);
  await context.setOffline(false);
  // A newer build: the page and its scripts are others, as a change in one that all import makes them, and the older page's script has gone.
  const text = (file: string) => readFileSync(`${dist}${file}`, 'utf8');
  const hash = (content: string) => createHash('sha256').update(content).digest('hex');
  const scripts = FILES.filter((file) => /^assets\/.*\.js$/.test(file));
  const next = (file: string) => file.replace(/\.js$/, '-newer.js');
  const base = (file: string) => file.slice(file.lastIndexOf('/') + 1);
  const renamed = (content: string) =>
    scripts.reduce((text, file) => text.replaceAll(base(file), base(next(file))), content);
  for (const file of scripts) host.contents.set(next(file), renamed(text(file)));
  const script = scripts.find((file) => file.startsWith('assets/page-')) ?? '';
  const newer = next(script);
  const html = renamed(text('index.html')).replace('Hit the spring.', 'Hit the newer spring.');
  host.contents.set('index.html', html);
  const hashes = [
    ...scripts.map((file) => [text(file), renamed(text(file))] as const),
    [text('index.html'), html] as const,
  ];
  const served = hashes.reduce((sw, [before, after]) => sw.replaceAll(hash(before), hash(after)), text('sw.js'));
  host.contents.set('sw.js', renamed(served).replace(/[`"][0-9a-f]{16}[`"]/g, '"newer"'));
  host.faults.set(script, 'missing');
  await page.reload();
  await exact(page);
  await expect(page.locator('h1')).toHaveText(/^Hit the spring/);
  await notes(page).getByRole('button', { name: 'Open it' }).click({ timeout: 40_000 });
  await expect(page.locator('h1')).toHaveText(/^Hit the newer spring/, { timeout: 20_000 });
  await exact(page);
  const caches = await page.evaluate(async () => {
    const names = await window.caches.keys();
    return Promise.all(
      names.map(async (name) => (await (await window.caches.open(name)).keys()).map(({ url }) => url)),
    );
  });
  expect(caches).toHaveLength(1);
  expect(caches[0]).toContain(host.address + newer);
  expect(caches[0]).not.toContain(host.address + script);
});

test('a page that came with one build while the next was put there is kept by neither', async ({ page }) => {
  host.contents.set('index.html', readFileSync(`${dist}index.html`, 'utf8').replace('Hit the spring.', 'Another one.'));
  await page.goto(`${host.address}#S_T`);
  await exact(page);
  await expect(page.locator('#offline')).toContainText('could not save', { timeout: 20_000 });
  expect(await page.evaluate(() => window.caches.keys())).toEqual([]);
});

test('a log that is opened without a network is opened once it is back', async ({ browser }) => {
  const page = await browser.newPage({ serviceWorkers: 'block' });
  await page.goto(`${host.address}#S_T&spring.mass=66+g`);
  await exact(page);
  await page.context().setOffline(true);
  await page.getByRole('tab', { name: 'Log' }).click();
  // The verdict, too, may not have come yet.
  await expect(alert(page).filter({ hasText: 'The tab Log' })).toContainText('offline', { timeout: SILENT });
  await page.context().setOffline(false);
  await expect(page.getByRole('button', { name: 'Try it with a simulated log' })).toBeVisible({ timeout: 10_000 });
  await expect(alert(page)).toHaveCount(0, { timeout: 20_000 });
  await page.close();
});

test('on a slow network the page says that it is loading, part by part', async ({ browser }) => {
  const page = await browser.newPage({ serviceWorkers: 'block' });
  for (const name of ['index-', 'page-', 'coilsense_web_bg', 'log-']) {
    host.heal();
    const files = FILES.filter((file) => file.startsWith(`assets/${name}`));
    for (const file of files) host.faults.set(file, 'hang');
    await page.goto('about:blank');
    await page.goto(`${host.address}#S_T&@tab="log"`, { waitUntil: 'commit' });
    await expect(page.getByText(/still loading/).first(), name).toBeVisible({ timeout: SILENT + 500 });
  }
  await page.close();
});

test('engines that a host sends under another type run', async ({ page }) => {
  for (const file of FILES.filter((file) => file.endsWith('.wasm'))) host.types.set(file, 'application/octet-stream');
  await page.goto(`${host.address}#S_T`);
  await exact(page);
  await page.getByRole('tab', { name: 'Mitigate' }).click();
  await expect(page.getByLabel('Most lag')).toHaveAttribute('placeholder', '30 deg', { timeout: 30_000 });
  await expect(alert(page)).toHaveCount(0);
});

test('opened as a file, the page says what to do', async ({ page }) => {
  await page.goto(pathToFileURL(`${dist}index.html`).href);
  await expect(page.getByRole('alert')).toContainText('python3 -m http.server', { timeout: SILENT });
});

test('a link with keys that nobody knows opens, and names them', async ({ page }) => {
  await page.goto(`${host.address}#S_T&spring.colour=red&motor.x=1&nonsense=2&@times=7&spring.mass=66+g`);
  await exact(page);
  for (const words of ['spring.colour', 'motor', 'nonsense', '@times']) await expect(notes(page)).toContainText(words);
  await expect(page.getByLabel('Mass m', { exact: true })).toHaveValue('66 g');
  await expect(page.locator('#sentence')).toContainText('the forces at the two ends differ by up to');
  await expect.poll(() => page.url()).not.toContain('colour');
  await page.setViewportSize({ width: 375, height: 812 });
  host.faults.set(FILES.find((file) => file.startsWith('assets/paper-')) ?? '', 'missing');
  await page.getByRole('tab', { name: 'Paper' }).click();
  await expect(alert(page)).toBeVisible();
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  }
  expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
});

test('a link with a wrong value opens with an answer, the field in sight and red with its reason', async ({ page }) => {
  await page.goto(`${host.address}#S_T&sensor.1.bandwidth=abc&spring.mass=66+g`);
  const field = page.locator('#sensor-1-bandwidth');
  await expect(page.locator('#sensor-1-bandwidth-error')).toContainText('must be a frequency with its unit');
  await expect(field).toBeInViewport();
  await expect(field).toHaveValue('abc');
  await expect(page.locator('#sentence')).toContainText('the forces at the two ends differ by up to');
  const mass = await page.evaluate(() => window.coilsense.last()?.answer.facts.spring.mass);
  expect(mass).toBeCloseTo(0.066, 12);
  await field.fill('1 kHz');
  await expect(page.locator('#sensor-1-bandwidth-error')).toBeHidden();
  await expect(page.locator('.controls > .refusal')).toBeHidden();
  await exact(page);
});

test('a wrong value of another condition, or of what has no field, is told in words with ways out', async ({
  page,
}) => {
  await page.goto(`${host.address}#S_T&condition.2.duration=abc`);
  const refusal = page.locator('.controls > .refusal');
  await expect(refusal).toContainText('“Simulated for” of the condition “end stop min”: must be a time');
  await refusal.getByRole('button', { name: 'Go to “end stop min”' }).click();
  await expect(page.locator('#condition-2-duration')).toBeInViewport();
  await expect(page.locator('#condition-2-duration-error')).toContainText('must be a time');
  await page.goto('about:blank');
  await page.goto(`${host.address}#S_T&spring.density=heavy`);
  await expect(refusal).toContainText('density of the spring: must be');
  await refusal.getByRole('button', { name: 'Take the usual value' }).click();
  await expect(refusal).toBeHidden();
  await expect.poll(() => page.url()).not.toContain('density');
});

test('a wrong file after a good log leaves nothing of the log', async ({ page }) => {
  await page.goto(`${host.address}#S_T&@tab="log"`);
  const rows = Array.from({ length: 4000 }, (_, index) => `${index / 1000},${Math.sin(index / 3)}`);
  await dropOn(page, '.drop >> nth=0', 'good.csv', ['time [s],F_o [N]', ...rows].join('\n'));
  await expect(page.getByLabel('F_o [N] is', { exact: true })).toBeVisible({ timeout: 30_000 });
  await dropOn(
    page,
    'footer',
    'picture.png',
    [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52],
  );
  await expect(page.locator('#panel-log .asked > .refusal')).toContainText('picture.png', { timeout: 30_000 });
  await expect(page.locator('#panel-log .columns')).toBeHidden();
  await expect(page.locator('#panel-log .verdict')).toHaveCount(0);
  await expect(page.locator('#panel-log')).not.toContainText('good.csv');
});

test('files dropped anywhere go to the tab that they belong to', async ({ page }) => {
  await page.goto(`${host.address}#S_A`);
  await exact(page);
  await dropOn(page, 'header', 'mine.toml', readFileSync(example('sea-ankle'), 'utf8').replace('65 g', '67 g'));
  await expect(page.getByLabel('Mass m', { exact: true })).toHaveValue('67 g');
  await dropOn(page, 'footer', 'log.csv', 'time [s],F_o [N]\n0,1\n0.001,2\n0.002,1\n');
  await expect(page.getByRole('tab', { name: 'Log' })).toHaveAttribute('aria-selected', 'true');
  await expect(page.locator('#panel-log')).toContainText('log.csv', { timeout: 30_000 });
  // A spec into the place for logs is a spec, and one that cannot be read changes nothing.
  await dropOn(page, '#panel-log .drop >> nth=0', 'mine.toml', readFileSync(example('parallel-ankle'), 'utf8'));
  await expect(page.getByRole('tab', { name: 'Spring' })).toHaveAttribute('aria-selected', 'true');
  await exact(page);
  await dropOn(page, 'main', 'torn.toml', '[spring]\nmass = "65');
  await expect(notes(page)).toContainText('torn.toml cannot be opened');
  await expect(page.locator('#sentence')).toContainText('the forces at the two ends differ by up to');
});
