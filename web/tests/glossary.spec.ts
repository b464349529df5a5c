// The glossary: each word of it is on the page, each place that it names in the book is there, and it opens and closes for mouse, finger and keys.
import { readFileSync } from 'node:fs';
import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { GLOSSARY } from '../src/glossary/terms';
import { typical } from './long';
import { openModes } from './modes';
import { expect, open, test } from './page';

const TERMS = GLOSSARY.flatMap(({ terms }) => terms);
const root = new URL('../..', import.meta.url);
const read = (file: string): string => readFileSync(new URL(file, root), 'utf8');
const dialog = (page: Page) => page.getByRole('dialog', { name: 'Glossary' });
const opener = (page: Page) => page.getByRole('button', { name: /^Glossary/ });

/** A heading's address, as GitHub and mdBook both make it. */
const slug = (heading: string): string =>
  heading
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .replace(/\s/g, '-');

test('every page and heading of the book that it names is there', () => {
  const headings = new Map<string, string[]>();
  for (const { id, book } of TERMS) {
    const [file = '', heading = ''] = book.split('#');
    if (!headings.has(file))
      headings.set(
        file,
        read(`book/src/${file}`)
          .replace(/^```[\s\S]*?^```/gm, '')
          .split('\n')
          .flatMap((line) => /^#{1,6} (.*)$/.exec(line)?.[1] ?? [])
          .map(slug),
      );
    expect(headings.get(file), `${id}: ${book}`).toContain(heading);
  }
});

test('no two have one name, and none is empty', () => {
  const ids = [...GLOSSARY, ...TERMS].map(({ id }) => id);
  expect(new Set(ids).size).toBe(ids.length);
  for (const { id, words, names } of TERMS) {
    expect(words, id).toMatch(/^[A-ZÀ-Ž].*\.$/);
    expect(names.length, id).toBeGreaterThan(0);
    // One or two plain sentences, three at most.
    expect(words.split(/[.:] (?=[A-Z])/).length, id).toBeLessThanOrEqual(4);
  }
});

test('every word of it is used on the page, and every mark of the page has its word', async ({ page }) => {
  test.setTimeout(240_000);
  const seen: string[] = [];
  const marks = new Set<string>();
  const look = async () => {
    seen.push(await page.evaluate(() => document.body.textContent ?? ''));
    for (const mark of await page.locator('[data-word]').evaluateAll((all) => all.map((one) => one.dataset['word'])))
      marks.add(mark ?? '');
  };
  await page.goto('./#S_A&contact.windings=hard&contact.restitution=0.5&spring.mass=66+g');
  await expect(page.locator('.meetings h2')).toBeVisible({ timeout: 60_000 });
  await look();
  await page.goto('about:blank');
  await open(page, '#S_A&@condition=4');
  await look();
  await page.goto('about:blank');
  await open(page, '#S_T');
  await expect(page.locator('.trust .answer')).toBeVisible({ timeout: 60_000 });
  await openModes(page);
  await page.locator('#more-spring > summary').click();
  await page.getByText('wire and coil', { exact: true }).click();
  await look();
  await page.getByRole('tab', { name: 'Log' }).click();
  await page.getByRole('button', { name: 'Try it with a simulated log' }).click();
  await expect(page.locator('#panel-log h2').first()).toBeVisible();
  await look();
  await page.getByRole('tab', { name: 'Mitigate' }).click();
  await page.goto('about:blank');
  await page.goto('./#S_T&@tab="mitigate"&@mitigate={"seeds":"1","candidate":"none"}');
  await expect(page.locator('#panel-mitigate tr[data-candidate]').first()).toBeVisible({ timeout: 60_000 });
  await look();
  await page.getByRole('tab', { name: 'Paper' }).click();
  await expect(page.locator('.paper[aria-busy=false]')).toBeVisible({ timeout: 60_000 });
  await look();
  const text = seen.join('\n');
  // Letters that are lowered stand without their line.
  const unused = TERMS.flatMap(({ names }) => names).filter(
    (name) => !text.includes(name.replace(/_/g, '')) && !text.includes(name),
  );
  expect(unused).toEqual([]);
  const known = new Set(['', ...[...GLOSSARY, ...TERMS].map(({ id }) => id)]);
  expect([...marks].filter((mark) => !known.has(mark))).toEqual([]);
  // Each group has a mark somewhere, so that nobody has to look for the footer.
  const near = (id: string) =>
    marks.has(id) || GLOSSARY.find((one) => one.id === id)?.terms.some((term) => marks.has(term.id));
  expect(GLOSSARY.map(({ id }) => id).filter((id) => !near(id))).toEqual([]);
});

for (const colorScheme of typical(['light', 'dark'] as const))
  test(`opened at a word by mouse, with its unit and its links, in ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await open(page);
    const asked: string[] = [];
    page.on('request', (request) => asked.push(request.url()));
    expect(await page.evaluate(() => document.querySelector('.glossary'))).toBeNull();
    await page.locator('#sentence').getByRole('button', { name: 'Fnom' }).first().click();
    await expect(dialog(page)).toBeVisible();
    expect(asked.filter((url) => /open-/.test(url))).toHaveLength(1);
    const term = dialog(page).locator('#word-F_nom');
    await expect(term).toBeFocused();
    await expect(term).toBeInViewport();
    await expect(term).toHaveText('Fnom [N]');
    const words = dialog(page).locator('#word-F_nom + dd');
    await expect(words).toContainText('the largest static force in use');
    const doi = /doi: (10\..*)/.exec(read('CITATION.cff'))?.[1] ?? '';
    expect(doi).toMatch(/^10\.1109\//);
    await expect(words.getByRole('link', { name: /Paper/ })).toHaveAttribute('href', `https://doi.org/${doi}`);
    const repository = /^repository = "(.*)"/m.exec(read('Cargo.toml'))?.[1];
    await expect(words.getByRole('link', { name: 'Book' })).toHaveAttribute(
      'href',
      `${repository}/blob/main/book/src/start.md#words`,
    );
    expect((await new AxeBuilder({ page }).include('.glossary').analyze()).violations).toEqual([]);
    await dialog(page).getByRole('button', { name: 'Close' }).click();
    await expect(dialog(page)).toBeHidden();
  });

