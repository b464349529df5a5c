// What is chosen by name: materials and sensor classes are those of the engine's tables, and say what they bring along.
import { command } from './command';
import { expect, exact, facts, open, test } from './page';

test('materials are those that the command lists, and the chosen one says its values', async ({ page }) => {
  await open(page);
  await page.locator('#more-spring > summary').click();
  const list = page.locator('#spring-material');
  await expect(list.locator('option')).not.toHaveCount(1);
  const names = await list.locator('option:not([value=""])').evaluateAll((all) => all.map((one) => one.textContent));
  // A material's name stands at the beginning of a line, its values are indented.
  const told = command('spring', '--materials').split('\n');
  expect(names).toEqual(told.filter((line) => /^\S/.test(line)));
  await list.selectOption('stainless 1.4310');
  await expect(page.locator('#spring-material-hint')).toContainText('shear modulus 70 GPa');
  await exact(page);
  expect((await facts(page)).spring.material).toContain('stainless 1.4310');
  await expect.poll(() => page.url()).toContain('spring.material=stainless');
  await list.selectOption('');
  await expect.poll(() => page.url()).not.toContain('spring.material');
});

test('a sensor shows the kind that its class has, offers classes of that kind, and what a class leaves to be said', async ({
  page,
}) => {
  await open(page);
  await page.locator('#more-sensors > summary').click();
  const { sensors } = await facts(page);
  for (const [index, { kind }] of sensors.entries())
    await expect(page.locator(`#sensor-${index}-kind`)).toHaveValue(kind);
  await page.getByRole('button', { name: 'Add a sensor' }).click();
  const added = sensors.length;
  await page.locator(`#sensor-${added} > summary`).click();
  const list = page.locator(`#sensor-${added}-class`);
  await expect(list.locator('option', { hasText: 'laser' })).toHaveCount(0);
  await list.selectOption('piezoelectric load cell with charge amplifier');
  await expect(page.locator(`#sensor-${added}-class-hint`)).toContainText('bandwidth 33 kHz');
  await page.locator(`#sensor-${added}-bandwidth`).fill('');
  await expect(page.locator(`#sensor-${added}-bandwidth`)).toHaveAttribute('placeholder', '33 kHz');
  await exact(page);
  expect((await facts(page)).sensors[added]).toMatchObject({ kind: 'load-cell' });
  await page.locator(`#sensor-${added}-kind`).selectOption('deflection');
  await expect(list.locator('option', { hasText: 'laser triangulation' })).toHaveCount(1);
});
