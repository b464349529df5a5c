// What windings did that were asked to meet: from when, how often, how hard, for how much of the time, and until when that holds.
//
// Next door: when it is loaded (`results/meetings`), what is counted (`coilsense-web`, `contact`).

import type { ContactFacts, ExactFacts } from '../answer';
import { digits, fixed, make } from '../dom';

export class Card {
  private readonly body = make('tbody');
  private readonly words = make('p', { class: 'facts' });
  private readonly holds = make('p', { class: 'facts' });
  private readonly table: HTMLElement;

  constructor(host: HTMLElement) {
    const heads = ['Between', 'Times', 'At up to', 'Closed'].map((text) => make('th', { scope: 'col' }, text));
    const caption = make(
      'caption',
      {},
      'How often each pair met, its largest closing speed, and its share of the time.',
    );
    this.table = make('table', {}, caption, make('thead', {}, make('tr', {}, ...heads)), this.body);
    host.replaceChildren(
      make('div', { class: 'head' }, make('h2', {}, 'Windings that meet')),
      this.words,
      make('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Which windings met' }, this.table),
      this.holds,
    );
  }

  show(exact: ExactFacts | null): void {
    this.body.classList.toggle('stale', exact === null);
    if (!exact?.contact) return;
    const { contact } = exact;
    this.words.textContent = said(contact);
    this.holds.textContent = held(contact);
    this.table.hidden = contact.pairs.length === 0;
    const row = ({ between, touches, speed, closed }: ContactFacts['pairs'][number]) =>
      make(
        'tr',
        {},
        make('th', { scope: 'row' }, between),
        make('td', {}, String(touches)),
        make('td', {}, `${digits(speed)} m/s`),
        make('td', {}, share(closed)),
      );
    this.body.replaceChildren(...contact.pairs.map(row));
  }
}

/** Less than a hundredth of a percent is as good as none. */
const share = (part: number): string => (part < 1e-4 ? '< 0.01 %' : `${digits(100 * part)} %`);

function said({ law, first, between, speed, touches, lifts, aloft, lost, ends }: ContactFacts): string {
  const met =
    first === null
      ? `With ${law} no windings meet.`
      : `With ${law} windings meet from ${fixed(1e3 * first, 3)} ms on, first ${between} at ${digits(speed ?? 0)} m/s, ${touches} times in all; ${digits(1e3 * lost)} mJ are lost.`;
  const left = lifts > 0 ? ` Ends leave their seats ${lifts} times, for ${digits(1e3 * aloft)} ms in all.` : '';
  return met + left + (ends ? '' : ' Windings do not meet the seats.');
}

function held({ holdsUntil, until, apart, isAssumed, first }: ContactFacts): string {
  if (first === null || holdsUntil === null) return '';
  const moves = `An input larger by a millionth moves no end force by more than ${digits(apart)} N`;
  const holds =
    holdsUntil < until
      ? `${moves} until ${fixed(1e3 * holdsUntil, 1)} ms; what comes after that is good in its rms and its extremes only.`
      : `${moves}: the answer holds to the end.`;
  const band = ' No measured loss of windings that meet is known: compare both cases beside the damping.';
  return holds + (isAssumed ? band : '');
}
