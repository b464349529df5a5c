// How the page is built: specs of `examples/` become modules, what the footer says of the project comes from Cargo.toml, and all addresses are
// relative, so that `dist` works under any path.
import { readFileSync } from 'node:fs';
import { parse } from 'smol-toml';
import { defineConfig, type Plugin } from 'vite';

/** A spec file as a module: its tables, comments left out. */
const specs: Plugin = {
  name: 'coilsense-specs',
  transform: (source, id) =>
    id.endsWith('.toml') ? { code: `export default ${JSON.stringify(parse(source))};`, map: null } : null,
};

/** A link to where the project lives, where Cargo.toml names that, and its licence. */
function project(): string {
  const { workspace } = parse(readFileSync(new URL('../Cargo.toml', import.meta.url), 'utf8')) as unknown as {
    workspace: { package: { repository?: string; license?: string; version: string } };
  };
  const { repository, license, version } = workspace.package;
  const name = `coilsense ${version}`;
  const source = repository ? `<a href="${repository}" rel="noreferrer">${name}</a>` : name;
  return license ? `${source}, ${license}` : source;
}

const footer: Plugin = {
  name: 'coilsense-footer',
  transformIndexHtml: (html) => html.replace('<!-- project -->', project),
};

export default defineConfig({
  base: './',
  plugins: [specs, footer],
  // A browser without module preloads loads the same modules when they are asked for.
  build: { target: 'es2022', assetsInlineLimit: 0, chunkSizeWarningLimit: 1000, modulePreload: { polyfill: false } },
  worker: { format: 'es' },
  server: { fs: { allow: ['..'] } },
});
