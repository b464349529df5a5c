// What a word of the glossary is, and the places in the book that several are told at.
//
// Next door: the words (`of-forces`, `of-springs`), their order (`terms`).

export interface Term {
  /** As the page's marks name it. */
  id: string;
  /** As the page writes it, each of them somewhere. */
  names: readonly string[];
  words: string;
  /** Its unit on the page; empty where it has none. */
  unit?: string;
  /** A page of the book and a heading on it, by its address: `start.md#words`. */
  book: string;
  /** Where the paper has it. */
  paper?: string;
}

export interface Group {
  id: string;
  heading: string;
  terms: readonly Term[];
}

export const WORDS = 'start.md#words';
export const COMPARED = 'guide/analyze.md#what-is-compared';
export const CHAIN = 'theory.md#1-the-chain-in-closed-form';
export const OPEN = 'theory.md#4-what-the-paper-leaves-open';
export const SPEC = {
  spring: 'guide/spec.md#spring',
  mount: 'guide/spec.md#mount',
  contact: 'guide/spec.md#contact',
  condition: 'guide/spec.md#condition',
  sensor: 'guide/spec.md#sensor',
  goal: 'guide/spec.md#goal',
};
