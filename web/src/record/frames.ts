// What a film is made from: pictures by number, however fast they come; and how whoever makes it is told and stopped.
//
// Next door: the pictures (`picture`), those who make films of them (`video`, `gif`), who asks (`record`).

export interface Source {
  title: string;
  /** How long the film is [s]. */
  seconds: number;
  /** Draws a picture at a share of the film, 0 to 1, on a canvas of its own that is so wide [dots]. */
  draw(share: number, width: number): HTMLCanvasElement;
}

export interface Made {
  blob: Blob;
  ending: 'webm' | 'gif';
}

export interface Making {
  /** Hears how many pictures are done, and of how many. */
  told(done: number, of: number): void;
  signal: AbortSignal;
}

/** No film is larger [bytes]. */
export const MOST = 20e6;

/** Where picture `number` of so many is: the first at the beginning, the last at the end. */
export const shareOf = (number: number, of: number): number => (of > 1 ? number / (of - 1) : 0);

const channel = new MessageChannel();
let waits: (() => void)[] = [];
channel.port1.onmessage = () => {
  const all = waits;
  waits = [];
  for (const go of all) go();
};

/** Lets the page live between two pictures, also where it is not looked at and timers sleep; throws where the film is not wanted any more. */
export async function rest({ signal }: Making): Promise<void> {
  await new Promise<void>((go) => {
    waits.push(go);
    channel.port2.postMessage(0);
  });
  signal.throwIfAborted();
}
