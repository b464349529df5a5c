// Elements, and numbers as people read them.

export type Child = Node | string | null | undefined | false;
type Properties = Record<string, unknown>;

/** An element with attributes (`class`, `aria-label` …), listeners (`onclick`) and children. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Properties = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value as EventListener);
    else if (typeof value === 'boolean') element.toggleAttribute(name, value);
    else if (value !== undefined && value !== null) element.setAttribute(name, String(value));
  }
  element.append(
    ...children.filter((child): child is Node | string => child !== null && child !== undefined && child !== false),
  );
  return element;
}

/** Words that the glossary explains, by the name of a term or a group there; of a group a question mark stands for them. */
export const word = (id: string, ...words: Child[]): HTMLButtonElement =>
  words.length > 0
    ? make('button', { type: 'button', class: 'term', 'data-word': id }, ...words)
    : make('button', { type: 'button', class: 'term ask', 'data-word': id, 'aria-label': `Words: ${id}` }, '?');

export function byId<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found as T;
}

/** Unfolds whatever hides an element, and scrolls to it. */
export function reveal(element: HTMLElement): void {
  for (let at = element.closest('details'); at; at = at.parentElement?.closest('details') ?? null) at.open = true;
  element.scrollIntoView({ block: 'center' });
}

/** `F_i` and `F_nom` with their letters lowered; `isExact` keeps what is not seen of them, where a text is to stay what it was to the letter. */
export function rich(text: string, isExact = false): DocumentFragment {
  const fragment = document.createDocumentFragment();
  text.split(/(?<=\bF)_([a-zA-Z]|nom)\b/).forEach((part, index) => {
    if (index % 2 && isExact) fragment.append(make('span', { hidden: true }, '_'));
    fragment.append(index % 2 ? make('sub', {}, part) : part);
  });
  return fragment;
}

/** So many significant digits, never as a power of ten within reason, with a true minus sign. */
export function digits(value: number, count = 3): string {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  const text =
    size !== 0 && (size < 1e-4 || size >= 1e7)
      ? value.toExponential(count - 1)
      : String(Number(value.toPrecision(count)));
  return text.replace('-', '−');
}

/** With so many decimals, a true minus sign, and none before a zero. */
export function fixed(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  return /^-[0.]*$/.test(text) ? text.slice(1) : text.replace('-', '−');
}

export const clamp = (value: number, least: number, most: number): number => Math.min(Math.max(value, least), most);
