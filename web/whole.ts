// What the build adds so that the page can tell a missing or cut file, and works offline: the guard, a mark at the end of the style sheet, lengths of
// recorded motions, the service worker with the hash of every file.
//
// Next door: the guard and the worker themselves (`src/guard`, `src/sw`), the rest of the build (`vite.config`).

import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { minifySync, transformWithOxc, type Plugin, type Rolldown } from 'vite';

const here = (file: string): URL => new URL(file, import.meta.url);
const hash = (content: string | Uint8Array): string => createHash('sha256').update(content).digest('hex');
const contentOf = (file: Rolldown.OutputAsset | Rolldown.OutputChunk): string | Uint8Array =>
  file.type === 'chunk' ? file.code : file.source;

/** A script that is no module, with what it is told of the build before it. */
async function script(file: string, told = ''): Promise<string> {
  const { code } = await transformWithOxc(readFileSync(here(file), 'utf8'), file, { target: 'es2020' });
  return minifySync(file, told + code.replace(/export\s*\{\s*\};?/, '')).code;
}

/** Styles of uPlot for its own title and legend, which the page does not show. */
const UNUSED = /\.u-(title|legend|inline|series)[^{}]*\{[^}]*\}/g;

const motion = (file: string): number => statSync(here(`../examples/${file}`)).size;

/**
 * Parts that are loaded later bring their styles along as text (`?inline`): a style sheet beside them would be one more file to be missing, and Vite
 * never asks for it again. What it adds for such sheets to every load is left out.
 */
export const lone: Plugin = {
  name: 'coilsense-lone',
  enforce: 'pre',
  load: (id) => (id === '\0vite/preload-helper.js' ? 'export const __vitePreload = (load) => load();' : null),
};

/** Every browser that runs workers of modules has what wasm-bindgen's glue makes up for, and nobody disposes by `using`. */
export const glue = (): Plugin[] => [
  {
    name: 'coilsense-glue',
    transform: (code, id) =>
      id.endsWith('/coilsense_web.js')
        ? code
            .replace(/^if \(!\('encodeInto'[\s\S]*?^\}/m, '')
            .replace(/^if \(Symbol\.dispose\).*$/gm, '')
            .replace(/\(typeof FinalizationRegistry === 'undefined'\)[\s\S]*?: new/g, 'new')
        : null,
  },
];

export const whole: Plugin = {
  name: 'coilsense-whole',
  enforce: 'post',
  config: () => ({
    define: { LENGTHS: JSON.stringify({ cam: motion('cam-6000rpm.csv'), road: motion('road-c-20mps.csv') }) },
  }),
  generateBundle: {
    order: 'post',
    async handler(_, bundle) {
      const files = Object.values(bundle);
      const page = bundle['index.html'];
      if (page?.type !== 'asset') return;
      const late = files.filter(({ fileName }) => /css$/.test(fileName) && !String(page.source).includes(fileName));
      if (late[0]) this.error(`${late[0].fileName}: import it as text, '….css?inline', and put that into a <style>`);
      for (const file of files)
        if (file.type === 'chunk')
          // What `lone` leaves of Vite's loading: an import.
          file.code = file.code.replace(/\w+\(\(\)=>(import\(`[^`]+`\)),\[\],import\.meta\.url\)/g, '$1');
        else if (file.fileName.endsWith('.css'))
          file.source = `${String(file.source).trimEnd().replace(UNUSED, '')}:root{--whole:1}`;
      const guard = await script('src/guard.ts');
      const name = `assets/guard-${hash(guard).slice(0, 8)}.js`;
      this.emitFile({ type: 'asset', fileName: name, source: guard });
      page.source = String(page.source).replace('<script', `<script async src="./${name}"></script>\n    <script`);
      const all: Record<string, string> = { '': hash(page.source), [name]: hash(guard) };
      for (const file of files) if (file !== page) all[file.fileName] = hash(contentOf(file));
      for (const file of readdirSync(here('public'))) all[file] = hash(readFileSync(here(`public/${file}`)));
      const build = hash(JSON.stringify(all)).slice(0, 16);
      const told = `const BUILD = ${JSON.stringify(build)}, FILES = ${JSON.stringify(all)};\n`;
      this.emitFile({ type: 'asset', fileName: 'sw.js', source: await script('src/sw.ts', told) });
    },
  },
};
