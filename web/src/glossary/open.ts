// The glossary: a dialog of all words with their links, opened at the word or the group that was asked for.
//
// Next door: the words (`terms`), what asks for them (`word` of `dom`, heard by `main`).

import { make, rich } from '../dom';
import css from '../style/glossary.css?inline';
import { wear } from '../style/wear';
import type { Group, Term } from './term';
import { GLOSSARY } from './terms';

let dialog: HTMLDialogElement | null = null;

const id = (of: string): string => `word-${of}`;

/** Opens it at a term or a group by its id; at its beginning where that is none. */
export function open(asked: string): void {
  wear(css);
  dialog ??= build();
  for (const marked of dialog.querySelectorAll('.asked-for')) marked.classList.remove('asked-for');
  filter(dialog, '');
  if (!dialog.open) dialog.showModal();
  const found = dialog.querySelector<HTMLElement>(`#${CSS.escape(id(asked))}`);
  if (!found) return void dialog.querySelector<HTMLElement>('input')?.focus();
  found.classList.add('asked-for');
  found.scrollIntoView({ block: 'start' });
  found.focus({ preventScroll: true });
}

function build(): HTMLDialogElement {
  const close = () => made.close();
  const search = make('input', {
    type: 'text',
    'aria-label': 'Find a word',
    placeholder: 'Find a word',
    autocomplete: 'off',
    oninput: () => filter(made, search.value),
  });
  const none = make('p', { class: 'none', role: 'status' });
  const made: HTMLDialogElement = make(
    'dialog',
    { class: 'glossary', 'aria-labelledby': 'glossary-heading' },
    make(
      'div',
      { class: 'top' },
      make('h2', { id: 'glossary-heading' }, 'Glossary'),
      search,
      make('button', { type: 'button', class: 'plain', onclick: close }, 'Close'),
    ),
    make('div', { class: 'all', tabindex: 0, role: 'region', 'aria-label': 'All words' }, ...GLOSSARY.map(group), none),
  );
  // Beside it is out of it.
  made.addEventListener('click', (event) => event.target === made && close());
  document.body.append(made);
  return made;
}

const group = ({ id: of, heading, terms }: Group): HTMLElement =>
  make('section', {}, make('h3', { id: id(of), tabindex: -1 }, heading), make('dl', {}, ...terms.flatMap(entry)));

function entry({ id: of, names, words, unit, book, paper }: Term): HTMLElement[] {
  const title = names.flatMap((name, number) => [number > 0 ? ', ' : '', rich(name)]);
  const links = [BOOK && link(bookAddress(book), 'Book'), paper && link(PAPER, `Paper, ${paper}`)];
  return [
    make('dt', { id: id(of), tabindex: -1 }, ...title, unit && make('small', {}, ' [', rich(unit), ']')),
    make('dd', {}, rich(words), ...links.flatMap((one) => (one ? [' ', one] : []))),
  ];
}

const link = (href: string, text: string): HTMLElement =>
  make('a', { href, target: '_blank', rel: 'noopener noreferrer' }, text);

/** Where a page of the book and a heading on it are. */
function bookAddress(place: string): string {
  const [page = '', heading = ''] = place.split('#');
  return `${BOOK?.base}${page.replace(/\.md$/, BOOK?.ending ?? '')}#${heading}`;
}

/** Shows the words in which a text occurs. */
function filter(made: HTMLElement, text: string): void {
  const wanted = plain(text);
  let any = false;
  for (const section of made.querySelectorAll('section')) {
    let some = false;
    for (const term of section.querySelectorAll('dt')) {
      const words = term.nextElementSibling as HTMLElement;
      const fits = plain(`${term.textContent} ${words.textContent}`).includes(wanted);
      term.hidden = words.hidden = !fits;
      some ||= fits;
    }
    section.hidden = !some;
    any ||= some;
  }
  const none = made.querySelector('.none');
  if (none) none.textContent = any ? '' : `No word of this page has “${text.trim()}”.`;
  const search = made.querySelector('input');
  if (search && search.value !== text) search.value = text;
}

/** Without capitals, and F_o as it looks, too. */
const plain = (text: string): string => text.trim().toLowerCase().replaceAll('_', '');
