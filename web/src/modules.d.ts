// What Vite makes of files that are no TypeScript.

declare module '*.toml' {
  const spec: import('./document').Spec;
  export default spec;
}

/** How many bytes the recorded motions of `examples/` have. */
declare const LENGTHS: { cam: number; road: number };
