// Fingers on a plot over time: two zoom and shift it, what was below each staying there; a double tap shows all that was shown at first. One
// finger is left to the page, which scrolls by it. Loaded on screens that can be touched.
//
// Next door: which times are shown (`timeline`).

import type { Times } from './timeline';

export interface Touched {
  /** The shown times [s]. */
  times(): Times;
  choose(from: number, to: number): void;
  reset(): void;
}

/** Fingers that are closer than this do not zoom any more [CSS pixels]. */
const CLOSEST = 24;
/** A tap moves by no more than this [CSS pixels], and two taps are one gesture within this time [ms]. */
const TAP = 24;
const TWICE = 350;

export function follow(over: HTMLElement, touched: Touched): void {
  /** Two fingers as they came down: numbers of both, their middle as a time [s], and how many seconds a pixel was for each pixel between them. */
  let held: { fingers: number[]; middle: number; spread: number } | null = null;
  let began = { x: 0, y: 0 };
  let tap = { x: 0, y: 0, at: -Infinity };

  /** The middle of two fingers as a part of the plot's width, and how far they are apart across [CSS pixels]. */
  const between = (one: Touch, two: Touch) => {
    const { left, width } = over.getBoundingClientRect();
    const apart = Math.max(CLOSEST, Math.abs(one.clientX - two.clientX));
    return { middle: ((one.clientX + two.clientX) / 2 - left) / width, apart };
  };

  const begin = (event: TouchEvent) => {
    const [one, two] = event.touches;
    if (one) began = { x: one.clientX, y: one.clientY };
    held = null;
    // Where the page scrolls already, it goes on.
    if (event.touches.length !== 2 || !one || !two || !event.cancelable) return;
    event.preventDefault();
    const [from, to] = touched.times();
    const { middle, apart } = between(one, two);
    const fingers = [one.identifier, two.identifier];
    held = { fingers, middle: from + middle * (to - from), spread: (to - from) * apart };
  };

  const move = (event: TouchEvent) => {
    const [one, two] = [...event.touches].filter(({ identifier }) => held?.fingers.includes(identifier));
    if (!held || !one || !two) return;
    event.preventDefault();
    const { middle, apart } = between(one, two);
    const width = held.spread / apart;
    const from = held.middle - middle * width;
    touched.choose(from, from + width);
  };

  const end = (event: TouchEvent) => {
    const wasHeld = held !== null;
    if (event.touches.length === 0) held = null;
    const [finger] = event.changedTouches;
    if (wasHeld || event.touches.length > 0 || !finger) return;
    const near = (to: { x: number; y: number }) => Math.hypot(finger.clientX - to.x, finger.clientY - to.y) < TAP;
    const isTap = near(began);
    if (isTap && near(tap) && event.timeStamp - tap.at < TWICE) {
      if (event.cancelable) event.preventDefault();
      tap.at = -Infinity;
      touched.reset();
    } else tap = { x: finger.clientX, y: finger.clientY, at: isTap ? event.timeStamp : -Infinity };
  };

  over.style.touchAction = 'pan-x pan-y';
  over.addEventListener('touchstart', begin, { passive: false });
  over.addEventListener('touchmove', move, { passive: false });
  over.addEventListener('touchend', end, { passive: false });
  over.addEventListener('touchcancel', () => (held = null));
}
