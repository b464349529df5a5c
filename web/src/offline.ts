// The page without a network: kept by a service worker, which is registered once nothing else is being loaded; and newer builds of it.
//
// Next door: the worker (`sw`).

import { byId } from './dom';
import { say } from './faults';

/** What stands there by itself is that it could not be kept. */
const line = byId('offline');

function kept(): void {
  line.textContent = 'Saved in this browser: the page also opens without a network.';
  line.hidden = false;
}

/** Whether the page is that of `coilsense app`, whose port is another program's tomorrow. No other host of this machine sends a policy. */
async function isLent(): Promise<boolean> {
  if (!/^(localhost|127\.|\[::1\])/.test(location.hostname)) return false;
  const reply = await fetch(location.pathname, { method: 'HEAD' });
  return reply.headers.has('content-security-policy');
}

export async function keep(): Promise<void> {
  const { serviceWorker, connection } = navigator as Navigator & { connection?: { saveData?: boolean } };
  // Without a secure address there are none; two megabytes are much for who saves data.
  if (!serviceWorker || connection?.saveData || (await isLent())) return;
  try {
    const registration = await serviceWorker.register(new URL('sw.js', location.href.replace(/[?#].*/, '')));
    const isFirst = !registration.active;
    if (!isFirst) kept();
    const follow = (worker: ServiceWorker | null) => {
      if (!worker) return;
      const see = () => {
        if (worker.state === 'redundant' && isFirst && !registration.active) line.hidden = false;
        if (worker.state === 'activated') kept();
        if (worker.state === 'installed' && registration.active) offer(serviceWorker, worker);
      };
      worker.addEventListener('statechange', see);
      see();
    };
    registration.addEventListener('updatefound', () => follow(registration.installing));
    follow(registration.waiting ?? registration.installing);
    // A browser asks for a newer build now and then by itself; without a network there is none.
    if (!isFirst) await registration.update().catch(() => {});
  } catch {
    line.hidden = false;
  }
}

/** A newer build waits until no page of the older one is open, or the user takes it. */
function offer(serviceWorker: ServiceWorkerContainer, worker: ServiceWorker): void {
  say('newer', 'There is a newer version of this page.', 'Open it', () => {
    serviceWorker.addEventListener('controllerchange', () => location.reload());
    worker.postMessage('now');
  });
}
