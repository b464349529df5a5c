// The service worker: keeps every file of one build, checked by its hash, and answers from them alone, so that no page is a mix of two builds.
//
// Next door: what registers it (`offline`), what names build and files (`whole.ts`, beside the configuration).

/** Of the build: its name, and each file's hash by its path; the page itself is ''. */
declare const BUILD: string;
declare const FILES: Record<string, string>;

interface Worker {
  registration: { scope: string };
  clients: { claim(): Promise<void> };
  skipWaiting(): Promise<void>;
  addEventListener(kind: string, act: (event: Event & Extended) => void): void;
}
interface Extended {
  request: Request;
  data: unknown;
  waitUntil(done: Promise<unknown>): void;
  respondWith(reply: Promise<Response>): void;
}

const worker = self as unknown as Worker;
const { scope } = worker.registration;
/** Pages under other paths of one host have their own. */
const mine = `coilsense ${scope} `;
const cacheName = mine + BUILD;

async function hash(reply: Response): Promise<string> {
  const bytes = new Uint8Array(await crypto.subtle.digest('SHA-256', await reply.clone().arrayBuffer()));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** A file of this build, from an older cache or the network. */
async function whole(file: string): Promise<Response> {
  const address = new URL(file, scope).href;
  const kept = await caches.match(address);
  if (kept && (await hash(kept)) === FILES[file]) return kept;
  // What bears no hash in its name may be an older one in the browser's cache.
  const reply = await fetch(address, { cache: /-[\w-]{8}\.\w+$/.test(file) ? 'default' : 'no-cache' });
  if (!reply.ok || (await hash(reply)) !== FILES[file])
    throw new Error(`${file || 'the page'} is not that of this build`);
  return reply;
}

async function install(): Promise<void> {
  const cache = await caches.open(cacheName);
  try {
    // One after the other: whoever uses the page meanwhile has the network.
    for (const file of Object.keys(FILES)) await cache.put(new URL(file, scope).href, await whole(file));
  } catch (reason) {
    await caches.delete(cacheName);
    throw reason;
  }
}

async function activate(): Promise<void> {
  const old = (await caches.keys()).filter((name) => name.startsWith(mine) && name !== cacheName);
  await Promise.all(old.map((name) => caches.delete(name)));
  await worker.clients.claim();
}

async function answer(request: Request, address: string): Promise<Response> {
  const cache = await caches.open(cacheName);
  // A browser that is short of space may have thrown it away.
  return (await cache.match(address)) ?? fetch(request);
}

worker.addEventListener('install', (event) => event.waitUntil(install()));
worker.addEventListener('activate', (event) => event.waitUntil(activate()));
worker.addEventListener('message', ({ data }) => {
  if (data === 'now') void worker.skipWaiting();
});
worker.addEventListener('fetch', (event) => {
  const { request } = event;
  const [plain = ''] = request.url.split(/[?#]/);
  const file = plain === `${scope}index.html` ? '' : plain.slice(scope.length);
  // To load anew past every cache is asked for where something was wrong.
  if (request.method !== 'GET' || !plain.startsWith(scope) || !(file in FILES) || request.cache === 'reload') return;
  event.respondWith(answer(request, new URL(file, scope).href));
});

export {};
