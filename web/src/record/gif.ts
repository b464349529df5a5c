// A film as an animated GIF: one palette for all pictures, and of each picture only what changed. The same film is the same bytes.
//
// Next door: the same as WebM (`video`), the pictures (`picture`).

import { applyPalette, GIFEncoder, quantize, type Palette } from 'gifenc';
import { MOST, rest, shareOf, type Made, type Making, type Source } from './frames';

/** How long each picture is shown [ms]: GIF counts in hundredths of a second. */
const DELAY = 60;
/** Widths and every how many-th picture, until it is small enough [dots]. */
const SIZES = [
  [800, 1],
  [640, 1],
  [480, 1],
  [480, 2],
  [320, 3],
] as const;
/** From so many pictures on it is told how large all will be. */
const TELLING = 8;
/** Pictures whose colours make the palette, and one of its colours is kept for what does not change. */
const SAMPLES = [0, 0.3, 0.6, 1];
const COLOURS = 255;

/** No size was small enough. */
export class TooLarge extends Error {}

export async function gif(source: Source, making: Making, most = MOST): Promise<Made> {
  for (const [width, every] of SIZES) {
    const bytes = await attempt(source, making, width, every, most);
    if (bytes) return { blob: new Blob([bytes], { type: 'image/gif' }), ending: 'gif' };
  }
  throw new TooLarge(`a GIF of it would be larger than ${most / 1e6} MB`);
}

/** The file; null where it would be too large. */
async function attempt(
  source: Source,
  making: Making,
  width: number,
  every: number,
  most: number,
): Promise<Uint8Array<ArrayBuffer> | null> {
  const count = Math.max(2, Math.round((1e3 * source.seconds) / DELAY / every));
  const palette = await common(source, making, width);
  const file = GIFEncoder();
  let before: Uint8Array | null = null;
  for (let number = 0; number < count; number++) {
    const picture = dots(source.draw(shareOf(number, count), width));
    const index = applyPalette(picture.data, palette);
    const changed: Uint8Array | null = before && difference(index, before, palette.length);
    file.writeFrame(changed ?? index, picture.width, picture.height, {
      delay: DELAY * every,
      // One colour more than is used: what is of it is as it was.
      ...(number === 0 ? { palette: [...palette, [0, 0, 0]] } : {}),
      ...(changed ? { transparent: true, transparentIndex: palette.length } : {}),
      dispose: 1,
    });
    before = index;
    const size = file.bytesView().length;
    if (size > most || (number >= TELLING && (size / (number + 1)) * count > 1.2 * most)) return null;
    making.told(number + 1, count);
    await rest(making);
  }
  file.finish();
  return file.bytes();
}

const dots = (canvas: HTMLCanvasElement): ImageData => {
  const context = canvas.getContext('2d');
  if (!context) throw new Error('this browser draws no pictures');
  return context.getImageData(0, 0, canvas.width, canvas.height);
};

/** Colours of pictures from all of the film. */
async function common(source: Source, making: Making, width: number): Promise<Palette> {
  const all: Uint8ClampedArray[] = [];
  for (const share of SAMPLES) {
    all.push(dots(source.draw(share, width)).data);
    await rest(making);
  }
  const joined = new Uint8ClampedArray(all.reduce((sum, { length }) => sum + length, 0));
  all.reduce((at, data) => (joined.set(data, at), at + data.length), 0);
  return quantize(joined, COLOURS);
}

/** What is as before has a number of its own. */
const difference = (index: Uint8Array, before: Uint8Array, same: number): Uint8Array =>
  index.map((colour, at) => (colour === before[at] ? same : colour));
