// What Vite makes of files that are no TypeScript.

declare module '*.toml' {
  const spec: import('./document').Spec;
  export default spec;
}
