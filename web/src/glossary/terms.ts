// The words of the page that a newcomer does not know: each in a sentence or two, with its unit and where book and paper tell of it.
//
// Next door: how they are shown (`open`). That each is used on the page, and each place is there in the book, is tested (`tests/glossary.spec`).

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

const WORDS = 'start.md#words';
const COMPARED = 'guide/analyze.md#what-is-compared';
const CHAIN = 'theory.md#1-the-chain-in-closed-form';
const OPEN = 'theory.md#4-what-the-paper-leaves-open';
const SPEC = {
  spring: 'guide/spec.md#spring',
  mount: 'guide/spec.md#mount',
  contact: 'guide/spec.md#contact',
  condition: 'guide/spec.md#condition',
  sensor: 'guide/spec.md#sensor',
  goal: 'guide/spec.md#goal',
};

const FORCES: readonly Term[] = [
  {
    id: 'ends',
    names: ['End 1', 'End 2'],
    words:
      'The two ends of the spring. End 1 is at the left, where it is driven; end 2 is at the right, where the load is. What moves from 1 to 2 counts as positive.',
    book: WORDS,
  },
  {
    id: 'F_i',
    names: ['F_i'],
    words: 'The force at end 1, the input, which a load cell there feels; positive where the spring pulls.',
    unit: 'N',
    book: WORDS,
  },
  {
    id: 'F_o',
    names: ['F_o'],
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
    names: ['Taken as true'],
    words:
      'The force that the others are held against. Nobody can look up the true one while the coil rings, since its ends disagree. So “off” means: if you take k × stretch as the force, or the force at one end where you choose that.',
    book: COMPARED,
  },
];

const RINGING: readonly Term[] = [
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
      'The damping ratio: how fast ringing dies away. With ζ = 0 it never does; with 0.005 it has lost half after some 22 swings. Nobody has published it for coil springs, so several are computed unless you say one.',
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

const DONE: readonly Term[] = [
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
  {
    id: 'exact',
    names: ['exact'],
    words:
      'Every sample of the whole time, as the command computes it. A preview has the shown times only, so that it follows a slider; the exact case takes its place as soon as you rest.',
    book: 'guide/page.md#the-page-in-the-browser',
  },
];

const SPRING: readonly Term[] = [
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

const SENSORS: readonly Term[] = [
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
      'Of springs within tolerance: nominal is the error of the one as drawn, worst that of the worst one, inside the share of them that meet the goal in every case.',
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

const OFF: readonly Term[] = [
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

const MODES: readonly Term[] = [
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

const CLEANED: readonly Term[] = [
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
