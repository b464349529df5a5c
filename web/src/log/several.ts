// Several logs that were dropped at once: two of one run by two devices, or some of which one is shown.
//
// Next door: who takes them (`tabs/log`).

import { make } from '../dom';

/** Which device wrote a log of the rig: its name says so. */
const DEVICE = /[-_](fast|slow)\.[a-z]+$/i;
/** What the rig writes above the rows: the run, and when it began. */
const BEGUN = /^(\S+, begun \S+ s after the first run)\b/;

/** Logs of two devices in their order: the fast one's first. */
export function inOrder(logs: readonly File[]): File[] {
  const isSlow = ({ name }: File) => DEVICE.exec(name)?.[1]?.toLowerCase() === 'slow';
  return [...logs].sort((a, b) => Number(isSlow(a)) - Number(isSlow(b)));
}

/** Whether two devices' logs say that they began at the same moment of one run: then their clocks are one. */
export function beganTogether(first: readonly string[], second: readonly string[]): boolean {
  const begun = (remarks: readonly string[]) => remarks.map((remark) => BEGUN.exec(remark.trim())?.[1]).find(Boolean);
  const moment = begun(first);
  return moment !== undefined && moment === begun(second);
}

/** Buttons for logs of which one is shown; nothing for a single one. */
export function choose(logs: readonly File[], shown: File, show: (file: File) => void): HTMLElement[] {
  if (logs.length < 2) return [];
  const buttons = logs.map((file) =>
    make(
      'button',
      { type: 'button', class: 'plain', 'aria-pressed': String(file === shown), onclick: () => show(file) },
      file.name,
    ),
  );
  return [make('span', { class: 'hint' }, 'Shown one at a time:'), ...buttons];
}
