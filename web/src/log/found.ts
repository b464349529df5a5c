// What a log says: the answer, the spring with its intervals, what speaks for it, what to record next; and the spring to take along.
//
// Next door: what is asked (`form`), numbers (`tables`), curves (`pictures`), who asks (`tabs/log`).

import type { Answer } from '../answer';
import { make, rich, word } from '../dom';
import { download } from '../download';
import type { Identification, Said } from './identification';
import { draw } from './pictures';
import { lines, numbers } from './tables';

export const list = (items: string[]) =>
  make('ul', { class: 'plainlist' }, ...items.map((text) => make('li', {}, rich(text))));
export const card = (title: string, ...children: Node[]) =>
  make(
    'section',
    { class: 'card', 'aria-label': title },
    make('div', { class: 'head' }, make('h2', {}, title), word('cleaned')),
    ...children,
  );
export const button = (label: string, act: () => void) =>
  make('button', { type: 'button', class: 'plain', onclick: act }, label);

/** What the user may do with what was found. */
export interface Ways {
  openSpec(text: string): void;
}

/** `head` gets the answer and the spring, `host` what is behind them. */
export function showFound(head: HTMLElement, host: HTMLElement, name: string, answer: Answer<Said>, ways: Ways): void {
  const { facts } = answer;
  const found = JSON.parse(facts.json) as Identification;
  const figures = make('div', { class: 'figures' });
  const save = () => download(`${name}-identification.json`, facts.json, 'application/json');
  head.replaceChildren(
    make(
      'section',
      { class: 'card verdict', 'aria-label': 'Verdict' },
      ...found.answer.map((line, index) => make(index === 0 ? 'h2' : 'p', {}, rich(line))),
    ),
    card('The spring', numbers(found), along(name, facts, ways)),
  );
  host.replaceChildren(
    card('What speaks for it', list(found.evidence)),
    ...(found.record_next.length > 0 ? [card('What to record next', list(found.record_next))] : []),
    figures,
    card('Lines', lines(found)),
    card('What became of the rows', list(found.account)),
    make('div', { class: 'downloads' }, button('Everything (JSON)', save)),
  );
  draw(figures, found, answer);
}

/** The spring as a spec, or why there is none. */
function along(name: string, { spec, noSpecBecause }: Said, ways: Ways): HTMLElement {
  if (spec === null) return make('p', { class: 'hint' }, `No spec of it yet: ${noSpecBecause ?? ''}.`);
  const save = () => download(`${name.replace(/\.[^.]*$/, '')}-identified.toml`, spec, 'application/toml');
  return make(
    'div',
    { class: 'downloads' },
    button('Open this spring in the tab Spring', () => ways.openSpec(spec)),
    button('Download the spec (TOML)', save),
  );
}
