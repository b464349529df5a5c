// The words of the page that a newcomer does not know: each in a sentence or two, with its unit and where book and paper tell of it.
//
// Next door: the words themselves (`of-forces`, `of-springs`), how they are shown (`open`). That each is used on the page, and each place is there in
// the book, is tested (`tests/glossary.spec`).

import { CLEANED, FORCES, OFF, SENSORS } from './of-forces';
import { DONE, MODES, RINGING, SPRING } from './of-springs';
import type { Group } from './term';

export const GLOSSARY: readonly Group[] = [
  { id: 'forces', heading: 'Forces', terms: FORCES },
  { id: 'ringing', heading: 'Ringing', terms: RINGING },
  { id: 'off', heading: 'How far off', terms: OFF },
  { id: 'sensors', heading: 'Which sensor to trust', terms: SENSORS },
  { id: 'done', heading: 'What is done to the spring', terms: DONE },
  { id: 'spring', heading: 'The spring', terms: SPRING },
  { id: 'modes', heading: 'Every mode of the coil', terms: MODES },
  { id: 'cleaned', heading: 'Logs and filters', terms: CLEANED },
];
