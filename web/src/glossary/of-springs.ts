// Words of the glossary about the spring: what it is, how it rings and in which modes, what is done to it.
//
// Next door: words about forces (`of-forces`), what a word is (`term`).

import { CHAIN, COMPARED, OPEN, SPEC, WORDS, type Term } from './term';

export const SPRING: readonly Term[] = [
  {
    id: 'k',
    names: ['Stiffness k'],
    words: 'How much more force one metre more of stretch takes: the rate.',
    unit: 'N/m',
    book: SPEC.spring,
  },
  {
    id: 'm',
    names: ['Mass m'],
    words: 'The mass of the windings that move, without hooks and end windings.',
    unit: 'g',
    book: SPEC.spring,
  },
  {
    id: 'windings',
    names: ['Windings N'],
    words:
      'How many turns of wire move. The model is a row of as many masses, or a multiple, with a spring between each two.',
    book: CHAIN,
    paper: 'eqs. (4) to (7)',
  },
  {
    id: 'rest',
    names: ['Rest length l0'],
    words: 'How long the spring would be without any force.',
    unit: 'mm',
    book: SPEC.spring,
  },
  {
    id: 'tension',
    names: ['Initial tension F0'],
    words: 'The force that it takes to part windings which were wound tightly onto each other.',
    unit: 'N',
    book: SPEC.spring,
  },
  {
    id: 'solid',
    names: ['solid'],
    words: 'The length at which all windings lie on each other.',
    unit: 'mm',
    book: 'theory.md#3-where-the-papers-equations-end',
  },
  {
    id: 'contact',
    names: ['Windings that meet', 'Windings touch', 'seats'],
    words:
      'The paper’s coil lets windings pass through one another; a real one does not. Asked to, the page has them meet, and the end windings meet their seats, the flat faces that they stand on.',
    book: SPEC.contact,
  },
  {
    id: 'restitution',
    names: ['Restitution e'],
    words: 'Share of their closing speed with which windings part again: 0 is a dull thud, 1 a bounce without loss.',
    book: SPEC.contact,
  },
  {
    id: 'tolerances',
    names: ['Tolerances'],
    words: 'How far a spring that you buy may be off its drawing. The verdict holds over all springs within them.',
    unit: '%',
    book: COMPARED,
  },
];

export const RINGING: readonly Term[] = [
  {
    id: 'surge',
    names: ['surge'],
    words:
      'A wave of closer and wider windings that runs to and fro within the coil, while its ends may stand still. The spring rings.',
    book: CHAIN,
    paper: 'eq. (3)',
  },
  {
    id: 'f1',
    names: ['f1', 'f2'],
    words:
      'The surge frequencies: f1 is how often a second a wave comes back when both ends are held; f2, f3 … lie near its multiples. Those are the lines at which a hit coil rings by itself.',
    unit: 'Hz',
    book: WORDS,
    paper: 'eq. (3)',
  },
  {
    id: 'way',
    names: ['One way', 'one way'],
    words:
      'How long a wave takes from one end of the coil to the other: τ = √(m/k). There and back is one surge period.',
    unit: 'ms',
    book: WORDS,
  },
  {
    id: 'zeta',
    names: ['ζ'],
    words:
      'The damping ratio: how fast ringing dies away. With ζ = 0 it never does; with 0.005 it has lost half after some 22 swings. No measured value for coil springs is known to us, so several are computed unless you say one.',
    book: OPEN,
  },
  {
    id: 'pitch',
    names: ['closer', 'wider than the mean'],
    words:
      'Of the pitch, which is how far it is from one winding to the next. Colours tell where windings lie closer than the mean of all of them, and where wider.',
    unit: '%',
    book: 'guide/page.md#the-page-in-the-browser',
  },
  {
    id: 'amplitude',
    names: ['Amplitude'],
    words:
      'How far a force swings at one frequency, from its mean to its peak; as a condition: how far an end is moved.',
    unit: 'N',
    book: SPEC.condition,
  },
];

export const MODES: readonly Term[] = [
  {
    id: 'mode',
    names: ['Every mode'],
    words: 'A way in which the coil swings by itself, at one frequency, every part of it in step.',
    unit: 'Hz',
    book: COMPARED,
  },
  {
    id: 'axial',
    names: ['axial', 'torsional', 'lateral'],
    words:
      'Along the axis, as the surge; turning about the axis; sideways. Forces along the spring show the first, and a little of the others.',
    book: 'theory.md#3-where-the-papers-equations-end',
  },
  {
    id: 'couple',
    names: ['Couple'],
    words: 'What turns or tilts an end of the spring, beside the force.',
    unit: 'mm (N·mm per N)',
    book: COMPARED,
  },
];

export const DONE: readonly Term[] = [
  {
    id: 'condition',
    names: ['What happens'],
    words:
      'What is done to the spring, and for how long. A spec may have several; the verdict counts the worst of them.',
    book: SPEC.condition,
  },
  {
    id: 'impact',
    names: ['impact', 'How hard it is hit'],
    words:
      'Both ends stop dead while all windings still move: a heel strike, a blow. The speed is that of the windings.',
    unit: 'm/s',
    book: SPEC.condition,
    paper: 'Table II',
  },
  {
    id: 'end-stop',
    names: ['end-stop'],
    words: 'The spring gets longer or shorter steadily, and is stopped at the end of its range.',
    book: SPEC.condition,
    paper: 'eq. (12)',
  },
  {
    id: 'harmonic',
    names: ['harmonic', 'sweep'],
    words: 'One end is moved as a sine: at one frequency, or in a sweep through all from one to another.',
    book: SPEC.condition,
  },
  {
    id: 'step',
    names: ['step', 'ramp', 'pulse'],
    words: 'One end is moved at once (step), steadily within a time (ramp), or there and back (pulse).',
    book: SPEC.condition,
  },
  {
    id: 'held',
    names: ['held', 'under a constant force', 'tied to a mass'],
    words:
      'What end 2 is tied to (its mount): it is held where it is, pulled by a force that does not change, or carries a mass.',
    book: SPEC.mount,
  },
  {
    id: 'judged',
    names: ['Judged', 'judged'],
    words:
      'The part of the simulated time that figures are about; shaded in the plot. What was before it, such as the first ringing, is drawn but not counted.',
    unit: 's',
    book: SPEC.condition,
  },
];
