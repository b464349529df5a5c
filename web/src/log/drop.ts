// A place where a file is dropped or chosen.
//
// Next door: what becomes of it (`tabs/log`).

import { make, rich } from '../dom';

/** What was dropped; of a folder an empty file with its name and a stroke, which is refused as one. */
function filesOf(data: DataTransfer | null): File[] {
  const folders = [...(data?.items ?? [])].map((item) => item.webkitGetAsEntry?.()?.isDirectory ?? false);
  return [...(data?.files ?? [])].map((file, index) => (folders[index] ? new File([], `${file.name}/`) : file));
}

const ACCEPTED = '.csv,.tsv,.txt,.dat,.log,.toml,text/*';

/** `hint` says what is wanted; `taken` gets the files. Dropping works anywhere on `area`, which is the place itself where none is given. */
export function dropPlace(
  id: string,
  [bold, rest]: [string, string],
  hint: string,
  taken: (files: File[]) => void,
  area?: HTMLElement,
): HTMLElement {
  const choose = make('input', { type: 'file', id, accept: ACCEPTED, multiple: true });
  const place = make(
    'div',
    { class: 'drop' },
    make('label', { for: id }, make('b', {}, bold), rest),
    choose,
    make('p', { class: 'hint' }, rich(hint)),
  );
  choose.addEventListener('change', () => {
    taken([...(choose.files ?? [])]);
    // The same file may be chosen again.
    choose.value = '';
  });
  const over = (event: DragEvent, on: boolean) => {
    event.preventDefault();
    event.stopPropagation();
    place.classList.toggle('over', on);
  };
  const where = area ?? place;
  where.addEventListener('dragover', (event) => over(event, true));
  where.addEventListener('dragleave', (event) => over(event, false));
  where.addEventListener('drop', (event) => {
    over(event, false);
    taken(filesOf(event.dataTransfer));
  });
  return place;
}
