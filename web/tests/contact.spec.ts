// Windings that meet: switched on by keyboard or by a link, computed by the larger engine, marked in the animation; and what must not change by it.
import { copyFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { command, results, type Results } from './command';
import { isLong, typical } from './long';
import { exact, expect, facts, MOVING, open, series, test } from './page';

test.use(MOVING);

/** The valve spring wound so that the cam's 8th harmonic meets its surge: its windings meet, as the example's own words say. */
const MEETS = '#valve&spring.coil_diameter=24.65+mm&contact.windings=hard&@condition=1';
/** The same with two masses for a winding, which are soon computed, and whose windings pass through one another. */
const THROUGH = '#valve&spring.coil_diameter=24.65+mm&spring.masses_per_winding=2&@condition=1';
const QUICK = `${THROUGH}&contact.windings=hard`;
/** Minutes of the command in the long proof. */
const COMPARED = isLong ? MEETS : QUICK;
/** Of F_nom: sines of two libraries differ in their last digits; a run that holds to its end carries them on but does not blow them up. */
const TOLERANCE = 1e-9;

interface Contact {
  holds_until_s: number;
  until_s: number;
  touches: number;
  pairs: { between: string; touches: number; share_of_time_closed: number; largest_closing_speed_m_per_s: number }[];
}

const chooser = (page: Page) => page.getByLabel('Windings that meet', { exact: true });

/** Following windings that meet takes seconds, and a shared machine some times as many. */
const LONG = { timeout: 150_000 };

/** Waits for the exact case under a law; the larger engine is loaded before it. */
async function meets(page: Page, law: string): Promise<void> {
  const has = (law: string) => window.coilsense?.last()?.exact?.facts.contact?.law === law;
  await page.waitForFunction(has, law, LONG);
  await exact(page);
}

test.setTimeout(300_000);

test('windings that meet give the command’s numbers, under each restitution that it computes', async ({
  page,
}, info) => {
  test.setTimeout(600_000);
  await page.goto(`./${COMPARED}`);
  await meets(page, 'e = 0');
  const [spec] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Spec (TOML)' }).click(),
  ]);
  const [file, folder] = [info.outputPath('mine.toml'), info.outputPath('analysis')];
  await spec.saveAs(file);
  besideIt(file);
  command('analyze', file, '--out', folder);
  const { nominal_force_n: nominal, cases } = results(folder);
  const { dampings } = await facts(page);
  expect(dampings.map(({ label }) => label)).toEqual(cases.slice(0, 4).map(({ damping }) => damping));
  let compared = 0;
  for (const damping of [0, 1]) {
    const told = cases[dampings.length + damping]! as Results['cases'][number] & { contact: Contact };
    await page.evaluate((hash) => (location.hash = hash), `${COMPARED}&@damping=${damping}`);
    await page.waitForFunction((d) => window.coilsense.last()?.exact?.facts.damping === d, damping, LONG);
    const found = await facts(page);
    expect(found.dampings[damping]?.label).toBe(told.damping);
    const holds = told.contact.holds_until_s >= told.contact.until_s;
    let worst = 0;
    for (const [force, here] of Object.entries(found.forces)) {
      const there = told.forces[force]!;
      for (const off of [here.rmsd - there.rmsd_n, here.mean - there.mean_n, here.maximum - there.maximum_n])
        worst = Math.max(worst, Math.abs(off) / nominal);
    }
    console.log(
      `${told.damping}: ${told.contact.touches} touches, largest difference ${worst.toExponential(1)} of F_nom`,
    );
    expect(found.clash.firstContact === null).toBe(told.first_contact_s === null);
    if (told.first_contact_s !== null)
      expect(Math.abs((found.clash.firstContact ?? 0) - told.first_contact_s)).toBeLessThan(1e-9);
    expect(found.contact?.holdsUntil).toBeCloseTo(told.contact.holds_until_s, 3);
    // What a millionth moves by a hundredth of F_nom is nobody's number to the ninth digit.
    if (!holds) continue;
    compared += 1;
    expect(worst, told.damping).toBeLessThan(TOLERANCE);
    // Points that graze meet once more or once less by the last digit.
    expect(Math.abs((found.contact?.touches ?? 0) / told.contact.touches - 1)).toBeLessThan(0.02);
    expect(found.contact?.pairs.map(({ between }) => between)).toEqual(
      told.contact.pairs.map(({ between }) => between),
    );
  }
  expect(compared, 'runs that hold to their end').toBeGreaterThan(0);
});

/** Puts the cam that a spec of the valve names beside it. */
function besideIt(file: string): void {
  const from = new URL('../../examples/cam-6000rpm.csv', import.meta.url).pathname;
  copyFileSync(from, join(dirname(file), 'cam-6000rpm.csv'));
}

