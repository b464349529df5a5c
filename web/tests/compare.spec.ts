// A state that is kept beside the present one: its curves behind those of now, what differs, what both give; and sensors side by side.
//
// Next door: undo and the address in general (`history`), every width (`layout`), speed (`speed`).
import AxeBuilder from '@axe-core/playwright';
import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { typical } from './long';
import { expect, exact, facts, open, series, test } from './page';

const keep = (page: Page) => page.getByRole('button', { name: 'Keep to compare' });
const bar = (page: Page) => page.getByRole('group', { name: 'Kept to compare' });
const card = (page: Page) => page.locator('.beside');
const mass = (page: Page) => page.getByLabel('Mass m', { exact: true });
/** The cells of a row: what is kept, and now. */
const cells = (page: Page, row: string) => card(page).locator(`tr[data-row="${row}"] td`);
const standing = (page: Page) => card(page).locator('.status');

async function keepIt(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Pause' }).click();
  await keep(page).click();
  await expect(bar(page)).toBeVisible();
}

async function setMass(page: Page, text: string): Promise<void> {
  // Heard in the page itself: an exact case may be there before a question from here is answered.
  const left = page.evaluate(
    () =>
      new Promise<void>((resolve) =>
        new MutationObserver((_, observer) => {
          if (document.body.dataset['exact'] !== 'false') return;
          observer.disconnect();
          resolve();
        }).observe(document.body, { attributeFilter: ['data-exact'] }),
      ),
  );
  await mass(page).fill(text);
  await mass(page).blur();
  await left;
  await exact(page);
}

/** The picture of the forces, once it stands still. */
async function picture(page: Page): Promise<string> {
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  return page.evaluate(() => document.querySelector<HTMLCanvasElement>('.plot.forces canvas')!.toDataURL());
}

const percent = (force: number, nominal: number) => `${((100 * force) / nominal).toFixed(3)}\u00a0%`;

test('a kept state stays beside the present one: inputs, frequency, forces, sensors, verdict', async ({ page }) => {
  await open(page);
  const before = await facts(page);
  await keepIt(page);
  await expect(card(page)).toContainText('Nothing yet');
  await setMass(page, '90 g');
  const now = await facts(page);
  await expect(cells(page, 'Mass m')).toHaveText(['65 g', '90 g']);
  await expect(cells(page, 'Surge frequency f1')).toHaveText([
    `${before.lines[0]!.toPrecision(4)}\u00a0Hz`,
    new RegExp(`^${now.lines[0]!.toPrecision(4)}\u00a0Hz \\(−15\u00a0%\\)`),
  ]);
  for (const [row, of] of [
    ['End 2 (F_o), rms off', (one: typeof now) => one.forces['F_o']!.rmsd],
    ['End 2 (F_o), most off', (one: typeof now) => one.forces['F_o']!.maximumAbsolute],
    ['laser, rms off', (one: typeof now) => one.sensors.find(({ name }) => name === 'laser')!.deviation.rmsd],
  ] as const) {
    await expect(cells(page, row).nth(0)).toContainText(percent(of(before), before.spring.nominalForce));
    await expect(cells(page, row).nth(1)).toContainText(percent(of(now), now.spring.nominalForce));
  }
  await expect(standing(page)).toHaveText('exact', { timeout: 60_000 });
  const verdict = await page.evaluate(() => window.coilsense.verdict()!.answer[0]!);
  const words = await cells(page, 'Verdict').allTextContents();
  for (const one of words) expect(one).toMatch(/^Choose /);
  expect(verdict.startsWith(words[1]!)).toBe(true);
  await expect(cells(page, 'laser, rms off').nth(0)).toContainText('meets it');
});

test('kept curves are drawn behind, broad and pale, and go when they are forgotten', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Pause' }).click();
  await setMass(page, '90 g');
  const alone = await picture(page);
  await setMass(page, '65 g');
  await keep(page).click();
  await setMass(page, '90 g');
  expect(await picture(page)).not.toBe(alone);
  await expect(bar(page)).toContainText('kept (broad, pale): S_T');
  await expect(bar(page)).toContainText('Mass m 65 g');
  await bar(page).getByRole('button', { name: 'Forget' }).click();
  await expect(bar(page)).toBeHidden();
  await expect(card(page)).toBeHidden();
  await expect(keep(page)).toBeFocused();
  await expect.poll(() => picture(page)).toBe(alone);
});

