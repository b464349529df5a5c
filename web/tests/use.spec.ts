// What a person does on the page: drag, type, undo, share, make mistakes, use the keyboard only.
import { test as base } from '@playwright/test';
import { openModes } from './modes';
import { expect, exact, facts, MOVING, open, series, test } from './page';

const hitSlider = 'How hard it is hit, slider';

test('a slider changes the curves, the number beside it, the answer and the table', async ({ page }) => {
  await open(page);
  const before = {
    force: Math.max(...(await series(page, 'F_o'))),
    sentence: await page.locator('#sentence').textContent(),
    rmsd: (await facts(page)).forces['F_o']!.rmsd,
  };
  await page.getByRole('slider', { name: hitSlider }).fill('500');
  await expect(page.getByLabel('How hard it is hit', { exact: true })).toHaveValue('0.5 m/s');
  await expect(page.locator('#sentence')).not.toHaveText(before.sentence ?? '');
  const after = await facts(page);
  // Linear: twice the speed, twice the ringing.
  expect(after.forces['F_o']!.rmsd / before.rmsd).toBeCloseTo(2, 9);
  expect(Math.max(...(await series(page, 'F_o')))).toBeGreaterThan(before.force + 3);
  await expect(page.locator('tr[data-force=F_o] td').nth(2)).toHaveText(
    ((100 * after.forces['F_o']!.rmsd) / after.spring.nominalForce).toFixed(3),
  );
});

test('a curve is hidden by keyboard, and the focus stays where it was', async ({ page }) => {
  await open(page);
  const line = page.locator('tr[data-force=F_i] button');
  await line.focus();
  await page.keyboard.press('Enter');
  await expect(line).toHaveAttribute('aria-pressed', 'false');
  await expect(line).toBeFocused();
});

test('what a sensor reads is drawn where it is asked for, told at the mark, and waits for exact values', async ({
  page,
}) => {
  await page.emulateMedia(MOVING.contextOptions);
  await open(page);
  const row = page.locator('tr[data-force="load cell, load side"] button');
  const key = page.locator('.keys > span', { hasText: 'load cell, load side' });
  await expect(row).toHaveAttribute('aria-pressed', 'false');
  await expect(key).toHaveCount(0);
  await row.click();
  await expect(row).toHaveAttribute('aria-pressed', 'true');
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.locator('.plot.forces').focus();
  await page.keyboard.press('ArrowRight');
  // The mark is told in milliseconds, the reading at the sample nearest to it, with as many decimals as all forces.
  const at = Number((await page.locator('.clock').textContent())!.replace(' ms', '')) / 1e3;
  const [times, { sensors }] = [await series(page, 'time'), await facts(page)];
  const number = sensors.findIndex(({ name }) => name === 'load cell, load side');
  const nearest = times.reduce(
    (best, time, index) => (Math.abs(time - at) < Math.abs(times[best]! - at) ? index : best),
    0,
  );
  const told = Number((await key.locator('output').textContent())!.replace(' N', ''));
  const around = (await series(page, `reading ${number}`)).slice(nearest - 1, nearest + 2);
  expect(told).toBeGreaterThan(Math.min(...around) - 0.06);
  expect(told).toBeLessThan(Math.max(...around) + 0.06);
  await page.evaluate(() => document.querySelector<HTMLInputElement>('input[aria-label="Mass m, slider"]')!.stepUp(40));
  await page.getByRole('slider', { name: 'Mass m, slider' }).dispatchEvent('input');
  await expect(key.locator('output')).toHaveText('…');
  await exact(page);
  await expect(key.locator('output')).toHaveText(/ N$/);
  await expect.poll(() => page.url()).toContain('@sensors=');
  await page.reload();
  await exact(page);
  await expect(key).toHaveCount(1);
  await row.click();
  await expect(key).toHaveCount(0);
});

test('a preview is marked, and exact values replace it within a second of rest', async ({ page }) => {
  await open(page);
  const modes = (await openModes(page)).locator('.every-mode');
  // How far off, and the modes of the coil.
  const bodies = page.locator('.results .scroll').first().locator('tbody');
  // Looked at in the page itself: exact values may be there before a question from here is answered.
  const marked = await page.getByRole('slider', { name: hitSlider }).evaluate(async (slider: HTMLInputElement) => {
    slider.value = '600';
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    const status = document.querySelector('.status')!;
    const marked = new Set<string>();
    // One turn after the other, from the preview's until the exact one's.
    for (let isMarked = false; !isMarked || status.textContent !== 'exact';) {
      isMarked ||= status.textContent === 'preview …';
      for (const part of document.querySelectorAll('.results .scroll tbody.stale, .every-mode.stale'))
        if (status.textContent === 'preview …') marked.add(part.tagName + part.className);
      await new Promise((resolve) => setTimeout(resolve));
    }
    return [...marked];
  });
  expect(marked.some((part) => part.startsWith('TBODY'))).toBe(true);
  expect(marked.some((part) => part.includes('every-mode'))).toBe(true);
  const begun = Date.now();
  await exact(page);
  console.log(`exact after ${Date.now() - begun} ms`);
  await expect(page.locator('.status')).toHaveText('exact');
  await expect(bodies).not.toHaveClass(/stale/);
  await expect(modes).not.toHaveClass(/stale/);
});

