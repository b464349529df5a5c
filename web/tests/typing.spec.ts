// What is typed into fields: units and decimal signs as people write them, what is shown of it, and that changes of form keep the numbers.
import { typical } from './long';
import { expect, exact, facts, open, test } from './page';

test('a decimal comma, a bare number and an imperial unit are taken, shown while typing, and stand there in full after that', async ({
  page,
}) => {
  await open(page);
  const stiffness = page.getByLabel('Stiffness k', { exact: true });
  const told = page.locator('#spring-stiffness-understood');
  for (const [typed, taken, newtons] of [
    ['1,2 kN/m', '1.2 kN/m', 1200],
    ['0,9', '0.9 kN/m', 900],
    ['760 N/m', '760 N/m', 760],
    ['800', '800 N/m', 800],
    ['4,34 lb/in', '4.34 lbf/in', 4.34 * 175.126835246476],
  ] as const) {
    await stiffness.fill(typed);
    // What stands in the field is the typist's until it is left.
    await expect(stiffness).toHaveValue(typed);
    if (typed === taken) await expect(told).toBeHidden();
    else await expect(told).toHaveText(`= ${taken}`);
    await stiffness.blur();
    await expect(stiffness).toHaveValue(taken);
    await expect(told).toBeHidden();
    expect((await facts(page)).spring.stiffness / newtons).toBeCloseTo(1, 12);
  }
  await page.getByLabel('How hard it is hit', { exact: true }).fill('1 mph');
  await page.keyboard.press('Tab');
  await expect(page.getByLabel('How hard it is hit', { exact: true })).toHaveValue('0.44704 m/s');
});

test('a comma that may be thousands is refused with both readings; a point that may be is told beside the field', async ({
  page,
}) => {
  await open(page);
  const stiffness = page.getByLabel('Stiffness k', { exact: true });
  await stiffness.fill('1,001 N/m');
  await expect(page.locator('#spring-stiffness-error')).toHaveText(
    'may be 1.001 N/m or 1001 N/m: write one of them so',
  );
  await stiffness.blur();
  await expect(stiffness).toHaveValue('1,001 N/m');
  await expect(page.locator('#spring-stiffness-error')).toBeVisible();
  // Nothing was computed of it.
  expect(await page.evaluate(() => window.coilsense.last()?.answer.facts.spring.stiffness)).toBe(760);
  // The unit that the field showed before is still the one of a bare number.
  await stiffness.fill('900');
  await stiffness.blur();
  await expect(stiffness).toHaveValue('900 N/m');
  await stiffness.fill('1.001 kN/m');
  await stiffness.blur();
  await expect(page.locator('#spring-stiffness-understood')).toHaveText('read with a decimal point: not 1001 kN/m');
  expect((await facts(page)).spring.stiffness).toBe(1001);
  await page.getByRole('slider', { name: 'Stiffness k, slider' }).press('ArrowRight');
  await expect(page.locator('#spring-stiffness-understood')).toBeHidden();
});

test('numbers without a unit take a comma, too, and damping a share; names stay as they are', async ({ page }) => {
  await open(page);
  const damping = page.getByLabel('Damping ζ', { exact: true });
  for (const [typed, ratio] of [
    ['0,01', '0.01'],
    ['2 %', '0.02'],
    ['0,5%', '0.005'],
  ] as const) {
    await damping.fill(typed);
    await damping.blur();
    await expect(damping).toHaveValue(ratio);
    const found = await facts(page);
    expect(found.dampings.map(({ ratio }) => ratio)).toEqual([Number(ratio)]);
  }
  await page.locator('#more-sensors > summary').click();
  await page.locator('#sensor-0 > summary').click();
  const name = page.locator('#sensor-0-name');
  await name.fill('1,001 cell, left');
  await name.blur();
  await expect(name).toHaveValue('1,001 cell, left');
  expect((await facts(page)).sensors[0]!.name).toBe('1,001 cell, left');
});

test('two values with decimal commas', async ({ page }) => {
  await open(page);
  await page.locator('#more-condition > summary').click();
  const window = page.locator('#condition-0-window');
  await window.fill('0,5 s; 0,75');
  await window.blur();
  await expect(window).toHaveValue('0.5 s, 0.75 s');
  const { conditions } = await facts(page);
  expect(conditions[0]!.window).toEqual([0.5, 0.75]);
});

test('restitution takes a comma as a decimal sign; two values with points stay two', async ({ page }) => {
  await open(page);
  await page.getByLabel('Windings that meet', { exact: true }).selectOption('hard');
  const loss = page.getByLabel('Restitution e');
  await loss.fill('0,3');
  await loss.blur();
  await expect(loss).toHaveValue('0.3');
  await loss.fill('0,0.5');
  await loss.blur();
  await expect(loss).toHaveValue('0, 0.5');
});

