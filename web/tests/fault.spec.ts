// Each file of the page missing or cut short, one at a time: the page says so within three seconds, and "Try again" gets what was wanted once the
// fault is gone, with the state as it was.
import { expect, test, type Page } from '@playwright/test';
import { dropOn } from './drops';
import { FILES, Host, type Fault } from './host';
import { isLong } from './long';

/** Nothing may be silent for longer [ms]. */
const SILENT = 3000;
const STATE = 'spring.mass=66+g';

/** Ways to use the page, quick ones first, each with what it ends in. All of them together need every file. */
const USES: Record<string, { hash: string; use?: (page: Page) => Promise<void>; ends: (page: Page) => Promise<void> }> =
  {
    opened: { hash: `#S_T&${STATE}`, ends: (page) => exact(page) },
    picture: {
      hash: `#S_T&${STATE}`,
      use: async (page) => {
        await exact(page);
        page.on('download', () => (saved += 1));
        saved = 0;
        await page.getByRole('button', { name: 'Forces (SVG)' }).click();
      },
      ends: async (page) => {
        // A page that was opened anew has not been asked yet.
        await exact(page);
        const isSaved = () => expect.poll(() => saved, { timeout: 2000 }).toBeGreaterThan(0);
        await isSaved().catch(() => page.getByRole('button', { name: 'Forces (SVG)' }).click());
        await isSaved();
      },
    },
    verdict: {
      // By wire and coil: a mass is refused there, and whether a verdict comes before that is chance.
      hash: '#valve&spring.wire_diameter=4.05+mm',
      ends: (page) => expect(page.locator('.trust .answer')).toBeVisible({ timeout: 40_000 }),
    },
    why: {
      hash: `#S_T&${STATE}`,
      use: (page) => page.getByText('Why the ends disagree, in four steps').click(),
      ends: (page) => expect(page.locator('.tour li')).toHaveCount(4),
    },
    refused: {
      hash: `#S_T&${STATE}&sensor.1.bandwidth=abc`,
      ends: (page) => expect(page.locator('#sensor-1-bandwidth-error')).toBeVisible({ timeout: 20_000 }),
    },
    words: {
      hash: `#S_T&${STATE}`,
      use: (page) => page.getByRole('button', { name: /^Glossary/ }).click(),
      ends: async (page) => {
        await exact(page);
        const dialog = page.locator('.glossary');
        const isOpen = () => expect(dialog).toBeVisible({ timeout: 2000 });
        await isOpen().catch(() => page.getByRole('button', { name: /^Glossary/ }).click());
        await isOpen();
      },
    },
    shelf: {
      hash: `#S_T&${STATE}`,
      use: async (page) => {
        await exact(page);
        await page.locator('#more-spring > summary').click();
      },
      ends: async (page) => {
        const group = page.locator('#more-spring');
        // A page that was opened anew has not been asked yet.
        if ((await group.getAttribute('open')) === null) await group.locator('summary').click();
        await expect(page.locator('#spring-material option')).not.toHaveCount(1, { timeout: 20_000 });
      },
    },
    compared: {
      hash: `#S_T&${STATE}`,
      use: async (page) => {
        await exact(page);
        await page.getByRole('button', { name: 'Keep to compare' }).click();
      },
      ends: async (page) => {
        // A page that is opened anew has not been asked yet.
        const [keep, kept] = [page.getByRole('button', { name: 'Keep to compare' }), page.locator('.beside')];
        const isKept = () => expect(kept).toBeVisible({ timeout: 4000 });
        await isKept().catch(() => keep.click());
        await isKept();
      },
    },
    sensors: {
      hash: `#S_T&${STATE}&@sensors=["laser","two+encoders"]`,
      ends: (page) => expect(page.locator('.pair tbody tr')).toHaveCount(2, { timeout: 20_000 }),
    },
    modes: { hash: `#S_T&${STATE}`, ...unfolded('.every', '.every [aria-busy=false]') },
    response: {
      hash: `#S_T&${STATE}&@frequency=20`,
      // The verdict asks the same engine: what is missing of that is said by whoever asks first.
      ends: (page) => expect(page.locator('.two-ends [aria-busy=false]')).toBeVisible({ timeout: 40_000 }),
    },
    speeds: { hash: '#valve&spring.wire_diameter=4.05+mm', ...unfolded('.speeds-of', '.over-speed canvas') },
    paper: {
      hash: `#S_T&${STATE}&@tab="paper"`,
      ends: (page) => expect(page.locator('.paper[aria-busy=false]')).toBeVisible({ timeout: 20_000 }),
    },
    valve: { hash: '#valve&spring.coil_diameter=24.9+mm', ends: (page) => exact(page) },
    suspension: { hash: '#suspension&spring.mass=2+kg', ends: (page) => exact(page) },
    meeting: {
      hash: '#S_A&contact.windings=hard&contact.restitution=0.5&spring.mass=66+g',
      ends: (page) => expect(page.locator('.meetings h2')).toBeVisible({ timeout: 20_000 }),
    },
    log: {
      hash: `#S_T&${STATE}&@tab="log"`,
      ends: (page) =>
        expect(page.getByRole('button', { name: 'Try it with a simulated log' })).toBeVisible({ timeout: 20_000 }),
    },
    dropped: {
      hash: `#S_T&${STATE}`,
      use: async (page) => {
        await exact(page);
        await dropOn(page, 'body', 'nothing.txt', 'no log');
      },
      ends: async (page) => {
        await expect(page.locator('#panel-log .asked > .refusal')).toBeVisible({ timeout: 20_000 });
      },
    },
    judged: {
      hash: `#S_T&${STATE}&@tab="mitigate"`,
      ends: (page) => expect(page.getByLabel('Most lag')).toHaveAttribute('placeholder', '30 deg', { timeout: 20_000 }),
    },
    mitigate: {
      hash: `#S_T&${STATE}&@tab="mitigate"&@mitigate={"seeds":"1","candidate":"none"}`,
      ends: (page) =>
        expect(page.locator('#panel-mitigate tr[data-candidate]').first()).toBeVisible({ timeout: 60_000 }),
    },
    // The last: what it shares with others they can load again by themselves.
    film: {
      hash: `#S_T&${STATE}&@times=[0,0.01]&@slow=0.005`,
      use: async (page) => {
        await exact(page);
        page.on('download', () => (saved += 1));
        saved = 0;
        await page.getByRole('button', { name: 'Film (GIF)' }).click();
      },
      ends: async (page) => {
        await exact(page);
        const isSaved = (timeout: number) => expect.poll(() => saved, { timeout }).toBeGreaterThan(0);
        // A page that was opened anew has not been asked yet.
        if ((await page.locator('.filmed').textContent()) === '')
          await page.getByRole('button', { name: 'Film (GIF)' }).click();
        await isSaved(30_000);
      },
    },
  };
