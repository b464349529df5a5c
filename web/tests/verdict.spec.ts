// The page's verdict is the command's: the same words, the same ranking, the same numbers, for whatever is set; and no other is ever shown for it.
import { writeFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import type { Outcome } from '../src/results/outcome';
import { command, EXAMPLES, results, resultsOf } from './command';
import { apart } from './jobs';
import { expect, open, test } from './page';

/** Of each number: sines and exponentials of two libraries differ in their last digits. */
const TOLERANCE = 1e-9;
/** States at random; the long proof is of 200. */
const STATES = Number(process.env['COILSENSE_STATES'] ?? 6);

/** The verdict of what is shown, once it is there. */
async function verdict(page: Page): Promise<Outcome> {
  await page.waitForFunction(() => window.coilsense.verdict() !== null, null, { timeout: 100_000 });
  const found = await page.evaluate(() => window.coilsense.verdict());
  if (!found) throw new Error('no verdict');
  return found;
}

/** What of an outcome is the verdict, its keys in one order: an object has none. */
function parts({ answer, goal, nominal_force_n, ranking }: Outcome): unknown {
  const sorted = (_: string, value: unknown) =>
    value !== null && typeof value === 'object' && !Array.isArray(value)
      ? Object.fromEntries(Object.entries(value).sort(([a], [b]) => (a < b ? -1 : 1)))
      : value;
  return JSON.parse(JSON.stringify({ answer, goal, nominal_force_n, ranking }, sorted));
}

/**
 * The largest difference of two verdicts: of forces over F_nom, of shares as they are, of other numbers over themselves, or over what makes a force of F_nom;
 * all but numbers must be the same.
 */
function differ(here: Outcome, there: Outcome): number {
  const nominal = there.nominal_force_n;
  type Branch = Record<string, unknown>;
  const walk = (a: unknown, b: unknown, place: string, perUnit: number): number => {
    if (a === b) return 0;
    if (typeof a === 'number' && typeof b === 'number') {
      const isForce = /_n(\/\d+)?$/.test(place);
      const size = isForce ? nominal : place.endsWith('share') ? 1 : Math.max(Math.abs(b), nominal / perUnit);
      return Math.abs(a - b) / size;
    }
    if (a === null || b === null || typeof a !== 'object' || typeof b !== 'object') return apart(a, b, place);
    expect(Object.keys(a), place).toEqual(Object.keys(b));
    // A line of a budget is a force by its product of two.
    const line = b as { sensitivity?: number; standard_uncertainty?: number };
    const other: Record<string, number | undefined> = {
      sensitivity: line.standard_uncertainty,
      standard_uncertainty: line.sensitivity,
    };
    const inside = (key: string) =>
      walk((a as Branch)[key], (b as Branch)[key], `${place}/${key}`, Math.abs(other[key] ?? Infinity));
    return Math.max(0, ...Object.keys(b).map(inside));
  };
  return walk(parts(here), parts(there), '', Infinity);
}

/** The command's verdict of the spec that is taken along. */
async function told(page: Page, path: (name: string) => string): Promise<Outcome> {
  const [spec] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Spec (TOML)' }).click(),
  ]);
  await spec.saveAs(path('mine.toml'));
  for (const file of ['road-c-20mps.csv', 'cam-6000rpm.csv'])
    writeFileSync(path(file), await (await import('node:fs/promises')).readFile(`../examples/${file}`));
  command('analyze', path('mine.toml'), '--overwrite', '--out', path('analysis'));
  return results(path('analysis')) as unknown as Outcome;
}

for (const [preset, example] of Object.entries(EXAMPLES)) {
  test(`${preset}: the verdict is that of coilsense analyze ${example}.toml, to the word`, async ({ page }) => {
    test.slow();
    await open(page, `#${preset}`);
    const here = await verdict(page);
    const off = differ(here, resultsOf(example) as unknown as Outcome);
    console.log(`${preset}: ${here.ranking.length} sensors, largest difference ${off.toExponential(1)}`);
    expect(off).toBeLessThan(TOLERANCE);
    const card = page.getByRole('region', { name: 'Which sensor to trust', exact: true });
    await expect(card.locator('.answer')).toHaveText(here.answer[0] ?? '');
    for (const { sensor, meets_goal: meets } of here.ranking) {
      await expect(card.locator(`tr[data-sensor="${sensor}"]`)).toContainText(meets ? '✓ meets it' : '✗ misses it');
      await expect(page.locator(`.results tr[data-force="${sensor}"]`)).toContainText(meets ? '✓' : '✗');
    }
  });
}