test('a spectrum whose axis begins just below a power of ten is drawn', async ({ page }) => {
  await open(page);
  const swing = Math.max(
    ...(await Promise.all(['F_i', 'F_o'].map((name) => series(page, `spectrum ${name}`)))).flatMap((all) =>
      all.slice(1),
    ),
  );
  // The axis begins at a power of ten below the largest line, which goes with the speed: 9.7 times such a power.
  const speed = (0.25 * 9.7 * 10 ** Math.floor(Math.log10(swing))) / swing;
  await page.getByLabel('How hard it is hit', { exact: true }).fill(`${speed.toFixed(6)} m/s`);
  await exact(page);
  const found = Math.max(
    ...(await series(page, 'spectrum F_i')).slice(1),
    ...(await series(page, 'spectrum F_o')).slice(1),
  );
  expect(found / 10 ** Math.floor(Math.log10(found))).toBeGreaterThan(9.5);
});

test('the address reproduces the whole state', async ({ page, context }) => {
  await open(page);
  await page.getByLabel('Stiffness k', { exact: true }).fill('1.1 N/mm');
  await page.getByLabel('Mass m', { exact: true }).fill('70 g');
  await page.getByRole('button', { name: '0.005', exact: true }).click();
  await page.locator('#condition').selectOption({ label: 'resonance' });
  await page.getByRole('button', { name: /\(judged\)$/ }).click();
  await expect.poll(() => page.url()).toContain('times');
  const told = await facts(page);
  const other = await context.newPage();
  await other.goto(page.url());
  const found = await facts(other);
  expect(found).toEqual(told);
  expect(found.spring.stiffness).toBe(1100);
  expect(found.conditions[found.condition]!.name).toBe('resonance');
  expect(found.dampings[found.damping]!.ratio).toBe(0.005);
  await expect(other.getByLabel('Stiffness k', { exact: true })).toHaveValue('1.1 N/mm');
  await other.close();
});

test('an address typed while the page writes its own is followed', async ({ page }) => {
  await open(page);
  await page.evaluate(() => {
    const own = location.href;
    location.hash = '#S_T&@condition=2';
    history.replaceState(null, '', own);
  });
  await exact(page);
  await expect.poll(async () => (await facts(page)).condition).toBe(2);
  await expect.poll(() => page.url()).toContain('condition=2');
});

test('a drag is undone as one, done again, and reset', async ({ page }) => {
  await open(page);
  const value = page.getByLabel('How hard it is hit', { exact: true });
  const slider = page.getByRole('slider', { name: hitSlider });
  // Within one gesture, however busy the machine is.
  await slider.evaluate((element: HTMLInputElement) => {
    for (const at of ['300', '400', '700']) {
      element.value = at;
      element.dispatchEvent(new Event('input', { bubbles: true }));
    }
  });
  await expect(value).toHaveValue('0.7 m/s');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(value).toHaveValue('0.25 m/s');
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect(value).toHaveValue('0.7 m/s');
  await page.getByRole('button', { name: 'Reset' }).click();
  await expect(value).toHaveValue('0.25 m/s');
  await exact(page);
});

test('a wrong input is red with the reason, and the last good plot stays', async ({ page }) => {
  await open(page);
  const before = await series(page, 'F_o');
  const mass = page.getByLabel('Mass m', { exact: true });
  for (const [typed, reason] of [
    // A bare number has the unit that the field shows (`typing.spec.ts`).
    ['65 m', 'must be a mass with its unit'],
    ['-3 g', 'mass must be above zero'],
    ['x', 'must be a mass'],
  ] as const) {
    await mass.fill(typed);
    await expect(page.locator('#spring-mass-error')).toContainText(reason);
    await expect(mass).toHaveAttribute('aria-invalid', 'true');
    await expect(page.locator('.refusal').first()).toContainText('last state that could be computed');
    expect(await series(page, 'F_o')).toEqual(before);
  }
  await mass.fill('66 g');
  await expect(page.locator('#spring-mass-error')).toBeHidden();
  await expect(mass).not.toHaveAttribute('aria-invalid', 'true');
  await exact(page);
  expect((await facts(page)).spring.mass).toBeCloseTo(0.066, 12);
});

