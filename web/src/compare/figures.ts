// What two states give, side by side: where the coil rings, its damping, how far F_o and each sensor are off, the verdict. A number that is not
// known yet is none: it is pending.
//
// Next door: the table that shows it (`card`), what of the inputs differs (`inputs`).

import type { Deviation, ExactFacts } from '../answer';
import { digits, fixed } from '../dom';
import { called } from '../plots/looks';
import { isBeyond, ring, type Case } from './case';

/** A figure of a state: a number that the other one is compared with, what stands for it, and whether it meets the goal. */
export interface Cell {
  text: string;
  value?: number;
  meets?: boolean | null;
}

/** Pending where a cell is null. */
export interface Figure {
  label: string;
  kept: Cell | null;
  now: Cell | null;
}

/** A figure of the case, null while that is not exact; `same` leaves it out where both are the same. */
interface Asked {
  label: string;
  of: (facts: ExactFacts) => Cell;
  same?: boolean;
}

/** The force at end 2, or that at end 1 where the former counts as the true one. */
const judgedForce = ({ truth }: ExactFacts): string => (truth === 'F_o' ? 'F_i' : 'F_o');

function off(facts: ExactFacts, deviation: Deviation | undefined, key: 'rmsd' | 'maximumAbsolute'): Cell {
  if (!deviation) return { text: '–' };
  const percent = (100 * deviation[key]) / facts.spring.nominalForce;
  return { text: `${fixed(percent, 3)}\u00a0% · ${digits(deviation[key])}\u00a0N`, value: percent };
}

/** What windings do in the case. */
function windings(facts: ExactFacts): string {
  const { contact, clash } = facts;
  if (isBeyond(facts))
    return `would touch from ${fixed(1e3 * (clash.firstContact ?? 0), 1)} ms on: no real coil does this`;
  if (!contact) return 'do not touch';
  return contact.first === null ? `do not meet (${contact.law})` : `meet ${contact.touches} times (${contact.law})`;
}

const span = (facts: ExactFacts): string => {
  const [from, to] = facts.conditions[facts.condition]?.window ?? [0, 0];
  return `${digits(from)} to ${digits(to)} s`;
};

const ASKED: readonly Asked[] = [
  { label: 'Surge frequency f1', of: (facts) => ({ text: `${digits(ring(facts), 4)}\u00a0Hz`, value: ring(facts) }) },
  { label: 'Damping shown', of: ({ dampings, damping }) => ({ text: dampings[damping]?.label ?? '–' }) },
  { label: 'F_nom', of: ({ spring }) => newtons(spring.nominalForce), same: true },
  { label: 'Judged from, to', of: (facts) => ({ text: span(facts) }), same: true },
  { label: 'Force taken as true', of: ({ truth }) => ({ text: called(truth) }), same: true },
  { label: 'Windings', of: (facts) => ({ text: windings(facts) }), same: true },
];
const newtons = (force: number): Cell => ({ text: `${digits(force, 4)}\u00a0N`, value: force });

function ends(kept: ExactFacts | null, now: ExactFacts | null): Asked[] {
  const names = [...new Set([kept, now].flatMap((facts) => (facts ? [judgedForce(facts)] : [])))];
  return names.flatMap((name): Asked[] => [
    { label: `${called(name)}, rms off`, of: (facts) => off(facts, facts.forces[name], 'rmsd') },
    { label: `${called(name)}, most off`, of: (facts) => off(facts, facts.forces[name], 'maximumAbsolute') },
  ]);
}

/** Every sensor that one of both has, by its name. */
function sensors(kept: Case, now: Case): Figure[] {
  const names = [kept, now].flatMap(({ exact }) => exact?.facts.sensors.map(({ name }) => name) ?? []);
  const cell = ({ exact, judged }: Case, name: string): Cell | null => {
    if (!exact) return null;
    const found = exact.facts.sensors.find((one) => one.name === name);
    if (!found) return { text: 'not there' };
    const ranked = judged && 'outcome' in judged ? judged.outcome.ranking.find((one) => one.sensor === name) : null;
    return { ...off(exact.facts, found.deviation, 'rmsd'), ...(ranked ? { meets: ranked.meets_goal } : {}) };
  };
  return [...new Set(names)].map((name) => ({
    label: `${name}, rms off`,
    kept: cell(kept, name),
    now: cell(now, name),
  }));
}

/** What to do, as far as the first pause. */
function verdict({ judged, failed }: Case): Cell | null {
  if (failed) return { text: '–' };
  if (!judged) return null;
  if ('reason' in judged) return { text: `not judged${judged.reason && `: ${judged.reason}`}` };
  const [first = ''] = judged.outcome.answer;
  return { text: /^.*?(?=[;,(]|\.\s|$)/.exec(first)?.[0] ?? first };
}

export function figures(kept: Case, now: Case): Figure[] {
  const facts = ({ exact }: Case) => exact?.facts ?? null;
  const cell = (one: Case, of: Asked['of']): Cell | null => {
    if (one.failed) return { text: '–' };
    return one.exact ? of(one.exact.facts) : null;
  };
  const rows = [...ASKED, ...ends(facts(kept), facts(now))].flatMap(({ label, of, same }): Figure[] => {
    const row = { label, kept: cell(kept, of), now: cell(now, of) };
    return same && (!row.kept || !row.now || row.kept.text === row.now.text) ? [] : [row];
  });
  const all: Figure[] = [...rows, ...sensors(kept, now)];
  return [...all, { label: 'Verdict', kept: verdict(kept), now: verdict(now) }];
}

/** How the second number differs from the first; nothing where it cannot be said. */
export function change(kept: Cell | null, now: Cell | null): string {
  const [one, other] = [kept?.value, now?.value];
  if (one === undefined || other === undefined || !(Math.abs(one) > 0)) return '';
  const part = other / one - 1;
  if (Math.abs(part) < 5e-5) return '=';
  if (part > 1) return `× ${digits(other / one)}`;
  return `${part > 0 ? '+' : ''}${digits(100 * part, 2)}\u00a0%`;
}
