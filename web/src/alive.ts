// Whether a worker is alive: it holds a lock for as long as it lives, however busy it is, and whoever waits for that lock hears of its end.
//
// Next door: who begins workers and begins them anew (`lane`, `jobs/job`).

/** From a worker: the name of its lock. */
export interface Alive {
  alive: string;
}

/** Firefox refuses a lock to a worker or a page that is about to go, where nobody waits for it any more. */
const refused = (): void => {};

/** In a worker. Without locks (no secure address) an end is noticed by a question that nobody answers. */
export function live(): void {
  const alive = `worker ${Math.random()}`;
  navigator.locks
    ?.request(alive, () => {
      postMessage({ alive } satisfies Alive);
      return new Promise(() => {});
    })
    .catch(refused);
}

/** Tells when a worker has ended, or could not begin. */
export function watch(worker: Worker, ended: () => void): void {
  worker.addEventListener('error', ended);
  worker.addEventListener('message', ({ data }: MessageEvent<Alive | object>) => {
    if ('alive' in data) navigator.locks.request(data.alive, ended).catch(refused);
  });
}