/** A card that is folded until somebody opens it, and what is seen in it then. */
function unfolded(card: string, seen: string) {
  const summary = (page: Page) => page.locator(`${card} > details > summary`);
  return {
    use: async (page: Page) => {
      await exact(page);
      await summary(page).click();
    },
    ends: async (page: Page) => {
      // A page that was opened anew has not been asked yet.
      await expect(async () => {
        if ((await page.locator(`${card} > details`).getAttribute('open', { timeout: 2000 })) === null)
          await summary(page).click({ timeout: 2000 });
        await expect(page.locator(seen)).toBeVisible({ timeout: 4000 });
      }).toPass({ timeout: 20_000 });
    },
  };
}

const exact = async (page: Page): Promise<void> => {
  await page.waitForFunction(() => document.body.dataset['exact'] === 'true', null, { timeout: 20_000 });
};

let saved = 0;
const host = new Host();
/** Which use needs a file first. */
const needs = new Map<string, string>();
/** What does without: nobody misses the icon, the licences, the picture for others, who warns, what keeps the page for later, who mends, nor what zooms by two fingers. */
const SPARE = [
  /^icon\.svg$/,
  /^notices\.txt$/,
  /^shared\.png$/,
  /^assets\/touch-/,
  /^sw\.js$/,
  /^assets\/offline-/,
  /^assets\/guard-/,
  /^assets\/anew-/,
];
const isSpare = (file: string): boolean => SPARE.some((pattern) => pattern.test(file));

test.use({ serviceWorkers: 'block' });
test.beforeAll(async ({ browser }) => {
  test.setTimeout(120_000);
  await host.begin();
  for (const [name, { hash, use, ends }] of Object.entries(USES)) {
    host.heal();
    const page = await browser.newPage({ serviceWorkers: 'block' });
    await page.goto(host.address + hash);
    await use?.(page);
    await ends(page);
    for (const file of host.asked) if (!needs.has(file)) needs.set(file, name);
    await page.close();
  }
});
test.beforeEach(() => host.heal());
test.afterAll(() => host.end());

/** What tells of a fault, and tries again. */
const retry = (page: Page) => page.getByRole('alert').getByRole('button', { name: 'Try again' }).first();

/** Files that are tried: each of them in the long proof, else engines, workers, and every third of the others. */
const TRIED = FILES.filter((file) => file !== 'index.html' && !isSpare(file)).filter(
  (file, index) => isLong || index % 3 === 0 || /worker|\.wasm$/.test(file),
);
/** The faults of a file: each of them in the long proof, else one after another from file to file. */
const FAULTS = ['cut', 'aborted', 'missing'] satisfies Fault[];
const first = (file: string): Fault => (isLong ? 'cut' : (FAULTS[TRIED.indexOf(file) % FAULTS.length] ?? 'cut'));
const after = (_: string): Fault[] => (isLong ? ['aborted', 'missing'] : []);

test('every file of the page is needed by one of these uses, or can be spared', () => {
  expect(FILES.length).toBeGreaterThan(20);
  expect(FILES.filter((file) => !needs.has(file) && !isSpare(file))).toEqual([]);
});

for (const file of TRIED)
  test(`${file} cut short, aborted, missing`, async ({ page }) => {
    const { hash, use, ends } = USES[needs.get(file) ?? ''] ?? { hash: '', ends: exact };
    host.faults.set(file, first(file));
    await page.goto(host.address + hash);
    await use?.(page);
    let before = '';
    // Whatever is tried while it is wrong, it is said again.
    for (const fault of [...after(file), null]) {
      await expect(retry(page), `before ${fault}`).toBeVisible({ timeout: SILENT });
      const words = page.getByRole('alert').filter({ hasText: 'Try again' }).first();
      await expect(words).toHaveText(/missing|cut short|not on the server|bytes|loaded/);
      before = new URL(page.url()).hash;
      if (fault) host.faults.set(file, fault);
      else host.faults.clear();
      await retry(page).click();
    }
    await ends(page);
    await expect(retry(page)).toHaveCount(0);
    // A dropped log opens its tab.
    expect(new URL(page.url()).hash.startsWith(before), 'the state').toBe(true);
    if (hash.includes(STATE)) expect(decodeURIComponent(page.url())).toContain(STATE);
  });

for (const fault of ['aborted', 'missing', 'cut'] satisfies Fault[])
  test(`what can be spared is not missed where it is ${fault}`, async ({ page }) => {
    for (const file of FILES.filter(isSpare)) host.faults.set(file, fault);
    await page.goto(`${host.address}#S_T&${STATE}`);
    await exact(page);
    await expect(page.getByRole('alert')).toHaveCount(0);
  });
