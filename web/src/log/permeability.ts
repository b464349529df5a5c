// What magnetic wire would make of the coil: a slider for its permeability, and what the measured points then leave.
//
// Next door: the inductances of each permeability (`coilsense-web`, `log/calibrated`), the fit that finds the best (`calibration`).

import { clamp, digits, make } from '../dom';
import { Told } from '../told';
import { curves } from '../plots/curves';
import { card } from './found';

export interface Wire {
  /** μ_r, from 1 in equal steps. */
  permeabilities: number[];
  /** L of each [H], at the lengths of the points. */
  inductances: Float64Array[];
  lengths: Float64Array;
  measured: Float64Array;
  /** α of eq. (13) [1/(H m)], by which an inductance is a length. */
  alpha: number;
  /** What eq. (13) leaves of the points [H]. */
  left: Float64Array;
  /** What was fitted, where that is magnetic wire. */
  fitted: number | null;
}

/** L at the points for a permeability between two of the row's. */
function between({ permeabilities, inductances }: Wire, permeability: number): Float64Array {
  const [first = 1, second = 2] = permeabilities;
  const place = clamp((permeability - first) / (second - first), 0, permeabilities.length - 1);
  const low = Math.min(Math.floor(place), permeabilities.length - 2);
  const [below, above] = [inductances[low], inductances[low + 1]];
  return Float64Array.from(below ?? [], (value, index) => value + (place - low) * ((above?.[index] ?? NaN) - value));
}

/** What the points leave of it: the constant, the best in the mean, and each point's rest [H]. */
function rest(wire: Wire, permeability: number): { constant: number; left: Float64Array } {
  const curve = between(wire, permeability);
  const off = Float64Array.from(wire.measured, (value, index) => value - (curve[index] ?? NaN));
  const constant = off.reduce((sum, value) => sum + value, 0) / off.length;
  return { constant, left: off.map((value) => value - constant) };
}

const rms = (values: Float64Array): number =>
  Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / values.length);

/** How far lengths are off by that, in % of their range. */
function ofRange({ alpha, lengths }: Wire, left: Float64Array): number {
  const metres = left.map((value, index) => value * alpha * (lengths[index] ?? NaN) ** 2);
  return (100 * rms(metres)) / (Math.max(...lengths) - Math.min(...lengths));
}

/** The permeability that leaves least, to a hundredth. */
function best(wire: Wire): number {
  const last = wire.permeabilities.at(-1) ?? 1;
  const all = Array.from({ length: Math.round(100 * (last - 1)) + 1 }, (_, index) => 1 + index / 100);
  return all.reduce((a, b) => (rms(rest(wire, b).left) < rms(rest(wire, a).left) ? b : a));
}

export function permeability(wire: Wire): HTMLElement {
  const last = wire.permeabilities.at(-1) ?? 1;
  const slider = make('input', { type: 'range', min: 1, max: last, step: 0.01, 'aria-label': 'Relative permeability' });
  const told = make('output', { class: 'length', 'aria-live': 'off' });
  const words = make('p', { role: 'status' });
  const said = new Told(words);
  const figure = make('div', { class: 'figures' });
  const nearest = best(wire);
  slider.value = String(clamp(wire.fitted ?? nearest, 1, last));
  const show = () => {
    const chosen = Number(slider.value);
    const { constant, left } = rest(wire, chosen);
    told.textContent = digits(chosen, 3);
    slider.setAttribute('aria-valuetext', digits(chosen, 3));
    said.tell(
      `With a permeability of ${digits(chosen, 3)}${chosen === 1 ? ' (not magnetic)' : ''} and a constant of ${digits(1e9 * constant, 3)} nH, ` +
        `${digits(1e9 * rms(left), 3)} nH rms remain, ${digits(ofRange(wire, left), 2)} % of the range; ` +
        `1/l = αL + β leaves ${digits(1e9 * rms(wire.left), 3)} nH. ` +
        (nearest === 1 || nearest === last
          ? `Least remains at ${digits(nearest, 3)}, the end of the slider: the theory may not be that of this coil.`
          : `Least remains at ${digits(nearest, 3)}.`),
    );
    figure.replaceChildren();
    curves(figure, {
      title: 'Measured inductance less that of the coil',
      x: { label: 'Length [mm]', values: wire.lengths.map((length) => 1e3 * length) },
      y: { label: 'L left [nH]' },
      curves: [
        {
          look: 'F_i',
          label: `permeability ${digits(chosen, 3)}`,
          values: left.map((value) => 1e9 * value),
          dots: true,
        },
        { look: 'F_L', label: '1/l = αL + β', values: wire.left.map((value) => 1e9 * value), dots: 'hollow' },
      ],
    });
  };
  slider.addEventListener('input', show);
  const element = card(
    'Is its wire magnetic?',
    make('div', { class: 'stops' }, make('label', {}, 'Relative permeability ', slider), told),
    words,
    make(
      'p',
      { class: 'hint' },
      'Computed from windings, radii and the permeability of the wire, with one constant for leads, hooks and what is not known of the coil. Drawn stainless wire was ' +
        'found at 1 to 3. To fit it, choose the theory of magnetic wire above.',
    ),
    figure,
  );
  // The chart takes its width from the page.
  requestAnimationFrame(show);
  return element;
}
