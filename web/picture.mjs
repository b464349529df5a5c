// Pictures of the built page: `npm --prefix web run picture` writes book/src/images/page.png, for README and book, and public/shared.png, which other sites show with a link. Motion is not wanted, so that the
// picture is the same every time; COILSENSE_CHROMIUM says where the browser is.
import { spawn } from 'node:child_process';
import { chromium } from '@playwright/test';

const PORT = 4188;
const STATE = '#S_T&@sensors=["load+cell,+load+side"]&@times=[0,0.06]';

const server = spawn(process.execPath, ['tests/server.mjs', String(PORT)], { stdio: 'inherit' });
const browser = await chromium.launch({
  executablePath: process.env['COILSENSE_CHROMIUM'] ?? '/usr/bin/chromium',
  args: ['--no-sandbox'],
});
try {
  const page = await browser.newPage({ viewport: { width: 1360, height: 960 }, reducedMotion: 'reduce' });
  const address = `http://127.0.0.1:${PORT}/some/where/`;
  for (let tries = 0; tries < 50; tries++) {
    const there = await fetch(address).catch(() => null);
    if (there?.ok) break;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  await page.goto(address + STATE);
  await page.waitForFunction(() => document.body.dataset['exact'] === 'true');
  await page.getByRole('slider', { name: 'Time', exact: true }).fill('210');
  await page.evaluate(() => document.activeElement?.blur());
  await page.screenshot({ path: '../book/src/images/page.png' });
  // What embeds show is large enough to be read as a thumbnail.
  await page.setViewportSize({ width: 1200, height: 630 });
  await page.goto(address + '?embed' + STATE);
  await page.waitForFunction(() => document.body.dataset['exact'] === 'true');
  await page.getByRole('slider', { name: 'Time', exact: true }).fill('210');
  await page.evaluate(() => document.activeElement?.blur());
  await page.screenshot({ path: 'public/shared.png' });
} finally {
  await browser.close();
  server.kill();
}
