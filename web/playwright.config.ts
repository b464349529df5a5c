// The built page in the system's own browsers; none is downloaded. COILSENSE_CHROMIUM, COILSENSE_FIREFOX_PATH and COILSENSE_COMMAND say where they
// and the command are, which `cargo xtask test --only page` sets; COILSENSE_PORT where two run on one machine. Chromium runs every test; Firefox
// those that `FIREFOX` lists, or with COILSENSE_FIREFOX=all every one that is not Chromium's alone.
import { readFileSync } from 'node:fs';
import { defineConfig } from '@playwright/test';
import { isLong } from './tests/long';

/** What measures how quick the page is, or holds each of its files to three seconds, goes by itself; all else two at a time. */
const ALONE = ['speed.spec.ts', 'fault.spec.ts', 'recover.spec.ts', 'compare.spec.ts'];

/** Tests by their file: how their titles begin, or all of them. */
type Listed = Record<string, readonly string[] | 'all'>;

/** What Firefox runs each time: every tab, use by hand and by keys, the command's words and numbers, logs, files, links, and faults. */
const FIREFOX: Listed = {
  'access.spec.ts': ['nothing is wider than ${width} pixels'],
  'compare.spec.ts': ['a kept state stays beside the present one', 'a reload and a link keep it'],
  'film.spec.ts': ['an encoder that is slow', 'a browser ${what} saves a GIF'],
  'frame.spec.ts': ['each tab says what it is for', 'a tab has its own title', 'embedded, the spring'],
  'glossary.spec.ts': ['opened at a word by mouse', 'by keys: opened, searched'],
  'history.spec.ts': [
    'Back goes to the tab before',
    'the link is that of what is shown',
    'where nothing may be copied',
  ],
  'hit.spec.ts': [
    'a click hits as hard',
    'a flick is as fast',
    'keys alone choose the speed',
    'what could not be loaded',
  ],
  'log-opens.spec.ts': ['German titles are taken', 'the pairs of the virtual rig'],
  'log.spec.ts': ['a dropped log is identified'],
  'modes.spec.ts': ['a mode is picked in the table'],
  'numbers.spec.ts': ['${preset}: every condition and damping'],
  'response.spec.ts': ['sizes, phases and the limit', 'nothing of it is loaded before it is opened'],
  'typing.spec.ts': ['a decimal comma, a bare number'],
  'use.spec.ts': ['a slider changes the curves', 'a wrong input is red', 'all of it by keyboard', 'sliders and tabs'],
  'verdict.spec.ts': ['${preset}: the verdict is that of coilsense analyze'],
  'wave.spec.ts': ['the strip tells the way of the wave'],
};

/** What cannot be asked of Firefox by way of Playwright, and why. */
const CHROMIUM: [why: string, Listed][] = [
  [
    'fingers, by the protocol of Chromium alone, and phones',
    {
      'glossary.spec.ts': ['by a finger on ${width}'],
      'hit.spec.ts': ['a finger scrolls the page'],
      'small.spec.ts': ['two that part zoom in', 'pinched beyond all', 'a double tap', 'one finger scrolls'],
    },
  ],
  [
    'media: only the colour scheme can be asked for, neither paper nor less motion',
    {
      'access.spec.ts': ['nothing moves by itself'],
      'compare.spec.ts': ['the picture that is taken along'],
      'frame.spec.ts': ['on paper there is the answer'],
      'hit.spec.ts': ['where motion is not wanted'],
      'modes.spec.ts': ['the wire stands still, bent'],
      'response.spec.ts': ['the dot is drawn where', 'the coil stands still where motion is not wanted'],
    },
  ],
  ['two clicks never are a double click', { 'log-more.spec.ts': ['the log is drawn as it was dropped'] }],
  [
    'memory and processes are read by the protocol of Chromium alone',
    { 'log-large.spec.ts': ['100 MB are identified', 'a folder, and a file that was changed'] },
  ],
  ['what is measured is written down of Chromium', { 'speed.spec.ts': 'all' }],
];

/** What Firefox runs in the long proof alone: the other presets' numbers and words, once the first one's are the command's. */
const FIREFOX_LONG = /(S_A|valve|suspension): (every condition|the verdict)/;

/** Patterns of listed tests; one that is in its file no more is an error, not a test that nobody runs. */
const patterns = (listed: Listed): RegExp[] =>
  Object.entries(listed).flatMap(([file, titles]) => {
    const source = readFileSync(new URL(`tests/${file}`, import.meta.url), 'utf8');
    const literal = (text: string) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
    return (titles === 'all' ? [''] : titles).map((title) => {
      if (!new RegExp(`test\\(\\s*['"\`]${literal(title)}`).test(source))
        throw new Error(`${file} has no test “${title}”`);
      return new RegExp(
        `${literal(file)} .*${title
          .split(/\$\{\w+\}/)
          .map(literal)
          .join('.*')}`,
      );
    });
  });

const PORT = Number(process.env['COILSENSE_PORT'] ?? 4187);
const isAll = process.env['COILSENSE_FIREFOX'] === 'all';

const chromium = {
  launchOptions: { executablePath: process.env['COILSENSE_CHROMIUM'] ?? '/usr/bin/chromium', args: ['--no-sandbox'] },
};

export default defineConfig({
  testDir: 'tests',
  outputDir: 'test-results',
  globalSetup: './tests/command.ts',
  workers: 2,
  projects: [
    { name: 'most', testIgnore: ALONE, use: chromium },
    { name: 'alone', testMatch: ALONE, workers: 1, use: chromium },
    {
      name: 'firefox',
      grep: isAll ? /./ : patterns(FIREFOX),
      grepInvert: [...CHROMIUM.flatMap(([, listed]) => patterns(listed)), ...(isAll || isLong ? [] : [FIREFOX_LONG])],
      use: {
        browserName: 'firefox',
        channel: 'moz-firefox',
        launchOptions: {
          // It starts Firefox, and adds what Playwright needs beyond that.
          executablePath: new URL('tests/firefox.mjs', import.meta.url).pathname,
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
  },
  webServer: { command: `node tests/server.mjs ${PORT}`, url: `http://127.0.0.1:${PORT}/some/where/` },
});
