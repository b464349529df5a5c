// Numbers and units as people type them, without a browser: what they are understood as, what is refused since it may be two things, and what
// is left to the engine to refuse.
import { expect, test } from '@playwright/test';
import { parts, understand } from '../src/inputs/understand';

/** What is typed, the unit that the field shows, and what the engine is to see. */
const TAKEN = [
  ['1,2 kN/m', 'N/m', '1.2 kN/m'],
  ['760', 'N/m', '760 N/m'],
  ['0,01', '', '0.01'],
  ['0,010 kg', 'g', '0.010 kg'],
  ['−3,5 mm', 'mm', '-3.5 mm'],
  ['.5', 'mm', '0.5 mm'],
  ['5,', 'mm', '5 mm'],
  ['1,5e-3 m', 'mm', '1.5e-3 m'],
  ['1.234,5 N', 'N', '1234.5 N'],
  ['1,234.5 N', 'N', '1234.5 N'],
  ['1 234 N', 'N', '1234 N'],
  ["1'234,5 g", 'g', '1234.5 g'],
  ['12,345,678', 'N', '12345678 N'],
  ['1234,567 N', 'N', '1234.567 N'],
  ['70g', 'g', '70 g'],
  ['4.34 lbf/in', 'N/m', '4.34 lbf/in'],
  ['4,34 lb / in', 'N/m', '4.34 lbf/in'],
  ['1.5"', 'mm', '1.5 in'],
  ['63 thou', 'mm', '63 mil'],
  ['2 lbs', 'g', '2 lb'],
  ['2 lbs', 'N', '2 lbf'],
  ['8 oz', 'g', '8 oz'],
  ['36 km/h', 'm/s', '36 km/h'],
  ['5 mph', 'm/s', '2.2352 m/s'],
  ['7.6 N/cm', 'N/m', '760 N/m'],
  ['3 KHz', 'Hz', '3 kHz'],
  ['20 μm', 'mm', '20 µm'],
  ['0,5', 'f1', '0.5 f1'],
] as const;

test('what people type is what the engine sees', () => {
  for (const [typed, unit, text] of TAKEN) expect(understand(typed, unit), `${typed} where ${unit}`).toEqual({ text });
});

test('a comma that may set thousands apart is refused, and both readings are named', () => {
  for (const [typed, unit, one, two] of [
    ['1,001', 'N/m', '1.001 N/m', '1001 N/m'],
    ['12,500 N', 'N', '12.500 N', '12500 N'],
    ['-1,001 mph', 'm/s', '-0.44748704 m/s', '-447.48704 m/s'],
  ] as const) {
    const { text, doubt, note } = understand(typed, unit);
    // The engine takes no comma: what is in doubt can never be computed.
    expect(text).toBe(typed);
    expect(doubt).toContain(`may be ${one} or ${two}`);
    expect(note).toBeUndefined();
  }
});

test('a point that may set thousands apart is a decimal one, as everywhere on the page, and that is told', () => {
  expect(understand('1.001 N/m', 'N/m')).toEqual({
    text: '1.001 N/m',
    note: 'read with a decimal point: not 1001 N/m',
  });
  expect(understand('0.001 N/m').note).toBeUndefined();
  expect(understand('1.0010 N/m').note).toBeUndefined();
  expect(understand('1234.567 N/m').note).toBeUndefined();
});

test('capitals that would make another unit, and what is no number, are left for the engine to refuse', () => {
  for (const typed of [
    '5 Nm',
    '5 Mm',
    '5 MN',
    '1..2 m',
    '1,2,3 N',
    '3/8 in',
    '2 1/2 in',
    '12,34,567 N',
    'mid',
    'x',
    '',
  ])
    expect(understand(typed, 'mm'), typed).toEqual({ text: typed });
});

test('two values are set apart by a semicolon, a comma and a space, or a unit', () => {
  expect(parts('0,75 s; 1 s')).toEqual(['0,75 s', '1 s']);
  expect(parts('0.75 s, 1 s')).toEqual(['0.75 s', '1 s']);
  expect(parts('0.2 f1,1.2 f1')).toEqual(['0.2 f1', '1.2 f1']);
  expect(parts('10 to 20 Hz')).toEqual(['10', '20 Hz']);
  expect(parts('0,5')).toEqual(['0,5']);
});