test('every choice of goal is judged as the command judges it', async ({ page }, info) => {
  test.slow();
  let most = 0;
  for (const force of ['F_x', 'F_i', 'F_o']) {
    for (const bandwidth of [null, 25]) {
      await open(
        page,
        `#suspension&goal.force=${force}&${bandwidth === null ? '-goal.bandwidth' : `goal.bandwidth=${bandwidth}+Hz`}`,
      );
      const here = await verdict(page);
      expect([here.goal.force, here.goal.bandwidth_hz]).toEqual([force, bandwidth]);
      most = Math.max(most, differ(here, await told(page, (name) => info.outputPath(name))));
      await page.goto('about:blank');
    }
  }
  console.log(`six goals, largest difference ${most.toExponential(1)}`);
  expect(most).toBeLessThan(TOLERANCE);
});

test('states at random are judged as the command judges them', async ({ page }, info) => {
  test.setTimeout(STATES * 60_000 + 60_000);
  let seed = 20_261_127;
  // A linear congruential generator (Numerical Recipes).
  const random = () => (seed = (1_664_525 * seed + 1_013_904_223) % 2 ** 32) / 2 ** 32;
  const between = (low: number, high: number) => Number((low * (high / low) ** random()).toPrecision(3));
  let most = 0;
  for (let state = 0; state < STATES; state++) {
    const preset = STATES > 50 ? ['valve', 'suspension', 'S_T', 'S_A'][state % 4] : ['valve', 'suspension'][state % 2];
    const goal = `&goal.error=${between(0.2, 5)}+%25&goal.force=${['F_x', 'F_i', 'F_o'][Math.floor(3 * random())]}`;
    const band = random() < 0.5 ? `&goal.bandwidth=${between(5, 500)}+Hz` : '';
    const own = `&spring.rest_length_tolerance=${between(0.05, 1)}+mm&spring.stiffness_tolerance=${between(0.2, 6)}+%25`;
    const damping = `&mount.damping_ratio=${between(0.001, 0.03)}`;
    await open(page, `#${preset}${goal}${band}${own}${damping}`);
    const here = await verdict(page);
    most = Math.max(most, differ(here, await told(page, (name) => info.outputPath(name))));
    expect(most, page.url()).toBeLessThan(TOLERANCE);
    await page.goto('about:blank');
  }
  console.log(`${STATES} states, largest difference ${most.toExponential(1)}`);
});

test('on the car’s suspension the load cell is not crossed out where the command chooses it', async ({ page }) => {
  await open(page, '#suspension');
  await verdict(page);
  const card = page.getByRole('region', { name: 'Which sensor to trust', exact: true });
  await expect(card.locator('.answer b')).toContainText('Choose load cell under the top mount');
  await expect(page.locator('tr[data-force="load cell under the top mount"]')).toContainText('✓');
  // What the spring alone does is no sensor's error.
  await expect(page.locator('tr[data-force="F_i"]')).not.toContainText(/[✓✗]/);
});

test('a verdict is never shown for another state than its own', async ({ page }) => {
  await open(page, '#valve');
  await verdict(page);
  const card = page.getByRole('region', { name: 'Which sensor to trust', exact: true });
  const limit = page.getByLabel('Your limit', { exact: true });
  const begun = await page.evaluate(() => performance.now());
  await limit.fill('0.05 %');
  // At once, before anything is computed.
  expect(await page.evaluate(() => window.coilsense.verdict())).toBeNull();
  await expect(card.locator('.verdict')).toHaveAttribute('aria-busy', 'true');
  await expect(card.locator('.standing')).toContainText('judging');
  await page.waitForTimeout(400);
  await limit.fill('50 %');
  const last = await verdict(page);
  const took = (await page.evaluate(() => performance.now())) - begun;
  console.log(`two edits of the valve's limit to the last one's verdict: ${took.toFixed(0)} ms`);
  expect(last.goal.error_n).toBeCloseTo(0.5 * last.nominal_force_n, 9);
  await expect(card.locator('.verdict')).toHaveAttribute('aria-busy', 'false');
  // What cannot be computed has no verdict.
  await limit.fill('-1 %');
  await expect(card.locator('.verdict')).toHaveAttribute('aria-busy', 'true');
  expect(await page.evaluate(() => window.coilsense.verdict())).toBeNull();
});
