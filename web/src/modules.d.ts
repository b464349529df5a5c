// What Vite makes of files that are no TypeScript.

declare module '*.toml' {
  const spec: import('./document').Spec;
  export default spec;
}

/** How many bytes the recorded motions of `examples/` have. */
declare const LENGTHS: { cam: number; road: number };

/** Where pages of the book are and how they end, where that is known; the paper's address. */
declare const BOOK: { base: string; ending: string } | null;
declare const PAPER: string;

declare module 'gifenc' {
  export type Palette = number[][];
  export function quantize(rgba: Uint8ClampedArray, most: number): Palette;
  export function applyPalette(rgba: Uint8ClampedArray, palette: Palette): Uint8Array;
  export function GIFEncoder(): {
    writeFrame(
      index: Uint8Array,
      width: number,
      height: number,
      options: { palette?: Palette; delay: number; transparent?: boolean; transparentIndex?: number; dispose?: number },
    ): void;
    finish(): void;
    bytes(): Uint8Array<ArrayBuffer>;
    bytesView(): Uint8Array;
  };
}
