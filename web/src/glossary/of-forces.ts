// Words of the glossary about forces: which there are, how far off they are, what measures and what cleans them.
//
// Next door: words about the spring itself (`of-springs`), what a word is (`term`).

import { CHAIN, COMPARED, OPEN, SPEC, WORDS, type Term } from './term';

export const FORCES: readonly Term[] = [
  {
    id: 'ends',
    names: ['End 1', 'End 2'],
    words:
      'The two ends of the spring. End 1 is at the left, where it is driven; end 2 is at the right, where the load is. What moves from 1 to 2 counts as positive.',
    book: WORDS,
  },
  {
    id: 'F_i',
    names: ['F_i', 'End 1 (F_i)'],
    words: 'The force at end 1, the input, which a load cell there feels; positive where the spring pulls.',
    unit: 'N',
    book: WORDS,
  },
  {
    id: 'F_o',
    names: ['F_o', 'End 2 (F_o)'],
    words: 'The force at end 2, the output, which a load cell there feels; positive where the spring pulls.',
    unit: 'N',
    book: WORDS,
  },
  {
    id: 'F_x',
    names: ['F_x', 'k × stretch'],
    words:
      'The force that the length tells: k × stretch, k times how much longer the spring is than at rest. A spring without mass would carry just that at both ends.',
    unit: 'N',
    book: WORDS,
  },
  {
    id: 'F_L',
    names: ['F_L'],
    words:
      'The force that the coil’s inductance tells: a longer coil has less of it. The calibration 1/l = αL + β makes a length of the inductance L, and k × stretch a force of the length.',
    unit: 'N',
    book: WORDS,
    paper: 'eq. (13)',
  },
  {
    id: 'F_nom',
    names: ['F_nom'],
    words: 'The nominal force: the largest static force in use. Errors are told in per cent of it.',
    unit: 'N',
    book: WORDS,
    paper: 'eq. (14)',
  },
  {
    id: 'truth',
    names: ['Force taken as true'],
    words:
      'The force that the others are held against. Nobody can look up the true one while the coil rings, since its ends disagree. So “off” means: if you take k × stretch as the force, or the force at one end where you choose that.',
    book: COMPARED,
  },
  {
    id: 'exact',
    names: ['exact'],
    words:
      'Every sample of the whole time, as the command computes it. A preview has the shown times only, so that it follows a slider; the exact case takes its place as soon as you rest.',
    book: 'guide/page.md#the-page-in-the-browser',
  },
];

export const OFF: readonly Term[] = [
  {
    id: 'rmsd',
    names: ['RMSD', 'rms'],
    words:
      'The RMS deviation: the square root of the mean of the squared errors over the judged times. Errors of either sign count, large ones more.',
    unit: '% of F_nom',
    book: WORDS,
    paper: 'Table II',
  },
  {
    id: 'max',
    names: ['Max.'],
    words: 'The largest error of either sign over the judged times.',
    unit: '% of F_nom',
    book: 'theory.md#2-what-table-ii-needs',
    paper: 'Table III',
  },
  {
    id: 'bias',
    names: ['Bias'],
    words: 'The mean error over the judged times: what is left after averaging.',
    unit: '% of F_nom',
    book: CHAIN,
  },
];

export const SENSORS: readonly Term[] = [
  {
    id: 'kinds',
    names: ['load-cell', 'deflection', 'two-encoder', 'inductance'],
    words:
      'Ways to measure the force: a load cell at one end; the deflection, a length times k; two encoders, one of them behind a drive train that gives; or the coil’s own inductance.',
    book: SPEC.sensor,
  },
  {
    id: 'bandwidth',
    names: ['Bandwidth'],
    words:
      'Up to which frequency a sensor follows (there it shows 71 %, −3 dB); of a goal: up to which frequency errors count.',
    unit: 'Hz',
    book: SPEC.sensor,
  },
  {
    id: 'limit',
    names: ['Your limit', 'Goal'],
    words:
      'The largest standard uncertainty that you accept. A sensor meets the goal where its worst case is within it.',
    unit: '% or N',
    book: SPEC.goal,
  },
  {
    id: 'u',
    names: ['u [N]', 'standard uncertainty'],
    words:
      'All that a sensor may be off, as one figure that errors stay within in some two of three cases: ringing, noise, calibration, temperature and tolerances together.',
    unit: 'N',
    book: COMPARED,
  },
  {
    id: 'worst',
    names: ['nominal [N]', 'worst [N]', 'inside'],
    words:
      'Of springs within tolerance: nominal is the error of the one as drawn, worst that of the worst one, inside the share of them that meet the goal in the least favourable case.',
    unit: 'N, %',
    book: COMPARED,
  },
  {
    id: 'lag',
    names: ['lag'],
    words: 'How late a sensor or a filter tells what has happened. A controller cannot wait for long.',
    unit: 'ms or degrees',
    book: COMPARED,
  },
];

export const CLEANED: readonly Term[] = [
  {
    id: 'filters',
    names: ['Filters'],
    words:
      'What takes the ringing out of one measured force: a notch at each line, or a mean over one surge period, in which all of it cancels.',
    book: OPEN,
  },
  {
    id: 'estimators',
    names: ['Estimators'],
    words:
      'What works out the force at end 2 from that at end 1 and the motion, by a model of the coil that runs beside it: observers such as a Kalman filter.',
    book: OPEN,
  },
  {
    id: 'noise',
    names: ['Noise'],
    words:
      'How much of the sensor’s noise comes out of a filter, over what goes in; of a sensor: how far its readings scatter.',
    book: 'guide/mitigate.md#mitigate-filters-and-observers',
  },
  {
    id: 'shaped',
    names: ['Shape the command'],
    words: 'To move an end so that its own waves cancel, instead of cleaning the force afterwards.',
    book: OPEN,
  },
  {
    id: 'calibration',
    names: ['Calibration'],
    words:
      'What makes a length of an inductance, 1/l = αL + β, found from measured pairs of both. The page says how far to trust it.',
    book: 'guide/identify.md#from-inductance-to-length',
    paper: 'eq. (13)',
  },
  {
    id: 'transmittance',
    names: ['transmittance'],
    words: 'How large the force at one end is over that at the other, by frequency, while one end is clamped.',
    book: CHAIN,
    paper: 'eq. (1), Fig. 2',
  },
];
