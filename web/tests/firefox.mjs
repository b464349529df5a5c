#!/usr/bin/env node
// Firefox for Playwright, started in its place: COILSENSE_FIREFOX_PATH, or Debian's. What Playwright and Firefox ESR 153 do not have in common of
// WebDriver BiDi is added here to what they say to each other; all other messages pass as they are.
// - Every page is opened with a colour scheme, by a command that this Firefox does not know: it is carried out by the browser's own switch.
// - A download that is no navigation has no name of its own, and Playwright takes no notice of it: its address becomes its name.
// - Text that is filled into a field is no typing to Firefox, which tells no `change` after it: a script in every page does.
import { spawn } from 'node:child_process';
import { renameSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { WebSocket, WebSocketServer } from 'ws';

const SCHEME = 'emulation.setMediaFeaturesOverride';
const DOWNLOAD = 'browsingContext.download';
/** What the files of downloads are called, by their address. */
const names = new Map();
/** What this program asks has numbers that Playwright does not reach. */
const OWN = 2 ** 40;

const program = process.env['COILSENSE_FIREFOX_PATH'] || '/usr/bin/firefox-esr';
const browser = spawn(program, ['--remote-allow-system-access', ...process.argv.slice(2)], {
  stdio: ['ignore', 'inherit', 'pipe'],
});
browser.on('error', (error) => {
  console.error(`${program}: ${error.message}`);
  process.exit(1);
});
browser.on('exit', (code) => process.exit(code ?? 1));

browser.stderr.setEncoding('utf8');
browser.stderr.on('data', (text) => {
  const address = /WebDriver BiDi listening on (ws:\S+)/.exec(text)?.[1];
  if (!address) return void process.stderr.write(text);
  const server = new WebSocketServer({ host: '127.0.0.1', port: 0, path: '/session' });
  server.on('connection', (driver) => relay(driver, `${address}/session`));
  server.on('listening', () => console.error(`WebDriver BiDi listening on ws://127.0.0.1:${server.address().port}`));
});

/** Messages between Playwright and the browser. */
function relay(driver, address) {
  const upstream = new WebSocket(address, { perMessageDeflate: false, maxPayload: 2 ** 30 });
  const open = new Promise((resolve) => upstream.on('open', resolve));
  const answers = new Map();
  const ask = (method, params) =>
    new Promise((resolve, reject) => {
      const id = OWN + answers.size;
      answers.set(id, ({ type, result, message }) =>
        type === 'success' ? resolve(result) : reject(new Error(`${method}: ${message}`)),
      );
      upstream.send(JSON.stringify({ id, method, params }));
    });
  driver.on('message', async (data) => {
    await open;
    const text = data.toString();
    const { id, method, params } = JSON.parse(text);
    if (method !== SCHEME) upstream.send(text);
    // Commands are done one after another, so that no page is opened before this.
    if (method === 'session.new') await ask('script.addPreloadScript', { functionDeclaration: `${changes}` });
    if (method !== SCHEME) return;
    const answer = await scheme(ask, params).then(
      () => ({ type: 'success', id, result: {} }),
      (error) => ({ type: 'error', id, error: 'unknown error', message: error.message }),
    );
    driver.send(JSON.stringify(answer));
  });
  upstream.on('message', (data) => {
    const text = data.toString();
    const message = JSON.parse(text);
    const answer = answers.get(message.id);
    if (answer) answer(message);
    else driver.send(message.method?.startsWith(DOWNLOAD) ? download(message) : text);
  });
  driver.on('close', () => upstream.close());
  upstream.on('close', () => driver.close());
}

/** A message of a download, with its name; the file is where Playwright looks for it, also if an earlier one was called the same. */
function download({ params, ...message }) {
  const { url, suggestedFilename, filepath } = params;
  if (suggestedFilename) names.set(url, suggestedFilename);
  else if (filepath) renameSync(filepath, join(dirname(filepath), names.get(url)));
  return JSON.stringify({ ...message, params: { ...params, download: url } });
}

/** Light or dark for these pages; every new page of Playwright's is light, as the browser is (`layout.css.prefers-color-scheme.content-override`). */
async function scheme(ask, { features, contexts, userContexts }) {
  const wanted = features['prefers-color-scheme'] ?? 'none';
  if (userContexts) {
    if (wanted === 'dark') throw new Error(`a new page can only be light, not ${wanted}; ask with emulateMedia`);
    return;
  }
  const { contexts: windows } = await ask('browsingContext.getTree', { 'moz:scope': 'chrome', maxDepth: 0 });
  const { type, exceptionDetails } = await ask('script.evaluate', {
    expression: `{
      const { NavigableManager } = ChromeUtils.importESModule('chrome://remote/content/shared/NavigableManager.sys.mjs');
      for (const id of ${JSON.stringify(contexts)})
        NavigableManager.getBrowsingContextById(id).top.prefersColorSchemeOverride = ${JSON.stringify(wanted)};
    }`,
    target: { context: windows[0].context },
    awaitPromise: false,
  });
  if (type !== 'success') throw new Error(exceptionDetails.text);
}

/** In every page: who leaves a field that was filled in, or presses Enter in it, has changed it, as by typing. */
function changes() {
  const filled = new Set();
  const told = ({ target }) => filled.delete(target) && target.dispatchEvent(new Event('change', { bubbles: true }));
  window.addEventListener('input', (event) => event.isTrusted || event.data === null || filled.add(event.target), true);
  window.addEventListener('change', ({ target }) => filled.delete(target), true);
  window.addEventListener('blur', told, true);
  window.addEventListener('keydown', (event) => {
    if (event.key === 'Enter' && event.target.tagName === 'INPUT' && !event.defaultPrevented) told(event);
  });
}
