// A WebM file of frames that are compressed already: one track of video, with an index, so that players can seek.
//
// Next door: who compresses them (`video`). The elements are those of RFC 8794 (EBML) and RFC 9559 (Matroska).

export interface Chunk {
  /** When it is shown [ms]. */
  time: number;
  isKey: boolean;
  bytes: Uint8Array;
}

export interface Film {
  title: string;
  codec: 'V_VP8' | 'V_VP9';
  width: number;
  height: number;
  /** How long each frame is shown, and all of them [ms]. */
  frame: number;
  duration: number;
  /** In order of time; the first is a key. */
  chunks: readonly Chunk[];
}

/** Bytes in pieces, so that nothing is copied twice. */
type Pieces = Uint8Array[];

const text = (words: string): Pieces => [new TextEncoder().encode(words)];

/** A whole number in so many bytes, the highest first; in as few as it takes where none are said. */
function whole(value: number, size?: number): Pieces {
  const bytes: number[] = [];
  for (let rest = value; rest > 0 || bytes.length === 0; rest = Math.floor(rest / 256)) bytes.unshift(rest % 256);
  while (bytes.length < (size ?? 1)) bytes.unshift(0);
  return [Uint8Array.from(bytes)];
}

function real(value: number): Pieces {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, value);
  return [bytes];
}

const length = (pieces: Pieces): number => pieces.reduce((sum, { length }) => sum + length, 0);

/** An element: its name, how long it is in four bytes, what is in it. */
function element(id: number, ...content: Pieces[]): Pieces {
  const inside = content.flat();
  return [...whole(id), ...whole(0x10000000 + length(inside), 4), ...inside];
}

function head({ title, codec, width, height, frame, duration }: Film): Pieces {
  return [
    ...element(
      0x1549a966,
      element(0x2ad7b1, whole(1e6)),
      element(0x4489, real(duration)),
      element(0x7ba9, text(title)),
      element(0x4d80, text('coilsense')),
      element(0x5741, text('coilsense')),
    ),
    ...element(
      0x1654ae6b,
      element(
        0xae,
        element(0xd7, whole(1)),
        element(0x73c5, whole(1)),
        element(0x9c, whole(0)),
        element(0x83, whole(1)),
        element(0x86, text(codec)),
        element(0x23e383, whole(Math.round(1e6 * frame))),
        element(0xe0, element(0xb0, whole(width)), element(0xba, whole(height))),
      ),
    ),
  ];
}

/** From a key to before the next; times within it are counted from its own. */
function cluster(chunks: readonly Chunk[]): Pieces {
  const begin = chunks[0]?.time ?? 0;
  const blocks = chunks.map(({ time, isKey, bytes }) => {
    const after = time - begin;
    return element(0xa3, [Uint8Array.of(0x81, after >> 8, after & 255, isKey ? 0x80 : 0), bytes]);
  });
  return element(0x1f43b675, element(0xe7, whole(begin)), ...blocks);
}

const cues = (times: readonly number[], places: readonly number[]): Pieces =>
  element(
    0x1c53bb6b,
    ...times.map((time, number) =>
      element(
        0xbb,
        element(0xb3, whole(time, 4)),
        // A place has always as many bytes, since how long this index is decides on it.
        element(0xb7, element(0xf7, whole(1)), element(0xf1, whole(places[number] ?? 0, 4))),
      ),
    ),
  );

export function webm(film: Film): Blob {
  const starts = film.chunks.flatMap(({ isKey }, number) => (isKey ? [number] : []));
  const groups = starts.map((start, number) => film.chunks.slice(start, starts[number + 1]));
  const clusters = groups.map(cluster);
  const times = groups.map(([first]) => first?.time ?? 0);
  const before = head(film);
  let next = length(before) + length(cues(times, []));
  const places = clusters.map((pieces) => (next += length(pieces)) - length(pieces));
  const header = element(
    0x1a45dfa3,
    element(0x4286, whole(1)),
    element(0x42f7, whole(1)),
    element(0x42f2, whole(4)),
    element(0x42f3, whole(8)),
    element(0x4282, text('webm')),
    element(0x4287, whole(4)),
    element(0x4285, whole(2)),
  );
  const segment = element(0x18538067, before, cues(times, places), ...clusters);
  return new Blob([...header, ...segment] as Uint8Array<ArrayBuffer>[], { type: 'video/webm' });
}
