// What a user may say of a log beside its columns: the command's options, with their words on the page.
//
// Next door: the fields that show them (`form`), the engine that reads them (`coilsense-web`, `log/asked`).

export interface Option {
  /** As the command calls it. */
  name: string;
  label: string;
  hint?: string;
  example?: string;
  /** What may be chosen, the first where nothing is said. */
  words?: readonly (readonly [string, string])[];
  /** A yes or no. */
  tick?: boolean;
  /** Several lines. */
  long?: boolean;
  /** Shown only while another option has one of these words. */
  only?: readonly [string, readonly string[]];
}

export interface Group {
  title: string;
  options: readonly Option[];
}

const BY_TABLE = ['layout', ['']] as const;
const BY_HAND = ['spring', ['']] as const;

export const GROUPS: readonly Group[] = [
  {
    title: 'How the text is written',
    options: [
      {
        name: 'layout',
        label: 'Columns are told by',
        words: [
          ['', 'the table above'],
          ['mapping', 'a mapping file'],
          ['lab-data', 'the preset lab-data'],
        ],
      },
      {
        name: 'mapping',
        label: 'Mapping (TOML)',
        long: true,
        example: '[columns]\nF_o = { column = "LC", gain = "12.5 N" }',
        hint: 'Paste it, or drop the file beside the log.',
        only: ['layout', ['mapping']],
      },
      {
        name: 'delimiter',
        label: 'Columns are separated by',
        words: [
          ['', 'what is found'],
          [',', 'comma'],
          [';', 'semicolon'],
          ['tab', 'tab'],
          ['space', 'spaces'],
          ['|', '|'],
        ],
        only: BY_TABLE,
      },
      {
        name: 'decimal',
        label: 'Decimal sign',
        words: [
          ['', 'what is found'],
          ['.', 'point'],
          [',', 'comma'],
        ],
        only: BY_TABLE,
      },
      { name: 'sample-rate', label: 'Sample rate', example: '2.5 kHz', hint: 'Of a log without a time column.' },
    ],
  },
  {
    title: 'The spring',
    options: [
      {
        name: 'spring',
        label: 'It is',
        words: [
          ['', 'any spring'],
          ['tab', 'that of the tab Spring'],
        ],
        hint: 'A known spring predicts f1, and its coil gives the theories of a calibration.',
      },
      {
        name: 'windings',
        label: 'Active windings',
        example: '52',
        hint: 'Modes are then those of a chain of so many.',
        only: BY_HAND,
      },
      { name: 'radius', label: 'Coil radius', example: '8 mm', hint: 'To the centre of the wire.', only: BY_HAND },
      { name: 'wire', label: 'Wire diameter', example: '2 mm', only: BY_HAND },
      {
        name: 'mass',
        label: 'Mass of the coil',
        example: '65 g',
        hint: 'With the stiffness it predicts f1.',
        only: BY_HAND,
      },
      {
        name: 'end2',
        label: 'End 2 is',
        words: [
          ['', 'what the log says'],
          ['held', 'held'],
          ['free', 'free'],
          ['mass', 'tied to a mass'],
        ],
      },
      { name: 'end-mass', label: 'Mass at end 2', example: '1.2 kg', only: ['end2', ['', 'mass']] },
      {
        name: 'turn',
        label: 'Turn the sign of',
        words: [
          ['', 'no channel'],
          ['F_i', 'F_i'],
          ['F_o', 'F_o'],
          ['u1', 'u1'],
          ['u2', 'u2'],
        ],
      },
    ],
  },
  {
    title: 'What may be cleaned up',
    options: [
      { name: 'drop-incomplete', label: 'leave out rows that lack a value or cannot be read', tick: true },
      { name: 'sort', label: 'put rows into the order of their times', tick: true },
      { name: 'merge-repeated', label: 'take the mean of rows with the same time', tick: true },
      { name: 'unwrap', label: 'count on over midnight and where a counter rolls over', tick: true },
      { name: 'fill-gaps', label: 'Fill gaps up to', example: '10 ms', hint: 'Along straight lines.' },
      { name: 'resample', label: 'Resample to', example: '2.5 kHz' },
      {
        name: 'repair-up-to',
        label: 'A repair may touch of the rows',
        example: '1 %',
        hint: 'Ten rows are never too many.',
      },
      { name: 'from', label: 'Leave out before', example: '2 s' },
      { name: 'to', label: 'and after', example: '10 s' },
    ],
  },
  {
    title: 'How exact',
    options: [
      {
        name: 'accuracy-force',
        label: 'Force sensors, of reading',
        example: '0 %',
        hint: 'Limits of error that the intervals then hold.',
      },
      { name: 'accuracy-position', label: 'Position sensors', example: '0 %' },
      {
        name: 'tolerance',
        label: 'A force is trusted up to',
        example: '1 %',
        hint: 'Error by the spring’s own dynamics.',
      },
      { name: 'prediction-tolerance', label: 'A predicted f1 may be off by', example: '5 %' },
    ],
  },
  {
    title: 'Calibration',
    options: [
      {
        name: 'length-at-zero',
        label: 'Length at zero',
        example: '200 mm',
        hint: 'Where positions read zero. Needs columns L and u1 or u2.',
      },
      {
        name: 'theory',
        label: 'Theory to fit',
        words: [
          ['', 'none'],
          ['steel', 'of magnetic wire'],
        ],
        hint: 'Fits permeability and a constant; two points are enough. Needs the coil.',
      },
      {
        name: 'known-permeability',
        label: 'Relative permeability, if known',
        example: '2.1',
        only: ['theory', ['steel']],
      },
      {
        name: 'leads',
        label: 'Return lead',
        example: 'open',
        hint: 'open (far away), its distance from the coil’s axis, or none (no current along the coil).',
        only: ['theory', ['steel']],
      },
      { name: 'meter-noise', label: 'Meter noise', example: '2 nH', only: ['theory', ['steel']] },
      { name: 'frequency', label: 'Meter frequency', example: '1 kHz', only: ['theory', ['steel']] },
      {
        name: 'form',
        label: 'Form to fit',
        words: [
          ['', 'as is usual'],
          ['inverse-length', '1/l = αL + β'],
          ['cubic', 'L = α/l + β + γ/l²'],
        ],
        only: ['theory', ['']],
      },
      {
        name: 'points',
        label: 'Points to fit',
        example: '2',
        hint: 'Spread over the lengths; the others check the fit.',
      },
      {
        name: 're-zero',
        label: 'Re-zero at',
        example: '141.8 mm, 3.35 uH',
        hint: 'A length and its L, of a spring that was remounted.',
      },
      {
        name: 'method',
        label: 'The curve goes',
        words: [
          ['', 'as is usual'],
          ['all', 'near all points'],
          ['two-point', 'through first and last'],
          ['through-preload', 'through the preload'],
        ],
      },
      {
        name: 'preload',
        label: 'Preload',
        example: '141.8 mm, 3.35 uH',
        hint: 'Length, and its L where no point is there.',
        only: ['method', ['', 'through-preload']],
      },
      {
        name: 'inversion',
        label: 'Theories are read',
        words: [
          ['', 'as is usual'],
          ['exact', 'exactly'],
          ['25-lengths', 'from 25 lengths'],
        ],
      },
    ],
  },
];

/** The second device's own. */
export const CLOCK: Option = {
  name: 'clock',
  label: 'Its clock',
  example: 'auto',
  hint: 'auto: by a channel that both have. F_o=F_x: by two that saw the same motion. -0.2 s: what to add to its times.',
};

const OPTIONS: readonly Option[] = [...GROUPS.flatMap(({ options }) => options), CLOCK];

/** What errors call the table of columns. */
export const COLUMNS = 'the table of columns';

/** What errors call the options: the engine puts it into its sentences. */
export const LABELS: Readonly<Record<string, string>> = {
  column: COLUMNS,
  ...Object.fromEntries(OPTIONS.map(({ name, label }) => [name, `“${label}”`])),
};
