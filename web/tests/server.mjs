// A static host as dumb as any: files of `dist` under a path of its own, compressed where that is asked for. `node tests/server.mjs PORT`
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize } from 'node:path';
import { gzipSync } from 'node:zlib';

const PATH = '/some/where/';
const TYPES = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
  '.csv': 'text/csv',
};
const folder = new URL('../dist/', import.meta.url).pathname;
const compressed = new Map();

createServer(async (request, response) => {
  const { pathname } = new URL(request.url ?? '/', 'http://localhost');
  if (!pathname.startsWith(PATH)) return response.writeHead(404).end('not here');
  const name = normalize(pathname.slice(PATH.length) || 'index.html');
  try {
    if (name.startsWith('..')) throw new Error('outside');
    const content = compressed.get(name) ?? gzipSync(await readFile(join(folder, name)), { level: 9 });
    compressed.set(name, content);
    response
      .writeHead(200, {
        'content-type': TYPES[extname(name)] ?? 'application/octet-stream',
        'content-encoding': 'gzip',
      })
      .end(content);
  } catch {
    response.writeHead(404).end('not there');
  }
}).listen(Number(process.argv[2]), '127.0.0.1');
