// What is tried in every run, and what only in the long proof: `cargo xtask test --long` sets COILSENSE_LONG; who asks Firefox for all means all.

export const isLong = Boolean(process.env['COILSENSE_LONG']) || process.env['COILSENSE_FIREFOX'] === 'all';

/** All of a list in the long proof; else the first, which stands for the others. */
export const typical = <T>(all: readonly T[]): readonly T[] => (isLong ? all : all.slice(0, 1));
