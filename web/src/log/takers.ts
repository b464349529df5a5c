// Which tabs take logs, and logs that wait for the tab to be opened.
//
// Next door: who brings them (`dropped`), places of their own for logs (`drop`).

type Take = (files: File[]) => void;

const takers = new Map<string, Take>();
let waiting: File[] = [];

/** A tab that takes logs, from when it is opened. */
export function takeLogs(tab: string, take: Take): void {
  takers.set(tab, take);
  if (tab === 'log' && waiting.length > 0) take(waiting.splice(0));
}

/** More of a TOML file is not looked at: none is that long. */
const LONGEST = 1 << 20;

/** The text of a small file; empty of a folder, which has none. */
export const textOf = (file: File): Promise<string> =>
  file
    .slice(0, LONGEST)
    .text()
    .catch(() => '');

/** A spec among the files, which a mapping of columns is none. */
export async function specOf(files: readonly File[]): Promise<File | null> {
  for (const file of files) if (/\.toml$/i.test(file.name) && /^\s*\[spring\]/m.test(await textOf(file))) return file;
  return null;
}

/** Gives logs to a tab, now or when it is opened. */
export function give(tab: string, files: File[]): void {
  const log = takers.get(tab);
  if (log) log(files);
  else waiting = files;
}

/** Whether a tab is open that takes logs. */
export const takes = (tab: string): boolean => takers.has(tab);