test('no number of an earlier state stands as that of now, not for one turn of the loop', async ({ page }) => {
  await open(page);
  await keepIt(page);
  await setMass(page, '90 g');
  await expect(standing(page)).toHaveText('exact', { timeout: 60_000 });
  const shown = await page.evaluate(() => {
    const slider = document.querySelector<HTMLInputElement>('input[aria-label="Mass m, slider"]')!;
    slider.value = String(Number(slider.value) + 100);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    const texts = (of: string) => [...document.querySelectorAll(`.beside td${of}`)].map((one) => one.textContent);
    return { now: texts('.present'), kept: texts(':not(.present)') };
  });
  expect(new Set(shown.now)).toEqual(new Set(['…pending']));
  expect(shown.kept).toContain('65 g');
  // The case comes before the verdict, whose mark and words wait for it.
  await exact(page);
  await expect(cells(page, 'Surge frequency f1').nth(1)).toContainText('Hz');
  const early = await page.evaluate(() => ({
    known: window.coilsense.verdict() !== null,
    word: document.querySelector('.beside tr[data-row=Verdict] td.present')!.textContent,
  }));
  if (!early.known) expect(early.word).toBe('…pending');
  await expect(cells(page, 'Verdict').nth(1)).toContainText('Choose', { timeout: 60_000 });
});

test('a verdict that had not come when the state was left comes at rest', async ({ page }) => {
  await open(page);
  await keepIt(page);
  // At once: the verdict of what is kept is cancelled by this.
  await setMass(page, '90 g');
  await expect(cells(page, 'Verdict').nth(0)).toHaveText('…pending');
  await expect(cells(page, 'Verdict').nth(0)).toContainText('Choose', { timeout: 60_000 });
  await expect(standing(page)).toHaveText('exact');
});

test('Swap exchanges both, Undo takes that back, and an undo past the keeping leaves what is kept', async ({
  page,
}) => {
  await open(page, '#S_T&spring.mass=80+g');
  const stiffness = page.getByLabel('Stiffness k', { exact: true });
  await stiffness.fill('800 N/m');
  await exact(page);
  await keepIt(page);
  await setMass(page, '90 g');
  const swap = bar(page).getByRole('button', { name: 'Swap' });
  const [undo, redo] = ['Undo', 'Redo'].map((name) => page.getByRole('button', { name }));
  await swap.click();
  await exact(page);
  await expect(mass(page)).toHaveValue('80 g');
  await expect(cells(page, 'Mass m')).toHaveText(['90 g', '80 g']);
  await undo!.click();
  await exact(page);
  await expect(mass(page)).toHaveValue('90 g');
  await expect(cells(page, 'Mass m')).toHaveText(['80 g', '90 g']);
  await redo!.click();
  await exact(page);
  await expect(cells(page, 'Mass m')).toHaveText(['90 g', '80 g']);
  for (let back = 0; back < 2; back++) await undo!.click();
  await exact(page);
  await expect(mass(page)).toHaveValue('80 g');
  await expect(card(page)).toContainText('Nothing yet');
  // Before it was kept.
  await undo!.click();
  await exact(page);
  await expect(stiffness).toHaveValue('760 N/m');
  await expect(cells(page, 'Stiffness k')).toHaveText(['800 N/m', '760 N/m']);
  await bar(page).getByRole('button', { name: 'Forget' }).click();
  await expect(bar(page)).toBeHidden();
  await undo!.click();
  await expect(cells(page, 'Stiffness k')).toHaveText(['800 N/m', '760 N/m']);
});

test('a reload and a link keep it, another preset with a recorded motion, too', async ({ page }) => {
  await open(page, '#valve');
  const before = await facts(page);
  await keepIt(page);
  await page.locator('#preset').selectOption('S_T');
  await exact(page);
  await expect(cells(page, 'Spring').nth(0)).toContainText('Valve');
  await expect(cells(page, 'Spring').nth(1)).toContainText('S_T');
  await expect.poll(() => page.url()).toContain('@kept=');
  await page.reload();
  await exact(page);
  await expect(cells(page, 'Surge frequency f1').nth(0)).toContainText('Hz', { timeout: 30_000 });
  await expect(cells(page, 'End 2 (F_o), rms off').nth(0)).toContainText(
    percent(before.forces['F_o']!.rmsd, before.spring.nominalForce),
  );
  await expect(card(page)).toContainText('not there');
  await expect(card(page)).toContainText('The two states differ in what happens');
});