test('by keys: opened, searched, left by Escape, and the place is kept', async ({ page }) => {
  await open(page);
  await page.locator('#reset').focus();
  const mark = page.locator('.off .term.ask');
  await mark.focus();
  await page.keyboard.press('Enter');
  await expect(dialog(page).locator('#word-off')).toBeFocused();
  await dialog(page).getByLabel('Find a word').fill('fnom');
  await expect(dialog(page).locator('dt:visible').first()).toContainText('Fnom');
  await dialog(page).getByLabel('Find a word').fill('ratio');
  await expect(dialog(page).locator('#word-zeta')).toBeVisible();
  await expect(dialog(page).locator('#word-F_i')).toBeHidden();
  await dialog(page).getByLabel('Find a word').fill('zebra');
  await expect(dialog(page).getByRole('status')).toHaveText('No word of this page has “zebra”.');
  await page.keyboard.press('Escape');
  await expect(dialog(page)).toBeHidden();
  await expect(mark).toBeFocused();
  // The next time it has all words again; a space bar on a word does not start the player.
  await page.keyboard.press('Space');
  await expect(dialog(page).locator('#word-F_i')).toBeVisible();
});

test('whoever is at a word of the answer stays there while it changes', async ({ page }) => {
  await open(page);
  const mark = page.locator('#sentence [data-word=F_nom]').first();
  await mark.focus();
  const before = await page.locator('#sentence').textContent();
  await page.evaluate(() => {
    const slider = document.querySelector<HTMLInputElement>('input[aria-label="How hard it is hit, slider"]')!;
    slider.value = String(Number(slider.value) + 40);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  });
  await expect(page.locator('#sentence')).not.toHaveText(before ?? '');
  await expect(mark).toBeFocused();
});

test('beside it is out of it, and the footer opens it at its beginning', async ({ page }) => {
  await open(page);
  await opener(page).click();
  await expect(dialog(page).getByLabel('Find a word')).toBeFocused();
  await page.mouse.click(5, 400);
  await expect(dialog(page)).toBeHidden();
});

for (const [width, height] of typical([
  [320, 568],
  [375, 812],
  [640, 400],
] as const))
  test(`by a finger on ${width} × ${height}: nothing is wider, and it scrolls`, async ({ browser }) => {
    const context = await browser.newContext({ viewport: { width, height }, hasTouch: true, isMobile: true });
    const page = await context.newPage();
    await open(page);
    await page.locator('#sentence').getByRole('button', { name: 'rms' }).tap();
    await expect(dialog(page).locator('#word-rmsd')).toBeInViewport();
    const wide = await page.evaluate(() => ({
      page: document.documentElement.scrollWidth - innerWidth,
      all: [...document.querySelectorAll('.glossary *')].filter((one) => one.getBoundingClientRect().right > innerWidth)
        .length,
    }));
    expect(wide).toEqual({ page: 0, all: 0 });
    const close = dialog(page).getByRole('button', { name: 'Close' });
    await expect(close).toBeInViewport({ ratio: 1 });
    await close.tap();
    await expect(dialog(page)).toBeHidden();
    await context.close();
  });
