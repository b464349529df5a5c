// How the interactive part of reports is built: the page's own modules as one script and one style sheet, which the crate that writes reports holds.
// `cargo xtask viewer` runs it.
import { readFileSync } from 'node:fs';
import { defineConfig, type Plugin } from 'vite';

const HEAD = 'Generated from web/src/report by `cargo xtask viewer`; not to be edited.';

/** Says what a file is, and the licence of what is in it that is not ours, which must go along with it. */
const head: Plugin = {
  name: 'coilsense-head',
  enforce: 'post',
  generateBundle: (_, files) => {
    const uplot = new URL('node_modules/uplot/', import.meta.url);
    const { version } = JSON.parse(readFileSync(new URL('package.json', uplot), 'utf8')) as { version: string };
    const licence = readFileSync(new URL('LICENSE', uplot), 'utf8').trim();
    const words = `/* ${HEAD}\n\nIn it is uPlot ${version}, https://github.com/leeoniya/uPlot:\n\n${licence}\n*/\n`;
    for (const file of Object.values(files)) {
      if (file.type === 'chunk') file.code = words + file.code;
      else file.source = `/* ${HEAD} */\n${String(file.source)}`;
    }
  },
};

export default defineConfig({
  plugins: [head],
  publicDir: false,
  build: {
    target: 'es2022',
    outDir: '../crates/coilsense-lab/src/report/viewer',
    emptyOutDir: false,
    lib: {
      entry: 'src/report/main.ts',
      formats: ['iife'],
      name: 'coilsenseReport',
      fileName: () => 'viewer.js',
      cssFileName: 'viewer',
    },
  },
});