test('another number of sensors, other names, another condition and damping are told as such', async ({ page }) => {
  const kept = encodeURIComponent(
    JSON.stringify(
      'S_T&-sensor.4&sensor.2.name=Triangulator&@condition=3&@damping=2&condition.3.duration=0.6+s&condition.3.window=["0.3+s","0.6+s"]',
    ),
  );
  await open(page, `#S_T&@kept=${kept}`);
  await expect(standing(page)).toHaveText('exact', { timeout: 60_000 });
  await expect(cells(page, 'What happens')).toHaveText(['half resonance', 'heel strike']);
  await expect(cells(page, 'Damping shown')).toHaveText(['ζ = 0.005', 'ζ = 0']);
  await expect(cells(page, '“laser”: Name')).toHaveCount(0);
  await expect(cells(page, '“Triangulator”: Name')).toHaveText(['Triangulator', 'laser']);
  await expect(cells(page, 'Sensor “LCR meter”')).toHaveText(['not there', 'there']);
  await expect(cells(page, 'LCR meter, rms off').nth(0)).toHaveText('not there');
  await expect(cells(page, 'Triangulator, rms off').nth(1)).toHaveText('not there');
  await expect(cells(page, 'Judged from, to')).toHaveText(['0.3 to 0.6 s', '0.75 to 1 s']);
  // Beyond its end the kept state has no curves, and all of now's are there.
  await page.getByRole('button', { name: /\(all\)$/ }).click();
  await exact(page);
  expect((await series(page, 'time')).at(-1)).toBeGreaterThan(0.99);
});

test('windings that would touch, and those that meet, are said of the state that has them', async ({ page }) => {
  await open(page, '#valve&spring.coil_diameter=24.65+mm&spring.masses_per_winding=2&@condition=1');
  expect((await facts(page)).clash.firstContact).not.toBeNull();
  await keepIt(page);
  await page.getByLabel('Windings that meet').selectOption('hard');
  await expect(cells(page, 'Windings').nth(1)).toContainText('meet', { timeout: 60_000 });
  await expect(cells(page, 'Windings that meet')).toHaveText(['pass through', 'are hard']);
  await expect(cells(page, 'Windings').nth(0)).toContainText('would touch from');
  await expect(card(page)).toContainText('a real coil does not follow these figures');
  // Computed once more after a reload, by the larger engine, since it is the kept one that needs it.
  await bar(page).getByRole('button', { name: 'Swap' }).click();
  await exact(page);
  // A reload is of the address, which is written a moment later.
  await expect.poll(() => decodeURIComponent(page.url())).toMatch(/@kept=.*contact\.windings=hard/);
  await page.reload();
  await exact(page);
  await expect(cells(page, 'Windings').nth(0)).toContainText('meet', { timeout: 60_000 });
  await expect(cells(page, 'Windings').nth(1)).toContainText('would touch from');
});

test('a kept state that cannot be computed says why, and the present one goes on', async ({ page }) => {
  await open(page, `#S_T&@kept=${encodeURIComponent('"S_T&spring.mass=abc"')}`);
  await expect(bar(page)).toContainText('It cannot be computed:', { timeout: 20_000 });
  await expect(bar(page)).toContainText('mass');
  await expect(bar(page).getByRole('button', { name: 'Swap' })).toBeDisabled();
  await expect(cells(page, 'Surge frequency f1')).toHaveText(['–', /Hz/]);
  await setMass(page, '90 g');
  await expect(cells(page, 'Mass m')).toHaveText(['abc', '90 g']);
});

test('what is refused is not kept, and a refusal leaves no number as that of now', async ({ page }) => {
  await open(page);
  await mass(page).fill('abc');
  await expect(page.locator('#spring-mass-error')).toBeVisible({ timeout: 20_000 });
  await keep(page).click();
  await expect(
    page.locator('.card > [role=status]', { hasText: 'What cannot be computed cannot be kept' }),
  ).toHaveCount(1);
  await expect(bar(page)).toBeHidden();
  await mass(page).fill('70 g');
  await exact(page);
  await keep(page).click();
  await mass(page).fill('abc');
  await expect(standing(page)).toHaveText('now not computed', { timeout: 20_000 });
  await expect(cells(page, 'Surge frequency f1')).toHaveText([/Hz/, '–']);
});

