// Films as files: what a WebM and a GIF say of themselves, read byte by byte and by nothing that wrote them.

export interface Film {
  width: number;
  height: number;
  /** When each picture is shown, and until when all of them are [ms]. */
  times: number[];
  duration: number;
  /** Bytes of each picture. */
  sizes: number[];
  title?: string;
  /** Of a WebM: places that its index names, and where its clusters are. */
  cues?: number[];
  clusters?: number[];
}

/** Elements that hold others: Segment, Info, Tracks, TrackEntry, Video, Cues, CuePoint, CueTrackPositions, Cluster. */
const HOLDERS = [0x18538067, 0x1549a966, 0x1654ae6b, 0xae, 0xe0, 0x1c53bb6b, 0xbb, 0xb7, 0x1f43b675];

export function webm(bytes: Buffer): Film {
  const film: Film = { width: 0, height: 0, times: [], duration: NaN, sizes: [], cues: [], clusters: [] };
  let [segment, cluster] = [0, 0];
  const vint = (at: number, keepsMark: boolean): [number, number] => {
    const size = Math.clz32(bytes[at]!) - 23;
    const value = bytes.readUIntBE(at, size);
    return [keepsMark ? value : value - 2 ** (7 * size), at + size];
  };
  const walk = (from: number, to: number) => {
    for (let at = from; at < to;) {
      const begin = at;
      const [id, afterId] = vint(at, true);
      const [size, content] = vint(afterId, false);
      const end = content + size;
      if (end > to) throw new Error(`an element of ${size} bytes at ${begin} reaches beyond ${to}`);
      const number = () => bytes.readUIntBE(content, size);
      if (id === 0x18538067) segment = content;
      if (id === 0x1f43b675) film.clusters!.push(begin - segment);
      if (id === 0xe7) cluster = number();
      if (id === 0x4489) film.duration = bytes.readDoubleBE(content);
      if (id === 0x7ba9) film.title = bytes.toString('utf8', content, end);
      if (id === 0xb0) film.width = number();
      if (id === 0xba) film.height = number();
      if (id === 0xf1) film.cues!.push(number());
      if (id === 0xa3) {
        film.times.push(cluster + bytes.readInt16BE(content + 1));
        film.sizes.push(size);
      }
      if (HOLDERS.includes(id)) walk(content, end);
      at = end;
    }
  };
  if (bytes.readUInt32BE(0) !== 0x1a45dfa3) throw new Error('no EBML');
  walk(0, bytes.length);
  return film;
}

export function gif(bytes: Buffer): Film {
  if (bytes.toString('latin1', 0, 6) !== 'GIF89a') throw new Error('no GIF');
  const film: Film = { width: bytes.readUInt16LE(6), height: bytes.readUInt16LE(8), times: [], duration: 0, sizes: [] };
  const table = (flags: number) => (flags & 0x80 ? 3 << ((flags & 7) + 1) : 0);
  const blocks = (from: number): number => {
    let at = from;
    while (bytes[at] !== 0) at += bytes[at]! + 1;
    return at + 1;
  };
  let at = 13 + table(bytes[10]!);
  let delay = 0;
  for (; bytes[at] !== 0x3b;) {
    if (at >= bytes.length) throw new Error('the GIF does not end');
    if (bytes[at] === 0x21) {
      if (bytes[at + 1] === 0xf9) delay = 10 * bytes.readUInt16LE(at + 4);
      at = blocks(at + 2);
    } else if (bytes[at] === 0x2c) {
      const end = blocks(at + 11 + table(bytes[at + 9]!));
      film.times.push(film.duration);
      film.duration += delay;
      film.sizes.push(end - at);
      at = end;
    } else throw new Error(`what is ${bytes[at]} at ${at}?`);
  }
  return film;
}
