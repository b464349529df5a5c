// A part of the page loaded once more after it failed: a browser keeps for good what came cut short.
//
// Next door: who asks for that (`faults`).

/** The address holds the state after so long [ms]; see `store`. */
const WRITTEN = 400;

/** The part once more; the address of the page holds the state where it must be opened anew for that. */
export async function anew<T>(load: () => Promise<T>): Promise<T> {
  try {
    return await load();
  } catch (reason) {
    // A browser keeps what came cut short; under another address it is loaded anew.
    const name = /[\w.-]+\.js/.exec(String(load))?.[0] ?? '';
    const file = new URL(name, import.meta.url).href;
    try {
      return (await import(/* @vite-ignore */ `${file}?${Date.now()}`)) as T;
    } catch {
      if (!(await isWhole(file))) throw reason;
      setTimeout(() => location.reload(), WRITTEN);
      return new Promise(() => {});
    }
  }
}

/** Whether a script has come whole, with all that it imports: then only a page that is opened anew gets it. So it is where its build has gone. */
async function isWhole(file: string, seen = new Set<string>()): Promise<boolean> {
  if (seen.has(file)) return true;
  seen.add(file);
  const load = (address: string) => fetch(address, { cache: 'reload' });
  const reply = await load(file);
  if (!reply.ok) {
    const page = await load(location.pathname);
    const own = document.querySelector<HTMLScriptElement>('script[type=module]')?.src.replace(/.*\//, '') ?? '';
    return page.ok && !(await page.text()).includes(own);
  }
  const text = await reply.text();
  if (!/export\s*\{[^{}]*\};?\s*$/.test(text)) return false;
  const imported = [...text.matchAll(/(?:from|import)\s*["'`](\.\/[\w.-]+\.js)/g)];
  const each = await Promise.all(imported.map(([, name = '']) => isWhole(new URL(name, file).href, seen)));
  return each.every(Boolean);
}