test('an address that keeps nonsense opens with a note', async ({ page }) => {
  await open(page, '#S_T&@kept=7');
  await expect(page.locator('#notices')).toContainText('@kept');
  await expect(keep(page)).toBeVisible();
  await open(page, `#S_A&@kept=${encodeURIComponent('"S_T&@nothing=1"')}`);
  await expect(page.locator('#notices')).toContainText('What is kept has settings');
});

test('the picture that is taken along has the kept curves and says so', async ({ page }) => {
  await open(page);
  const take = async () => {
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Forces (SVG)' }).click(),
    ]);
    return readFileSync(await file.path(), 'utf8');
  };
  const count = (svg: string) => svg.match(/<polyline/g)!.length;
  expect(count(await take())).toBe(4);
  await keepIt(page);
  await setMass(page, '90 g');
  const svg = await take();
  expect(count(svg)).toBe(8);
  expect(svg).toContain('kept: S_T');
  expect(svg).toContain('opacity="');
  await page.emulateMedia({ media: 'print' });
  await expect(bar(page)).toContainText('kept');
  await expect(bar(page).getByRole('button', { name: 'Swap' })).toBeHidden();
  await expect(card(page)).toBeVisible();
});

test('sensors that are ticked have their errors side by side, over the shown times', async ({ page }) => {
  await open(page);
  const pair = page.locator('.pair');
  const tick = (name: string) => page.locator(`.off tr[data-force="${name}"] button`).click();
  await tick('laser');
  await expect(pair).toBeHidden();
  await tick('load cell, load side');
  await expect(pair).toBeVisible();
  const { spring, sensors, truth } = await facts(page);
  const rms = async (name: string) => {
    const number = sensors.findIndex((one) => one.name === name);
    const [time, read, meant] = await Promise.all(['time', `reading ${number}`, truth].map((one) => series(page, one)));
    const [from, to] = (await page.evaluate(() => window.coilsense.last()!.times)) as [number, number];
    const all = time!.flatMap((at, index) => (at < from || at > to ? [] : [(read![index]! - meant![index]!) ** 2]));
    return ((100 * Math.sqrt(all.reduce((a, b) => a + b, 0) / all.length)) / spring.nominalForce).toFixed(3);
  };
  for (const name of ['laser', 'load cell, load side']) {
    const row = pair.locator(`tr[data-sensor="${name}"] td`);
    await expect(row.first()).toHaveText(await rms(name));
    await expect(row.nth(2)).toHaveText(
      ((100 * sensors.find((one) => one.name === name)!.deviation.rmsd) / spring.nominalForce).toFixed(3),
    );
    await expect(row.last()).toContainText(/it$/, { timeout: 60_000 });
  }
  const whole = await rms('load cell, load side');
  await page.getByTitle('Zoom in').click();
  await exact(page);
  await expect(pair.locator('tr[data-sensor="load cell, load side"] td').first()).not.toHaveText(whole);
  // A preview has no readings: nothing of an earlier state is drawn or told as of now.
  const stale = await page.evaluate(() => {
    const slider = document.querySelector<HTMLInputElement>('input[aria-label="Mass m, slider"]')!;
    slider.value = String(Number(slider.value) + 100);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    return document.querySelector('.pair tbody')!.classList.contains('stale');
  });
  expect(stale).toBe(true);
  await exact(page);
  await expect(pair.locator('tbody')).not.toHaveClass(/stale/);
  await tick('laser');
  await expect(pair).toBeHidden();
});

for (const colorScheme of typical(['light', 'dark'] as const))
  test(`axe finds nothing beside a kept state, in ${colorScheme}, and nothing is wider than 375 pixels`, async ({
    page,
  }) => {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width: 375, height: 812 });
    await open(page, `#S_A&@kept="S_T"&@sensors=["two+encoders","load+cell,+motor+side"]`);
    await expect(standing(page)).toHaveText('exact', { timeout: 60_000 });
    await expect(page.locator('.pair')).toBeVisible();
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    const more = card(page).getByRole('button', { name: /more inputs/ });
    await more.focus();
    await page.keyboard.press('Enter');
    await expect(card(page).getByRole('button', { name: 'Fewer inputs' })).toBeFocused();
    // In one row of inputs, before what they give.
    const heads = await card(page).locator('tbody:visible tr:first-child').allTextContents();
    expect([heads[0], heads.at(-1)]).toEqual(['What differs', 'What it gives']);
    expect(heads).toHaveLength(3);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
  });
