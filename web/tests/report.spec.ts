// The report that `analyze` writes, opened as a file: it asks for nothing, moves, is worked by keys, and says so where its data are damaged.
import { readFileSync, writeFileSync } from 'node:fs';
import { AxeBuilder } from '@axe-core/playwright';
import { type Page } from '@playwright/test';
import { reportOf, resultsOf } from './command';
import { typical } from './long';
import { expect, test } from './page';

const REPORT = reportOf('sea-ankle');

async function open(page: Page, file = REPORT, hash = ''): Promise<void> {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto(`file://${file}${hash}`);
}

/** The report with its data changed, as a file beside it. */
function changed(name: string, change: (data: string) => string): string {
  const [before, data, after] = readFileSync(REPORT, 'utf8').split(/(?<=id="coilsense-data">)(.*?)(?=<\/script>)/s);
  const file = reportOf('sea-ankle').replace('report.html', `${name}.html`);
  writeFileSync(file, `${before}${change(data ?? '')}${after}`);
  return file;
}

const clock = (page: Page) => page.locator('.clock');
const forces = (page: Page) => page.getByRole('group', { name: /^Forces, / });
const row = (page: Page, name: string) => page.locator('.signals tbody tr', { hasText: name });

for (const colorScheme of typical(['light', 'dark'] as const))
  for (const width of [390, 1280])
    test(`it is drawn from one file: ${colorScheme}, ${width} px`, async ({ page }) => {
      const asked: string[] = [];
      page.on('request', (request) => asked.push(request.url()));
      await page.setViewportSize({ width, height: 900 });
      await page.emulateMedia({ colorScheme });
      await open(page);
      await expect(page.locator('.uplot')).toHaveCount(2);
      await expect(page.getByRole('img', { name: /The spring S_T with its 52 windings/ })).toBeVisible();
      // Something is drawn in both charts and on the spring's canvas.
      for (const canvas of await page.locator('canvas').all())
        expect(await canvas.evaluate((one: HTMLCanvasElement) => one.toDataURL().length)).toBeGreaterThan(5000);
      expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
      expect(asked).toEqual([`file://${REPORT}`]);
      const found = await new AxeBuilder({ page })
        .include(['#coilsense-case'])
        .include('#coilsense-spring')
        .include('#coilsense-signals')
        .analyze();
      expect(found.violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([]);
    });

test('its numbers are those of results.json', async ({ page }) => {
  await open(page);
  const [first] = resultsOf('sea-ankle').cases;
  await expect(page.locator('#coilsense-case')).toContainText(`${first!.condition}, ${first!.damping}`);
  for (const name of ['F_i', 'F_o'])
    await expect(row(page, name.replace('_', '')).locator('td').last()).toContainText(
      first!.forces[name]!.maximum_absolute_n.toFixed(2),
    );
});

test('the spring moves, the mark and the numbers with it, until it is halted', async ({ page }) => {
  await open(page);
  const mark = page.locator('.mark').first();
  const [before, place] = [await clock(page).textContent(), await mark.getAttribute('style')];
  await page.getByRole('button', { name: 'Play' }).click();
  await expect(clock(page)).not.toHaveText(before ?? '');
  await expect.poll(() => mark.getAttribute('style')).not.toBe(place);
  await expect(page.locator('.signals thead')).not.toContainText(before ?? '');
  await page.getByRole('button', { name: 'Pause' }).click();
  const halted = await clock(page).textContent();
  await page.waitForTimeout(300);
  await expect(clock(page)).toHaveText(halted ?? '');
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await page.reload();
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
});

test('keys do all of it', async ({ page }) => {
  await open(page);
  await forces(page).focus();
  await page.keyboard.press('Shift+ArrowRight');
  await expect(clock(page)).toHaveText('775.0 ms');
  const reset = page.getByRole('button', { name: 'Reset zoom' });
  await expect(reset).toBeDisabled();
  await page.keyboard.press('+');
  await expect(reset).toBeEnabled();
  await page.keyboard.press('Home');
  await expect(clock(page)).toHaveText('762.5 ms');
  await page.keyboard.press('Escape');
  await expect(reset).toBeDisabled();
  const line = row(page, 'laser').getByRole('button');
  await line.focus();
  await page.keyboard.press('Enter');
  await expect(line).toHaveAttribute('aria-pressed', 'false');
  const condition = page.getByRole('button', { name: 'resonance', exact: true });
  await condition.focus();
  await page.keyboard.press('Enter');
  await expect(condition).toBeFocused();
  await expect(page.locator('#coilsense-case')).toContainText('resonance, ζ = 0');
  // What was hidden stays so in another case.
  await expect(row(page, 'laser').getByRole('button')).toHaveAttribute('aria-pressed', 'false');
  await page.getByRole('slider', { name: 'Displacement' }).focus();
  await page.keyboard.press('Home');
  await expect(page.locator('.legend')).toContainText('Drawn true to scale');
});

test('a drag in one chart zooms all, and a double click goes back', async ({ page }) => {
  await open(page);
  const over = page.locator('.u-over').first();
  await over.scrollIntoViewIfNeeded();
  const { x, y, width } = (await over.boundingBox())!;
  await page.mouse.move(x + 0.2 * width, y + 50);
  await page.mouse.down();
  await page.mouse.move(x + 0.22 * width, y + 60, { steps: 5 });
  await page.mouse.up();
  await expect(clock(page)).toHaveText(/^(799|80\d)\.\d ms$/);
  // The largest error of five milliseconds is not that of all.
  await expect(row(page, 'Fo').locator('td').last()).not.toContainText('3.96');
  await over.dblclick();
  await expect(row(page, 'Fo').locator('td').last()).toContainText('3.96');
});

test('an address names a case', async ({ page }) => {
  await open(page, REPORT, '#case-resonance--zeta-0.005');
  await expect(page.locator('#coilsense-case')).toContainText('resonance, ζ = 0.005');
});

test('on paper it is light', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'dark' });
  await open(page);
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  expect(await page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue('--red'))).toBe(
    '#c82810',
  );
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  await expect(page.locator('html')).not.toHaveClass('paper');
});

test('damaged data are refused with a reason', async ({ page }) => {
  const alert = page.getByRole('alert');
  await open(
    page,
    changed('cut', (data) => data.slice(0, data.length / 2)),
  );
  await expect(alert).toHaveText('The signals of this report cannot be shown: its data end early or are no JSON.');
  await open(
    page,
    changed('empty', () => '{"cases":[]}'),
  );
  await expect(alert).toContainText('it holds no case');
  await open(
    page,
    changed('short', (data) => data.replace(/("data":")[^"]{8}/, '$1')),
  );
  await expect(alert).toHaveText(/^This case cannot be drawn: the signal u1: \d+ bytes, not \d+\.$/);
  await expect(page.locator('.uplot')).toHaveCount(0);
  // The other cases are whole.
  await page.getByRole('button', { name: 'resonance', exact: true }).click();
  await expect(alert).toBeHidden();
  await expect(page.locator('.uplot')).not.toHaveCount(0);
  await open(
    page,
    changed('letters', (data) => data.replace(/("data":")./, '$1?')),
  );
  await expect(alert).toContainText('the signal u1: its numbers cannot be read');
  await open(
    page,
    changed('times', (data) => data.replace(/"step_s":[^,}]*/, '"step_s":0')),
  );
  await expect(alert).toContainText('its times are damaged');
});
