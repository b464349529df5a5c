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

/** What Firefox runs each time: every tab, use by hand and by keys, the command's words and numbers. */
const FIREFOX: Listed = {
  'frame.spec.ts': ['each tab says what it is for'],
  'hit.spec.ts': ['a click hits as hard'],
  'log.spec.ts': ['a dropped log is identified'],
  'numbers.spec.ts': ['${preset}: every condition and damping'],
  'typing.spec.ts': ['a decimal comma, a bare number'],
  'use.spec.ts': ['a slider changes the curves', 'all of it by keyboard'],
  'verdict.spec.ts': ['${preset}: the verdict is that of coilsense analyze'],
  'wave.spec.ts': ['the strip tells the way of the wave'],
};
/** Presets whose numbers and words it is asked for in the long proof alone: those of the first are the command's in each run. */
const OTHER_PRESETS = /(S_A|valve|suspension): (every condition|the verdict)/;
/** What it runs in the long proof besides: kept states, films, files, links, and faults. */
const FIREFOX_LONG: Listed = {
  'access.spec.ts': ['nothing is wider than ${width} pixels'],
  'compare.spec.ts': ['a kept state stays beside the present one', 'a reload and a link keep it'],
  'film.spec.ts': ['an encoder that is slow', 'a browser ${what} saves a GIF'],
  'frame.spec.ts': ['a tab has its own title', 'embedded, the spring'],
  'glossary.spec.ts': ['opened at a word by mouse', 'by keys: opened, searched'],
  'history.spec.ts': [
    'Back goes to the tab before',
    'the link is that of what is shown',
    'where nothing may be copied',
  ],
  'hit.spec.ts': ['keys alone choose the speed', 'a flick is as fast', 'what could not be loaded'],
  'log-opens.spec.ts': ['German titles are taken', 'the pairs of the virtual rig'],
  'modes.spec.ts': ['a mode is picked in the table'],
  'response.spec.ts': ['sizes, phases and the limit', 'nothing of it is loaded before it is opened'],
  'use.spec.ts': ['a wrong input is red', 'sliders and tabs'],
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

/** What only the long proof runs: what goes wrong seldom, what takes long, and what others of its file are near to. */
const LONG: Listed = {
  'access.spec.ts': ['nothing moves by itself'],
  'aside.spec.ts': ['nothing is said where nothing'],
  'compare.spec.ts': [
    'a verdict that had not',
    'a reload and a link',
    'axe finds nothing',
    'kept curves are drawn behind',
    'Swap exchanges both',
    'another number of sensors',
    'windings that would touch',
    'a kept state that cannot',
    'what is refused is not kept',
    'an address that keeps nonsense',
    'the picture that is taken along',
    'sensors that are ticked',
  ],
  'contact.spec.ts': [
    'closed windings are marked',
    'switched on and off',
    'restitution and seats are',
    'a spring that is solid',
    'axe finds nothing',
  ],
  'film.spec.ts': [
    'WebM of',
    'an encoder that is slow',
    'GIF: the same film',
    'what is edited while',
    'cancelled, nothing is saved',
    'a spec that cannot',
    'other presets',
    'a GIF is made smaller',
  ],
  'finding.spec.ts': [
    'where the driven end moves',
    'without a hit there is',
    'the key stands above',
    'the sensors of the drawn case',
    'the buttons say their times',
    'a phone shows four columns',
    'the wave is drawn before',
    'the finding is one and the same',
  ],
  'frame.spec.ts': [
    'who has just come',
    'a tab has its own',
    'on paper there is',
    'the footer leads',
    'the licences of all',
  ],
  'glossary.spec.ts': ['by keys: opened', 'whoever is at a word', 'beside it is out of it', 'by a finger'],
  'history.spec.ts': [
    'where nothing may be copied',
    'Back from an address',
    'a page that is loaded again',
    'Undo, Redo and Reset',
  ],
  'hit.spec.ts': [
    'a flick is as fast',
    'what could not be loaded',
    'only the last 80 ms',
    'what meant to scroll',
    'an end that is pulled',
    'a pull stays within',
    'end 2 with a mass',
    'a hit while the spring',
    'of two hits at once',
    'nothing of the old motion',
    'where motion is not wanted',
    'a hit where what is shown',
  ],
  'lists.spec.ts': ['a sensor shows the kind'],
  'log-large.spec.ts': [
    '100 MB are identified',
    'Cancel while the engine',
    'a drop while another',
    'a wrong file after',
    'a folder, and a file',
  ],
  'log-more.spec.ts': [
    'the theories of the page',
    'the log is drawn as it was',
    'two logs that are dropped',
    'a log that says nothing',
    'a slider says what wire',
  ],
  'log-opens.spec.ts': ['runs in the layout', 'what is being typed', 'what the page and the command'],
  'log-options.spec.ts': ['a mapping file beside', 'delimiter and decimal', 'choices stay in the address'],
  'log-trial.spec.ts': ['the page’s spring predicts'],
  'mitigate.spec.ts': [
    'the stated scenario is',
    'settings are the command’s',
    'every option counts',
    'another spring has its own',
    'a point, a line of the table',
    'the signal and the pictures',
    'choices travel in',
    'judging can be cancelled',
    'where u1 moves',
  ],
  'modes.spec.ts': [
    'lines, all modes',
    'axe finds nothing',
    'a coil that is no helix',
    'it is said of which model',
    'the wire is turned',
    'the wire stands still',
    'where the spring buckles',
    'while what is typed',
    'nothing of it is wider',
  ],
  'numbers.spec.ts': ['a preview is the exact'],
  'readers.spec.ts': ['a field that is left', 'the mark that is moved', 'dragging a slider', 'Mitigate: typing'],
  'recover.spec.ts': [
    'the worker that judges',
    'workers that do not answer',
    'opened as a file',
    'a page that came with one build',
    'a log that is opened without',
    'engines that a host sends',
    'a link with keys',
    'a wrong value of another',
    'a wrong file after a good',
  ],
  'report.spec.ts': ['a drag in one chart', 'keys do all of it', 'an address names a case', 'on paper it is light'],
  'response.spec.ts': [
    'what is typed is understood',
    'axe finds nothing',
    'without damping no number',
    'over k × motion',
    'the dot is drawn where',
    'the dot is there before',
    'a link opens at',
    'end 2 under a force is',
    'windings that meet or touch',
    'while what is typed',
    'the coil stands still',
    'nothing of it is wider',
  ],
  'small.spec.ts': ['without a screen to touch', 'pinched beyond', 'a double tap', 'one finger scrolls'],
  'speeds.spec.ts': ['a recorded cycle has', 'the worst is told', 'a click on the curve'],
  'typing.spec.ts': [
    'numbers without a unit',
    'a log’s options take',
    'two values with',
    'restitution takes',
    'undo while a field',
    'what is typed before',
  ],
  'use.spec.ts': [
    'what a sensor reads',
    'a preview is marked',
    'sliders and tabs',
    'a curve is hidden by keyboard',
    'every kind of condition',
    'zoom by buttons',
    'a spectrum whose axis',
    'an address typed while',
    'an address that no page',
    'a spring turns from',
    'windings that touch',
  ],
  'verdict.spec.ts': ['on the car’s suspension', 'every choice of goal'],
  'wave.spec.ts': [
    'the strip has the wave',
    'axe finds nothing',
    'a key that comes',
    'what end 2 feels',
    'a force that is steady',
  ],
  'why.spec.ts': ['the numbers are of the state'],
};

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
/** What moves without end keeps half a core busy; tests of what moves ask for it (`MOVING`), and in the long proof all of it does. */
const still = { contextOptions: { reducedMotion: isLong ? ('no-preference' as const) : ('reduce' as const) } };

const seldom = isLong ? [] : patterns(LONG);

export default defineConfig({
  testDir: 'tests',
  outputDir: 'test-results',
  globalSetup: './tests/command.ts',
  workers: 2,
  projects: [
    { name: 'most', testIgnore: ALONE, grepInvert: seldom, use: { ...chromium, ...still } },
    { name: 'alone', testMatch: ALONE, grepInvert: seldom, workers: 1, use: chromium },
    {
      name: 'firefox',
      grep: isAll ? /./ : [...patterns(FIREFOX), ...(isLong ? patterns(FIREFOX_LONG) : [])],
      grepInvert: [...CHROMIUM.flatMap(([, listed]) => patterns(listed)), ...(isLong ? [] : [OTHER_PRESETS])],
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