test('undo while a field has the focus shows the former text in it', async ({ page }) => {
  await open(page);
  const mass = page.getByLabel('Mass m', { exact: true });
  await mass.fill('70,5');
  await exact(page);
  await expect(mass).toHaveValue('70,5');
  await page.keyboard.press('Control+z');
  await expect(mass).toHaveValue('65 g');
});

test('given by wire and coil and back, the numbers are those that were typed; after an edit, those of the wire', async ({
  page,
}) => {
  await open(page);
  const stiffness = page.getByLabel('Stiffness k', { exact: true });
  await stiffness.fill('761,5');
  await stiffness.blur();
  await exact(page);
  await page.getByText('The spring, in full').click();
  const way = (name: string) => page.getByLabel(name, { exact: true });
  await way('wire and coil').check();
  await exact(page);
  await way('values').check();
  await expect(stiffness).toHaveValue('761.5 N/m');
  await expect(page.getByLabel('Mass m', { exact: true })).toHaveValue('65 g');
  expect((await facts(page)).spring.stiffness).toBe(761.5);
  // What is not of the spring may be edited meanwhile.
  await way('wire and coil').check();
  await page.getByLabel('How hard it is hit', { exact: true }).fill('0.3 m/s');
  await exact(page);
  await way('values').check();
  await expect(stiffness).toHaveValue('761.5 N/m');
  // Another wire is another spring; and back to it there is what was typed of the wire.
  await way('wire and coil').check();
  await page.getByLabel('Wire diameter d', { exact: true }).fill('1,9 mm');
  await page.getByLabel('Wire diameter d', { exact: true }).blur();
  const wound = (await facts(page)).spring.stiffness;
  await way('values').check();
  expect((await facts(page)).spring.stiffness / wound).toBeCloseTo(1, 5);
  expect(wound).toBeLessThan(700);
  await way('wire and coil').check();
  await expect(page.getByLabel('Wire diameter d', { exact: true })).toHaveValue('1.9 mm');
});

for (const preset of typical(['S_T', 'S_A', 'valve', 'suspension']))
  test(`${preset}: end 2 is held, under a force, or on a mass, and each way comes back as it was`, async ({ page }) => {
    await open(page, `#${preset}`);
    const before = await facts(page);
    const end = page.getByLabel('End 2', { exact: true });
    const was = await end.inputValue();
    const lines: number[] = [];
    for (const way of ['mass', 'held', 'force']) {
      await end.selectOption(way);
      lines.push((await facts(page)).lines[0]!);
      await expect(page.locator('.refusal').first()).toBeHidden();
      await expect(page.getByLabel('Mass at end 2', { exact: true })).toHaveCount(way === 'mass' ? 1 : 0);
    }
    // A quarter wave under a force, half a wave held: f1 is about half.
    expect(lines[2]! / lines[1]!).toBeGreaterThan(0.48);
    expect(lines[2]! / lines[1]!).toBeLessThan(0.56);
    expect(lines[0]).not.toBe(lines[1]);
    await end.selectOption(was);
    expect(await facts(page)).toEqual(before);
    await expect.poll(() => page.evaluate(() => location.hash)).toBe(`#${preset}`);
  });

test('what is typed before its reader has come is understood once it comes', async ({ page }) => {
  let come = () => {};
  const waits = new Promise<void>((resolve) => (come = resolve));
  await page.route('**/values-*.js', async (route) => {
    await waits;
    await route.continue();
  });
  await open(page);
  const stiffness = page.getByLabel('Stiffness k', { exact: true });
  await stiffness.fill('1,2 kN/m');
  await expect(page.locator('.status')).toHaveText('preview …');
  come();
  await exact(page);
  expect((await facts(page)).spring.stiffness).toBe(1200);
  await stiffness.blur();
  await expect(stiffness).toHaveValue('1.2 kN/m');
});

test('a log’s options take commas and bare numbers in the unit of their example', async ({ page }) => {
  await open(page, '#S_T&@tab=%22log%22');
  await page
    .getByRole('button', { name: /simulated/i })
    .first()
    .click();
  const panel = page.locator('#panel-log');
  await expect(panel.locator('.fields')).toBeVisible({ timeout: 60_000 });
  await panel.getByText('The spring', { exact: true }).click();
  const radius = page.getByLabel('Coil radius', { exact: true });
  await radius.fill('8,5');
  await expect(page.locator('#log-radius-understood')).toHaveText('= 8.5 mm');
  await radius.blur();
  await expect(radius).toHaveValue('8.5 mm');
  await expect.poll(() => page.url()).toContain('8.5+mm');
  // In doubt: the engine's refusal is told in the page's words.
  await radius.fill('1,001 mm');
  await radius.blur();
  await expect(page.locator('#log-radius-error')).toHaveText('may be 1.001 mm or 1001 mm: write one of them so', {
    timeout: 60_000,
  });
});
