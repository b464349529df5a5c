// A film as WebM, compressed by the browser's own encoder: each picture has its time by its number, however long it takes to draw.
//
// Next door: the file (`webm`), the same as a GIF (`gif`), the pictures (`picture`).

import { rest, shareOf, type Made, type Making, type Source } from './frames';
import { webm, type Chunk, type Film } from './webm';

const RATE = 30;
/** A key every so many pictures: seeking is as fine [pictures]. */
const KEYS = 60;
const SIZE = { width: 1280, height: 720 };
/** Words stay sharp at this rate, and 12 s are 6 MB at most [bit/s]. */
const BITRATE = 4e6;
/** Most pictures that wait to be compressed. */
const QUEUE = 4;
/** How long it is waited for the encoder to take one, before it is looked whether it still works [ms]. */
const LONGEST = 100;

const CODECS = [
  ['vp09.00.31.08', 'V_VP9'],
  ['vp8', 'V_VP8'],
] as const;

/** The first codec that this browser compresses with; null where there is none. */
export async function codec(): Promise<{ config: VideoEncoderConfig; name: Film['codec'] } | null> {
  if (!('VideoEncoder' in window)) return null;
  for (const [codec, name] of CODECS) {
    const config = { codec, ...SIZE, bitrate: BITRATE, framerate: RATE };
    const found = await VideoEncoder.isConfigSupported(config).catch(() => null);
    if (found?.supported) return { config, name };
  }
  return null;
}

/** Waits for the encoder, which works on other cores: who asks again and again takes one of them away. */
async function room(encoder: VideoEncoder, making: Making): Promise<void> {
  await new Promise((go) => {
    encoder.addEventListener('dequeue', go, { once: true });
    // One that has failed takes nothing more.
    setTimeout(go, LONGEST);
  });
  await rest(making);
}

export async function video(
  source: Source,
  { config, name }: NonNullable<Awaited<ReturnType<typeof codec>>>,
  making: Making,
): Promise<Made> {
  const count = Math.max(2, Math.round(source.seconds * RATE));
  const chunks: Chunk[] = [];
  let failed: unknown = null;
  const encoder = new VideoEncoder({
    output: (chunk) => {
      const bytes = new Uint8Array(chunk.byteLength);
      chunk.copyTo(bytes);
      chunks.push({ time: Math.round(chunk.timestamp / 1e3), isKey: chunk.type === 'key', bytes });
    },
    error: (reason) => (failed = reason),
  });
  try {
    encoder.configure(config);
    for (let number = 0; number < count; number++) {
      const timestamp = Math.round((1e6 * number) / RATE);
      const picture = new VideoFrame(source.draw(shareOf(number, count), SIZE.width), { timestamp });
      encoder.encode(picture, { keyFrame: number % KEYS === 0 });
      picture.close();
      await rest(making);
      while (encoder.encodeQueueSize > QUEUE && !failed) await room(encoder, making);
      if (failed) throw failed;
      making.told(number + 1, count);
    }
    await encoder.flush();
  } finally {
    if (encoder.state !== 'closed') encoder.close();
  }
  if (chunks.length !== count || !chunks[0]?.isKey) throw new Error(`${chunks.length} of ${count} pictures came`);
  const { title } = source;
  const times = { frame: 1e3 / RATE, duration: (1e3 * count) / RATE };
  return { blob: webm({ title, codec: name, ...SIZE, ...times, chunks }), ending: 'webm' };
}
