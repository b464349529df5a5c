// The places of the tab *Spring*: what stands where.
//
// Next door: what fills them (`spring`).

import { make, word } from '../dom';

export function layOut(panel: HTMLElement) {
  const canvas = make('canvas', { class: 'coil', role: 'img' });
  const parts = {
    canvas,
    choose: make('section', { class: 'choose', 'aria-label': 'Which spring, and what happens to it' }),
    first: make('div', { class: 'first' }),
    refusal: make('p', { class: 'refusal', role: 'status', hidden: true }),
    fields: make('section', { class: 'fields', 'aria-label': 'Values' }),
    spring: make('div', { class: 'card see' }),
    wave: make('section', { class: 'card wave', 'aria-label': 'The wave over position and time' }),
    status: make('span', { class: 'status' }, '…'),
    views: make('div', { class: 'views' }),
    forces: make('div', {
      class: 'plot forces',
      tabindex: 0,
      role: 'group',
      'aria-label': 'Forces over time; arrows move the mark, + and - zoom',
    }),
    spectrum: make('div', {
      class: 'plot spectrum',
      role: 'img',
      'aria-label': 'Amplitude of each force over frequency, surge lines marked',
    }),
    lines: make('p', { class: 'facts' }, 'How far each force swings. f1, f2 …: where the coil rings by itself.'),
    keys: make('p', { class: 'keys' }),
    why: make('section', { class: 'card why', 'aria-label': 'Why the ends disagree' }),
    verdict: make('section', { class: 'card trust', 'aria-label': 'Which sensor to trust' }),
    said: make('p', { class: 'visually-hidden', role: 'status' }),
    off: make('section', { class: 'card off' }),
    table: make('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'How far each force is off' }),
    meetings: make('section', { class: 'card meetings', 'aria-label': 'How windings met', hidden: true }),
    warnings: make('ul', { class: 'warnings' }),
    facts: make('p', { class: 'facts' }),
    response: make('section', { class: 'card two-ends', 'aria-label': 'The two ends over frequency' }),
    speeds: make('section', { class: 'card speeds-of', 'aria-label': 'Over the speed of the recording', hidden: true }),
    modes: make('section', { class: 'card every', 'aria-label': 'Every mode of the coil' }),
    downloads: make('div', { class: 'downloads' }),
  };
  parts.off.append(make('div', { class: 'head' }, make('h2', {}, 'How far off'), word('off')), parts.table);
  panel.classList.add('workbench');
  panel.replaceChildren(
    parts.choose,
    make(
      'div',
      { class: 'stage' },
      parts.spring,
      make(
        'section',
        { class: 'card', 'aria-label': 'Forces over time' },
        make('div', { class: 'head' }, make('h2', {}, 'Forces over time'), word('forces'), parts.status, parts.views),
        parts.keys,
        parts.forces,
        parts.said,
      ),
      parts.why,
      parts.wave,
    ),
    make('div', { class: 'controls' }, parts.refusal, parts.fields),
    parts.verdict,
    make(
      'div',
      { class: 'results' },
      parts.off,
      parts.meetings,
      make(
        'section',
        { class: 'card' },
        make('div', { class: 'head' }, make('h2', {}, 'At which frequencies'), word('ringing')),
        parts.spectrum,
        parts.lines,
      ),
      make(
        'section',
        { class: 'card rely', tabindex: -1 },
        make('div', { class: 'head' }, make('h2', {}, 'Before you rely on it')),
        parts.warnings,
        parts.facts,
      ),
      parts.speeds,
      parts.response,
      parts.modes,
      make(
        'section',
        { class: 'card get' },
        make('div', { class: 'head' }, make('h2', {}, 'Download')),
        parts.downloads,
      ),
    ),
  );
  return parts;
}
