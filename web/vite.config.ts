// How the page is built: specs of `examples/` become modules, and all addresses are relative, so that `dist` works under any path.
import { parse } from 'smol-toml';
import { defineConfig, type Plugin } from 'vite';

/** A spec file as a module: its tables, comments left out. */
const specs: Plugin = {
  name: 'coilsense-specs',
  transform: (source, id) =>
    id.endsWith('.toml') ? { code: `export default ${JSON.stringify(parse(source))};`, map: null } : null,
};

export default defineConfig({
  base: './',
  plugins: [specs],
  build: { target: 'es2022', assetsInlineLimit: 0, chunkSizeWarningLimit: 1000 },
  worker: { format: 'es' },
  server: { fs: { allow: ['..'] } },
});
