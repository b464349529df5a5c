// The spectra with their lines, the strongest hit beside its fit, force over length.
//
// Next door: the log as it was dropped (`recorded`), numbers (`tables`).

import type { Answer } from '../answer';
import { curves } from '../plots/curves';
import type { Identification, Said } from './identification';

const none = new Float64Array();

export function draw(host: HTMLElement, found: Identification, { facts, series }: Answer<Said>): void {
  const of = (name: string) => series[name] ?? none;
  const seen = found.lines.map(({ frequency_hz }) => frequency_hz.value);
  facts.spectra.forEach((label, number) => {
    const frequency = of(`spectrum ${number} frequency`);
    const highest = seen.length > 0 ? 1.15 * Math.max(...seen) : Infinity;
    const past = frequency.findIndex((f) => f > highest);
    const count = past < 0 ? frequency.length : past;
    const named = found.lines.map(({ frequency_hz, kind, number: which }) => ({
      x: frequency_hz.value,
      label: kind === 'mode' ? `f${which}` : kind === 'alias' ? `f${which} folded` : kind === 'unknown' ? '' : kind,
    }));
    curves(host, {
      title: `Spectrum of ${label}`,
      x: { label: 'Frequency [Hz]', values: frequency.subarray(0, count) },
      y: { label: 'Density [N/√Hz]', logarithmic: true },
      curves: [{ look: number === 0 ? 'F_o' : 'F_i', label, values: of(`spectrum ${number}`).subarray(0, count) }],
      marks: named,
    });
  });
  if (of('ring time').length > 1) {
    curves(host, {
      title: 'The strongest hit and what was fitted',
      x: { label: 'Time since the hit [ms]', values: of('ring time'), factor: 1e3 },
      y: { label: 'Force [N]' },
      curves: [
        { look: 'F_i', label: 'recorded', values: of('ring measured') },
        { look: 'F_o', label: 'fitted', values: of('ring fitted') },
      ],
    });
  }
  if (of('length').length > 1)
    dots(host, 'Force over length, means of 0.2 s', ['Length [mm]', 'Force [N]'], of('length'), of('force'), 1);
}

/** Dots over length. */
export function dots(
  host: HTMLElement,
  title: string,
  [x, y]: [string, string],
  lengths: Float64Array,
  values: Float64Array,
  factor: number,
): void {
  const order = [...lengths.keys()].sort((a, b) => (lengths[a] ?? 0) - (lengths[b] ?? 0));
  curves(host, {
    title,
    x: { label: x, values: Float64Array.from(order, (index) => 1e3 * (lengths[index] ?? 0)) },
    y: { label: y },
    curves: [
      { look: 'F_i', label: 'recorded', values: order.map((index) => factor * (values[index] ?? 0)), dots: true },
    ],
  });
}
