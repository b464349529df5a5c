// The built page in the system's own Chromium; no browser is downloaded. COILSENSE_CHROMIUM and COILSENSE_COMMAND say where the browser and the
// command are, which `cargo xtask test --only page` sets; COILSENSE_PORT where two run on one machine.
import { defineConfig } from '@playwright/test';

/** What measures how quick the page is, or holds each of its files to three seconds, goes by itself; all else two at a time. */
const ALONE = ['speed.spec.ts', 'fault.spec.ts', 'recover.spec.ts', 'compare.spec.ts'];

const PORT = Number(process.env['COILSENSE_PORT'] ?? 4187);

export default defineConfig({
  testDir: 'tests',
  outputDir: 'test-results',
  globalSetup: './tests/command.ts',
  workers: 2,
  projects: [
    { name: 'most', testIgnore: ALONE },
    { name: 'alone', testMatch: ALONE, workers: 1 },
    {
      name: 'firefox',
      use: {
        browserName: 'firefox',
        channel: 'moz-firefox',
        launchOptions: {
          executablePath: new URL('tests/firefox.mjs', import.meta.url).pathname,
          args: [],
          firefoxUserPrefs: {
            'layout.css.prefers-color-scheme.content-override': 1,
            // Else the list of downloads opens, and has the focus.
            'browser.download.alwaysOpenPanel': false,
            // Pages that come back as they were left have no event that Playwright waits for.
            'browser.sessionhistory.max_total_viewers': 0,
          },
        },
      },
    },
  ],
  timeout: 120_000,
  reporter: [['list']],
  use: {
    baseURL: `http://127.0.0.1:${PORT}/some/where/`,
    // What keeps the page for later has tests of its own (`recover`).
    serviceWorkers: 'block',
    launchOptions: {
      executablePath: process.env['COILSENSE_CHROMIUM'] ?? '/usr/bin/chromium',
      args: ['--no-sandbox'],
    },
  },
  webServer: { command: `node tests/server.mjs ${PORT}`, url: `http://127.0.0.1:${PORT}/some/where/` },
});
