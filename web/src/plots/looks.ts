// Colours and dashes: each alone tells lines apart; the four forces look as in the paper's figures.

export interface Look {
  colour: string;
  dash: number[];
  width: number;
}

/** What is drawn in a look of its own. */
export const KNOWN: Readonly<Record<string, Look>> = {
  F_i: { colour: 'blue', dash: [9, 3, 2, 3], width: 1.6 },
  F_o: { colour: 'red', dash: [], width: 1.6 },
  F_x: { colour: 'green', dash: [2, 2.5], width: 2 },
  F_L: { colour: 'ink', dash: [7, 4], width: 1.4 },
  u1: { colour: 'blue', dash: [], width: 1.4 },
  u2: { colour: 'red', dash: [7, 4], width: 1.4 },
};

/** What sensors read: thin, without a dash, in colours that no force has. */
const READING = ['orange', 'purple', 'teal', 'pink', 'olive', 'brown'] as const;

/** What each force is called; its symbol stands behind it, see `called`. */
export const NAMES: Readonly<Record<string, string>> = {
  F_i: 'End 1',
  F_o: 'End 2',
  F_x: 'k × stretch',
  F_L: 'inductance',
};

/** `End 1 (F_i)`; what has no other name is called as it is. */
export const called = (name: string): string => (NAMES[name] ? `${NAMES[name]} (${name})` : name);

export const FORCE_NAMES = ['F_i', 'F_o', 'F_x', 'F_L'] as const;

/** Of what is known, or of the series `reading 0` …; anything else is drawn in ink. A look is itself. */
export function look(name: string | Look): Look {
  if (typeof name !== 'string') return name;
  const number = /^reading (\d+)$/.exec(name)?.[1];
  const colour = number === undefined ? 'ink' : (READING[Number(number) % READING.length] ?? 'ink');
  return KNOWN[name] ?? { colour, dash: [], width: number === undefined ? 1.4 : 1 };
}

const COLOURS = [
  'ground',
  'card',
  'ink',
  'soft',
  'line',
  'accent',
  'red',
  'blue',
  'green',
  'low',
  'middle',
  'high',
  'touch',
  'band',
  'judged',
  ...READING,
] as const;
export type Colour = (typeof COLOURS)[number];
export const ink: Record<Colour, string> = Object.fromEntries(COLOURS.map((name) => [name, '#888'])) as Record<
  Colour,
  string
>;

/** Reads the colours that the style sheet has for the light or dark of now. */
export function readInk(): void {
  const style = getComputedStyle(document.documentElement);
  for (const name of COLOURS) ink[name] = style.getPropertyValue(`--${name}`).trim();
}

/** A piece of a line, as in a legend. */
export function sample(name: string | Look): SVGSVGElement {
  const { colour, dash, width } = look(name);
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '0 0 34 8');
  svg.setAttribute('aria-hidden', 'true');
  svg.setAttribute('class', 'sample');
  const line = document.createElementNS('http://www.w3.org/2000/svg', 'line');
  for (const [key, value] of Object.entries({
    x1: 0,
    y1: 4,
    x2: 34,
    y2: 4,
    'stroke-width': width + 0.3,
    'stroke-dasharray': dash.join(' '),
  })) {
    line.setAttribute(key, String(value));
  }
  line.style.stroke = `var(--${colour})`;
  svg.append(line);
  return svg;
}
