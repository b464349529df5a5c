// A host of the built page that can be told to fail: any file missing, cut short, slow or of another type, and another build in place of this one.
//
// Next door: the host of all other tests (`server.mjs`).
import { createServer, type Server, type ServerResponse } from 'node:http';
import { readdirSync, readFileSync } from 'node:fs';
import type { AddressInfo } from 'node:net';
import { extname, join } from 'node:path';

const TYPES: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
};
const PATH = '/some/where/';

export const dist = new URL('../dist/', import.meta.url).pathname;
/** Every file of the built page, by its path. */
export const FILES = readdirSync(dist, { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile())
  .map((entry) => join(entry.parentPath, entry.name).slice(dist.length))
  .sort();

/** How a file fails; `hang` never answers. */
export type Fault = 'aborted' | 'missing' | 'cut' | 'hang';

export class Host {
  /** Files that fail. */
  readonly faults = new Map<string, Fault>();
  /** Files of another type or content than they have. */
  readonly types = new Map<string, string>();
  readonly contents = new Map<string, string | Buffer>();
  /** Files that were asked for. */
  readonly asked = new Set<string>();
  /** Milliseconds before each answer. */
  delay = 0;
  private readonly server: Server = createServer(({ url = '' }, response) => {
    const name = decodeURIComponent(url.replace(/[?#].*/, '').slice(PATH.length)) || 'index.html';
    this.asked.add(name);
    setTimeout(() => this.answer(url.startsWith(PATH) ? name : '', response), this.delay);
  });

  async begin(): Promise<void> {
    await new Promise<void>((resolve) => this.server.listen(0, '127.0.0.1', resolve));
  }

  get address(): string {
    return `http://127.0.0.1:${(this.server.address() as AddressInfo).port}${PATH}`;
  }

  /** All is well again. */
  heal(): void {
    this.faults.clear();
    this.types.clear();
    this.contents.clear();
    this.asked.clear();
    this.delay = 0;
  }

  end(): void {
    this.server.closeAllConnections();
    this.server.close();
  }

  private answer(name: string, response: ServerResponse): void {
    const fault = this.faults.get(name);
    if (fault === 'hang') return;
    if (fault === 'aborted') return void response.destroy();
    if (fault === 'missing' || !(FILES.includes(name) || this.contents.has(name)))
      return void response.writeHead(404).end('not there');
    const content = this.contents.get(name) ?? readFileSync(join(dist, name));
    const type = this.types.get(name) ?? TYPES[extname(name)] ?? 'application/octet-stream';
    response
      .writeHead(200, { 'content-type': type })
      .end(fault === 'cut' ? content.slice(0, Math.floor(content.length / 2)) : content);
  }
}