test('switched on and off by keyboard; off gives bit by bit what it was, from the first engine', async ({ page }) => {
  const asked: string[] = [];
  page.on('request', (request) => asked.push(request.url()));
  // The verdict, which takes the larger engine, too, waits: what is counted is what the curves take.
  await page.route(/\/assets\/judge-/, () => {});
  await open(page, THROUGH);
  const wasm = () => asked.filter((url) => url.endsWith('.wasm')).length;
  expect(wasm()).toBe(1);
  const names = ['F_i', 'F_o', 'F_x', 'F_L'];
  const curves = async () => Promise.all(names.map((name) => series(page, name)));
  const before = { facts: await facts(page), curves: await curves() };
  await chooser(page).focus();
  await page.keyboard.press('ArrowDown');
  await meets(page, 'e = 0');
  await expect(chooser(page)).toBeFocused();
  expect(wasm()).toBe(2);
  expect(await curves()).not.toEqual(before.curves);
  await expect(page.locator('[data-subject=contact]')).toContainText('windings meet from t = ');
  await expect(page.locator('#sentence')).toContainText('Windings meet from');
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('contact.windings=hard');
  await chooser(page).focus();
  await page.keyboard.press('ArrowUp');
  await page.waitForFunction(() => window.coilsense.last()?.exact?.facts.contact === null);
  await exact(page);
  expect(await facts(page)).toEqual(before.facts);
  expect(await curves()).toEqual(before.curves);
  await expect.poll(() => page.evaluate(() => location.hash)).not.toContain('contact');
});

test('restitution and seats are the spec’s, and the shown damping stays', async ({ page }) => {
  await open(page, `${THROUGH}&@damping=1`);
  await chooser(page).selectOption('hard');
  await meets(page, 'e = 0');
  // Two dampings in two ways: the second damping is the third case.
  expect((await facts(page)).dampings[2]?.label).toBe('ζ = 0.01, e = 0');
  expect((await facts(page)).damping).toBe(2);
  await page.getByLabel('Restitution e').fill('0.2');
  await meets(page, 'e = 0.2');
  expect((await facts(page)).damping).toBe(1);
  expect((await facts(page)).contact?.ends).toBe(true);
  await page.getByLabel('Ends meet their seats').selectOption('no');
  await page.waitForFunction(() => window.coilsense.last()?.exact?.facts.contact?.ends === false);
  await page.getByLabel('Restitution e').fill('2');
  await expect(page.locator('#contact-error')).toContainText('must be from 0 to 1');
  await expect(page.getByLabel('Restitution e')).toHaveAttribute('aria-invalid', 'true');
});

test('a spring that is solid is refused with the reason, and the last good plot stays', async ({ page }) => {
  // Wound close, as springs for tension are: its 52 windings of 2 mm are its 104 mm at rest.
  await open(page, '#S_T');
  const before = await series(page, 'F_o');
  await chooser(page).selectOption('hard');
  await expect(page.locator('#contact-error')).toContainText('this one is solid at its “Rest length l0”', {
    timeout: 60_000,
  });
  await expect(chooser(page)).toHaveAttribute('aria-invalid', 'true');
  await expect(page.locator('.refusal').first()).toContainText('last state that could be computed');
  expect(await series(page, 'F_o')).toEqual(before);
});

test('closed windings are marked where they meet, told in words, and played slowly from the first contact on', async ({
  page,
}) => {
  await page.goto(`./${QUICK}`);
  await meets(page, 'e = 0');
  await page.getByRole('button', { name: 'Go to first contact' }).click();
  const first = (await facts(page)).contact?.first ?? 0;
  await page.waitForFunction((first) => {
    const [from = 1, to = 0] = window.coilsense.last()?.times ?? [];
    return from < first && first < to;
  }, first);
  await expect(page.locator('.together')).toContainText(/closed: (seat [12]|\d\|\d)/);
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
  await page.getByRole('button', { name: 'Pause' }).click();
  await expect(page.getByRole('img', { name: /Windings meet from \d+\.\d ms on/ }).first()).toBeVisible();
  await expect(page.getByRole('region', { name: 'Which windings met' })).toContainText('seat 2');
});

for (const colorScheme of typical(['light', 'dark'] as const))
  test(`axe finds nothing, in ${colorScheme}, and nothing is wider than 390 or 1280 pixels`, async ({ page }, info) => {
    await page.emulateMedia({ colorScheme });
    await page.goto(`./${QUICK}`);
    await meets(page, 'e = 0');
    await page.getByRole('button', { name: 'Go to first contact' }).click();
    await page.getByRole('button', { name: 'Pause' }).click();
    for (const [width, height] of [
      [390, 844],
      [1280, 800],
    ] as const) {
      await page.setViewportSize({ width, height });
      // Curves follow the new width at the next frame.
      const over = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      await expect.poll(over).toBeLessThanOrEqual(0);
      await page.screenshot({ path: info.outputPath(`contact-${width}.png`), fullPage: true });
    }
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  });
