// What a person types, in the words of the engine: `1,2 kN/m`, `760` in a field that shows N/m, `4.3 lb/in`, `5 mph`. The one door of all fields.
//
// Next door: the fields (`control`, `damping`, `contact`), the slider's numbers (`quantity`). Which units there are is for the engine to say.

export interface Understood {
  /** As the engine takes it; what was typed, where that is no number or may be two. */
  text: string;
  /** Why it is not taken: it may be two numbers. */
  doubt?: string;
  /** What else somebody may have meant, and what was taken. */
  note?: string;
}

/** Spellings of the engine's units, in small letters; none that is another unit but for its capitals (mN and MN, mm and Mm). */
const SPELLINGS: Record<string, string> = {
  N: 'n newton newtons',
  kN: 'kn',
  'N/m': 'n/m',
  'N/mm': 'n/mm',
  'kN/m': 'kn/m',
  lbf: 'lbf',
  'lbf/in': 'lbf/in lbf/inch lb/in lbs/in lb/inch',
  kg: 'kg kgs',
  g: 'gram grams',
  lb: 'lb lbs pound pounds',
  oz: 'oz ounce ounces',
  in: 'in in. inch inches ″ ” "',
  ft: 'ft foot feet',
  mil: 'mil mils thou',
  s: 'sec secs second seconds',
  ms: 'msec',
  Hz: 'hz',
  kHz: 'khz',
  rpm: 'rpm 1/min r/min',
  'km/h': 'km/h kmh kph km/hr',
  deg: 'deg ° degree degrees',
  '%': 'percent',
  f1: 'f1 f_1 f₁',
};
const UNITS = new Map(
  Object.entries(SPELLINGS).flatMap(([unit, spelled]) => spelled.split(' ').map((one) => [one, unit])),
);
/** Units that the engine does not know: what takes them to one that it does, exactly by the treaty on yard and pound of 1959. */
const OTHERS: Record<string, readonly [number, string]> = {
  mph: [0.44704, 'm/s'],
  'mi/h': [0.44704, 'm/s'],
  'ft/s': [0.3048, 'm/s'],
  'in/s': [0.0254, 'm/s'],
  'n/cm': [100, 'N/m'],
};
const FORCES = ['N', 'kN', 'mN', 'lbf', 'kgf', 'gf'];

const TYPED = /^([-+]?)((?:\d+(?:[.,'’ ]\d+)*|[.,]\d+)[.,]?)(e[-+]?\d+)?\s*((?![\s\d.,'’/+-]).*)$/i;

/** `unit` is the one that the field shows, which a bare number takes. */
export function understand(typed: string, unit = ''): Understood {
  const plain = typed
    .replace(/[\u00a0\u2009\u202f]/g, ' ')
    .replace('−', '-')
    .replace('μ', 'µ')
    .trim();
  const [, sign = '', digits = '', power = '', rest = ''] = TYPED.exec(plain) ?? [];
  const numbers = readings(digits.replace(/[.,]$/, ''));
  const [number, other] = numbers;
  if (number === undefined) return { text: plain };
  const [factor, known] = unitOf(rest, unit);
  const put = (digits: string) => {
    const value = factor === 1 ? `${sign}${digits}${power}` : exactly(Number(`${sign}${digits}${power}`) * factor);
    return known ? `${value} ${known}` : value;
  };
  if (other === undefined) return { text: put(number) };
  const [one, two] = [put(number), put(other)];
  if (digits.includes(',')) return { text: plain, doubt: `may be ${one} or ${two}: write one of them so` };
  return { text: one, note: `read with a decimal point: not ${two}` };
}

/** Digits and signs as the numbers that they may be: with a decimal sign, or with thousands set apart. */
function readings(body: string): string[] {
  const signs = body.match(/[.,'’ ]/g) ?? [];
  const last = body.search(/[.,]\d*$/);
  const found: string[] = [];
  if (last >= 0 && signs.filter((sign) => sign === body[last]).length === 1) {
    const whole = ungrouped(body.slice(0, last));
    if (whole !== null) found.push(`${whole || '0'}.${body.slice(last + 1)}`);
  }
  const all = ungrouped(body);
  if (all) found.push(all);
  return found;
}

/** Without what sets thousands apart; nothing where that does not stand before each three digits. */
function ungrouped(whole: string): string | null {
  if (/^\d*$/.test(whole)) return whole;
  return /^[1-9]\d{0,2}([.,'’ ])\d{3}(\1\d{3})*$/.test(whole) ? whole.replace(/\D/g, '') : null;
}

/** What takes a unit as it is typed to one of the engine's. */
function unitOf(typed: string, shown: string): readonly [number, string] {
  if (typed === '') return [1, shown];
  const spelled = typed.toLowerCase().replace(/ *\/ */g, '/');
  const known = UNITS.get(spelled);
  if (known === 'lb' && FORCES.includes(shown)) return [1, 'lbf'];
  return OTHERS[spelled] ?? [1, known ?? typed];
}

/** A product of two decimal numbers, without what doubles add. */
const exactly = (value: number): string => String(Number(value.toPrecision(15)));

/** Two or more values: set apart by a semicolon, by a comma and a space, by one behind a unit, or by a word. */
export const parts = (text: string): string[] =>
  text
    .split(/;|,\s+|(?<=[a-zµ%]),|(?<=[a-z]\d),|\s+to\s+/i)
    .map((part) => part.trim())
    .filter(Boolean);