test('an address that no page wrote is answered by a page that works', async ({ page }) => {
  for (const hash of [
    '#nobody&spring.mass=1+kg&@condition=99',
    '#S_T&%E0%A4%A&constructor.prototype=1&@times=7&@tab=none',
    '#S_T&-condition&-spring.mass',
  ]) {
    await page.goto(`./${hash}`);
    await page.reload();
    await expect(page.locator('#preset')).toBeVisible();
    await page.getByRole('button', { name: 'Reset' }).click();
    await exact(page);
  }
});

test('a spring turns from values into wire and coil and back', async ({ page }) => {
  await open(page);
  const { spring } = await facts(page);
  await page.getByText('The spring, in full').click();
  await page.getByLabel('wire and coil').check();
  await expect(page.getByLabel('Wire diameter d', { exact: true })).toHaveValue('2 mm');
  await exact(page);
  const wound = (await facts(page)).spring;
  expect(wound.byGeometry).toBe(true);
  // S_T's steel, by its formulas: k to some per cent.
  expect(Math.abs(wound.stiffness / spring.stiffness - 1)).toBeLessThan(0.05);
  await page.getByLabel('values', { exact: true }).check();
  await exact(page);
  // Nothing of the wire was edited: the values are those that were given, not what their formulas make of the wire.
  expect((await facts(page)).spring).toEqual(spring);
});

test('every kind of condition can be added', async ({ page }) => {
  await open(page);
  for (const kind of ['impact', 'end-stop', 'harmonic', 'sweep', 'step', 'ramp', 'pulse']) {
    await page.locator('#condition').selectOption(`new:${kind}`);
    await exact(page);
    const found = await facts(page);
    expect(found.conditions[found.condition]!.kind).toBe(kind);
  }
});

test('windings that touch are said, marked and drawn', async ({ page }) => {
  await open(page, '#S_A&@condition=4');
  await expect(page.locator('[data-subject=clash]')).toContainText('windings touch from t = 0.523 s');
  await expect(page.getByRole('img', { name: /The spring S_A with its 25 windings/ }).first()).toBeVisible();
  await expect(page.locator('#sentence')).toContainText('Windings touch');
});

test('zoom by buttons and keys, and the mark by arrows', async ({ page }) => {
  await page.emulateMedia(MOVING.contextOptions);
  await open(page);
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.getByRole('button', { name: /\(all\)$/ }).click();
  const times = () => page.evaluate(() => window.coilsense.last()?.times);
  await expect.poll(times).toEqual([0, 1]);
  await page.getByRole('group', { name: /Forces over time/ }).focus();
  await page.keyboard.press('+');
  await expect.poll(async () => ((await times()) ?? [0, 1])[1]! - ((await times()) ?? [0, 1])[0]!).toBeCloseTo(0.5, 6);
  const clock = page.locator('.clock');
  const before = await clock.textContent();
  await page.keyboard.press('Shift+ArrowRight');
  await expect(clock).not.toHaveText(before ?? '');
});

test('all of it by keyboard: every control is reached in order', async ({ page }) => {
  await page.emulateMedia(MOVING.contextOptions);
  await open(page);
  const met: string[] = [];
  for (let press = 0; press < 120; press++) {
    await page.keyboard.press('Tab');
    const name = await page.evaluate(() => {
      const at = document.activeElement;
      return at && at !== document.body
        ? (
            at.getAttribute('aria-label') ??
            (at as HTMLInputElement).labels?.[0]?.textContent ??
            at.textContent ??
            at.tagName
          ).trim()
        : '';
    });
    // Behind the last control the browser's own begin.
    if (name === '') break;
    met.push(name);
  }
  for (const wanted of [
    'Spring',
    'Reset',
    'What happens',
    'Pause',
    'Time',
    'Speed',
    '0–1\u00a0s (all)',
    'How hard it is hit',
    'How hard it is hit, slider',
    'Damping ζ',
    'Stiffness k',
    'Your limit',
    'Spec (TOML)',
  ]) {
    expect(met, wanted).toContain(wanted);
  }
});

test('sliders and tabs by keyboard', async ({ page }) => {
  await open(page);
  const slider = page.getByRole('slider', { name: hitSlider });
  await slider.focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByLabel('How hard it is hit', { exact: true })).toHaveValue('0.251 m/s');
  await page.getByRole('tab', { name: 'Spring' }).focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('tab', { name: 'Log' })).toBeFocused();
  await page.keyboard.press('End');
  await expect(page.getByRole('tab', { name: 'Paper' })).toBeFocused();
  await expect(page.locator('.paper[aria-busy=false]')).toBeVisible({ timeout: 60_000 });
});

base('an engine that cannot be had is said, in place of waiting for ever', async ({ page }) => {
  await page.route('**/*.wasm', (route) => route.abort());
  await page.goto('./');
  await expect(page.locator('.refusal').first()).toContainText('The engine could not be loaded');
  await expect(page.locator('#sentence')).toHaveText('Nothing is computed yet.');
});
