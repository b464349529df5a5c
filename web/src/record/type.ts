// Words on a film's pictures: in the page's letters, in one size on every screen, cut where there is no room.
//
// Next door: what they are about (`picture`, `plot`).

/** In the units of a picture. */
export const letters = (size: number, weight = 400): string => `${weight} ${size}px system-ui, sans-serif`;

export interface Style {
  size: number;
  colour: string;
  weight?: number;
  align?: 'left' | 'right' | 'center';
  /** Room for it; what does not fit ends in an ellipsis. */
  room?: number;
}

/** Writes a line of words at its base line, letters behind `F_` lowered; how wide it is. */
export function write(
  context: CanvasRenderingContext2D,
  words: string,
  x: number,
  y: number,
  { size, colour, weight = 400, align = 'left', room = Infinity }: Style,
): number {
  const parts = pieces(words);
  const width = () => parts.reduce((sum, part) => sum + measure(context, part, size, weight), 0);
  let last = parts[parts.length - 1];
  while (width() > room && last) {
    last.text = last.text.replace(/.…?$/u, '…');
    if (last.text === '…' && parts.length > 1) parts.pop();
    else if (last.text === '…') break;
    last = parts[parts.length - 1];
  }
  const wide = width();
  let at = align === 'left' ? x : align === 'right' ? x - wide : x - wide / 2;
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  context.fillStyle = colour;
  for (const part of parts) {
    const wide = measure(context, part, size, weight);
    context.fillText(part.text, at, y + (part.isLow ? 0.2 * size : 0));
    at += wide;
  }
  return wide;
}

interface Part {
  text: string;
  isLow: boolean;
}

const pieces = (words: string): Part[] =>
  words.split(/(?<=\bF)_([a-zA-Z]|nom)\b/).map((text, number) => ({ text, isLow: number % 2 === 1 }));

function measure(context: CanvasRenderingContext2D, { text, isLow }: Part, size: number, weight: number): number {
  context.font = letters(isLow ? 0.75 * size : size, weight);
  return context.measureText(text).width;
}
