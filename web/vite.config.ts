// How the page is built: specs of `examples/` become modules, what the footer says of the project comes from Cargo.toml, and all addresses are
// relative, so that `dist` works under any path.
import { readFileSync } from 'node:fs';
import { parse } from 'smol-toml';
import { defineConfig, type Plugin } from 'vite';
import { glue, lone, whole } from './whole';

/** A spec file as a module: its tables, comments left out. */
const specs: Plugin = {
  name: 'coilsense-specs',
  transform: (source, id) =>
    id.endsWith('.toml') ? { code: `export default ${JSON.stringify(parse(source))};`, map: null } : null,
};

const told = (file: string): string => readFileSync(new URL(`../${file}`, import.meta.url), 'utf8');
const { workspace } = parse(told('Cargo.toml')) as unknown as {
  workspace: { package: { repository?: string; license?: string; version: string } };
};

/** A link to where the project lives, where Cargo.toml names that, and its licence. */
function project(): string {
  const { repository, license, version } = workspace.package;
  const name = `coilsense ${version}`;
  const source = repository ? `<a href="${repository}" rel="noreferrer">${name}</a>` : name;
  return license ? `${source}, ${license}` : source;
}

const footer: Plugin = {
  name: 'coilsense-footer',
  transformIndexHtml: (html) => html.replace('<!-- project -->', project),
};

/** Where the page is published, which other sites want to be told as a whole; said by whoever builds it for there. */
const place: Plugin = {
  name: 'coilsense-place',
  transformIndexHtml: (html) => {
    const address = process.env['COILSENSE_PAGE_ADDRESS']?.replace(/\/*$/, '/');
    const tags = address
      ? [
          `<link rel="canonical" href="${address}" />`,
          `<meta property="og:url" content="${address}" />`,
          `<meta property="og:image" content="${address}shared.png" />`,
          '<meta property="og:image:alt" content="A spring between two load cells, and the forces that they tell" />',
          '<meta name="twitter:card" content="summary_large_image" />',
        ]
      : [];
    return html.replace('<!-- address -->', tags.join('\n    '));
  },
};

/** Where pages of the book are, and how they end: as it is published, where whoever builds the page says that; else its text in the repository. */
function book(): { base: string; ending: string } | null {
  const address = process.env['COILSENSE_BOOK_ADDRESS']?.replace(/\/*$/, '/');
  if (address) return { base: address, ending: '.html' };
  const { repository } = workspace.package;
  return repository ? { base: `${repository}/blob/main/book/src/`, ending: '.md' } : null;
}

/** The paper's address, by its DOI. */
function paper(): string {
  const doi = /^\s+doi: (10\..*)$/m.exec(told('CITATION.cff'))?.[1];
  if (!doi) throw new Error('CITATION.cff does not say the DOI of the paper');
  return `https://doi.org/${doi}`;
}

type Graph = { getModuleInfo(id: string): { importers: readonly string[] } | null };

/** Whether a module comes with the first load: `main` imports it, or what `main` imports. */
function isFirst(id: string, graph: Graph, seen = new Set<string>()): boolean {
  if (/\/src\/main\.ts$|rolldown\/runtime/.test(id)) return true;
  seen.add(id);
  return graph.getModuleInfo(id)?.importers.some((one) => !seen.has(one) && isFirst(one, graph, seen)) ?? false;
}

/** What is loaded once there are curves. */
const BELOW = /\/src\/(results\/(below|downloads|table|warnings)\.ts|style\/below\.css)/;

export default defineConfig({
  base: './',
  define: { BOOK: JSON.stringify(book()), PAPER: JSON.stringify(paper()) },
  plugins: [specs, footer, place, lone, whole],
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1000,
    modulePreload: false,
    // What is loaded at first is one file, and what is below the first screen another: each more is one that may be missing.
    rolldownOptions: {
      output: {
        codeSplitting: {
          groups: [
            { name: (id, graph) => (isFirst(id, graph) ? 'page' : null), priority: 1 },
            { name: 'below', test: BELOW },
          ],
        },
      },
    },
  },
  worker: { format: 'es', plugins: glue },
  server: { fs: { allow: ['..'] } },
});
