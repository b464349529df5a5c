#!/usr/bin/env node
// Firefox for Playwright, started in its place: COILSENSE_FIREFOX_PATH, or Debian's. Playwright asks every browser for a colour scheme by
// `emulation.setMediaFeaturesOverride`, and without an answer opens no page. Firefox ESR 153 does not know that command, so it is carried out here
// by the browser's own switch; all other messages pass as they are.
import { spawn } from 'node:child_process';
import { WebSocket, WebSocketServer } from 'ws';

const COMMAND = 'emulation.setMediaFeaturesOverride';
/** What this program asks has numbers that Playwright does not reach. */
const OWN = 2 ** 40;

const program = process.env['COILSENSE_FIREFOX_PATH'] ?? '/usr/bin/firefox-esr';
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
      answers.set(id, (answer) => (answer.type === 'success' ? resolve(answer.result) : reject(new Error(answer.message))));
      upstream.send(JSON.stringify({ id, method, params }));
    });
  driver.on('message', async (data) => {
    await open;
    const text = data.toString();
    const message = text.includes(COMMAND) ? JSON.parse(text) : {};
    if (message.method !== COMMAND) return upstream.send(text);
    const answer = await scheme(ask, message.params).then(
      () => ({ type: 'success', id: message.id, result: {} }),
      (error) => ({ type: 'error', id: message.id, error: 'unknown error', message: `${COMMAND}: ${error.message}` }),
    );
    driver.send(JSON.stringify(answer));
  });
  upstream.on('message', (data) => {
    const text = data.toString();
    const own = text.includes(`"id":${String(OWN).slice(0, 6)}`) ? JSON.parse(text) : {};
    const answer = answers.get(own.id);
    if (answer) answer(own);
    else driver.send(text);
  });
  driver.on('close', () => upstream.close());
  upstream.on('close', () => driver.close());
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
