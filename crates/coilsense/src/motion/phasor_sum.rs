//! Sums of exponentials at many equidistant times, on two levels: `e^(λ(t_p + s_q)) = e^(λt_p) e^(λs_q)`, so that all times together
//! are a product of two small matrices, and a time costs one multiply-add per exponential.
//!
//! Next door: the matrix product (`panel`), its tables (`phasors`), what is summed (`closed`).

use aligned_vec::{AVec, avec};
use num_complex::Complex64;
use pulp::{Simd, WithSimd};

use super::exponentials::Exponentials;
use super::panel::{COLUMNS, Panel, ROWS, Unfold};
use super::phasors::{Phasors, Steps};
use crate::simd::dispatch;

/// Exponentials that are processed at once: their tables stay in the processor's second cache.
const TILE: usize = 48;

/// `Re(coefficient · f(t))`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Term {
    pub coefficient: Complex64,
    pub function: Function,
}

/// A function of time that is a sum of products over `t_p + s_q`.
#[derive(Debug, Clone, Copy)]
pub(super) enum Function {
    /// e^(λt).
    Exponential(Complex64),
    /// (e^(at) − e^(bt))/(a − b).
    Divided(Complex64, Complex64),
}

/// Equidistant times `first + k step`, k = 0…samples−1, counted from the moment that the terms count from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grid {
    pub first: f64,
    pub step: f64,
    pub samples: usize,
}

/// A series to which a sum is added, times a sign.
pub(super) struct Target<'a> {
    /// Shape `samples` of the grid.
    pub values: &'a mut [f64],
    pub sign: f64,
}

/// Adds `Σ Re(coefficient · f(t))` over the grid to each target.
///
/// Without decay, samples lie in pairs t_p ± s_q about the middle of a block, which share their products:
/// `Re(AZ) = Re A Re Z ∓ Im A Im Z`.
///
/// Source:   the addition theorem; `[DLMF]` 4.21.
/// Valid:    any λ with Re λ ≤ 0.
/// Accuracy: rounding of the phases, 1e-16 λt, and of some fourteen products: 5e-13 of the peak over 1 s of the paper's springs.
pub(super) fn add(terms: &[Term], grid: Grid, targets: &mut [Target<'_>]) {
    let decays = terms.iter().any(|term| match term.function {
        Function::Exponential(root) => root.re != 0.0,
        Function::Divided(a, b) => a.re != 0.0 || b.re != 0.0,
    });
    let blocks = Blocks::new(grid, decays);
    let mut tables = [Tables::default(), Tables::default()];
    let mut sums = [avec![0.0; ROWS * blocks.columns], avec![0.0; ROWS * blocks.columns]];
    for tile in terms.chunks(TILE) {
        dispatch(Fill { tables: &mut tables, terms: tile, blocks: &blocks });
        for first_row in (0..blocks.rows).step_by(ROWS) {
            for (sums, tables) in sums.iter_mut().zip(&tables) {
                dispatch(Panel {
                    rows: blocks.rows,
                    first_row,
                    columns: blocks.columns,
                    left: &tables.left,
                    right: &tables.right,
                    sums,
                });
            }
            for target in &mut *targets {
                let width = if blocks.paired { 2 * blocks.columns } else { blocks.columns };
                let begin = (first_row * width).min(target.values.len());
                let end = (begin + ROWS * width).min(target.values.len());
                let values = &mut target.values[begin..end];
                let (columns, paired, sign) = (blocks.columns, blocks.paired, target.sign);
                dispatch(Unfold { sums: [&sums[0], &sums[1]], columns, paired, sign, values });
            }
        }
    }
}

/// How the grid is cut into blocks.
struct Blocks {
    grid: Grid,
    /// Samples of each block lie in pairs about its middle.
    paired: bool,
    /// Blocks, rounded up.
    rows: usize,
    /// Samples of a block, or pairs of them.
    columns: usize,
}

impl Blocks {
    fn new(grid: Grid, decays: bool) -> Self {
        let paired = !decays;
        let per_column = if paired { 2 } else { 1 };
        // As many rows as columns: both tables are then as small as they can be.
        let square = (grid.samples as f64 / per_column as f64).sqrt() as usize;
        let columns = square.next_multiple_of(COLUMNS).clamp(COLUMNS, 16 * COLUMNS);
        let rows = grid.samples.div_ceil(per_column * columns).next_multiple_of(ROWS);
        Self { grid, paired, rows, columns }
    }

    /// First t_p and first s_q, and the steps from block to block and from sample to sample.
    fn origins(&self) -> (f64, f64, f64) {
        let Grid { first, step, .. } = self.grid;
        let columns = self.columns as f64;
        if self.paired {
            (first + (columns - 0.5) * step, 0.5 * step, 2.0 * columns * step)
        } else {
            (first, 0.0, columns * step)
        }
    }
}

/// Factors of one tile of terms: over blocks (left) and over samples of a block (right), a row per product.
struct Tables {
    left: AVec<f64>,
    right: AVec<f64>,
}

impl Default for Tables {
    fn default() -> Self {
        Self { left: avec![], right: avec![] }
    }
}

impl Tables {
    /// Empty, with room for so many products.
    fn begin(&mut self, products: usize, rows: usize, columns: usize) {
        self.left.clear();
        self.right.clear();
        self.left.reserve(products * rows);
        self.right.reserve(products * columns);
    }

    #[inline(always)]
    fn push(&mut self, c: Complex64, part: Part, blocks: &Phasors, right: &[f64]) {
        let begin = self.left.len();
        // Within what was reserved for the tile.
        self.left.resize(begin + blocks.re.len(), 0.0);
        let (re, im) = match part {
            Part::Real => (c.re, -c.im),
            Part::MinusImaginary => (-c.im, -c.re),
        };
        let places = self.left[begin..].iter_mut();
        for ((place, block_re), block_im) in places.zip(&blocks.re).zip(&blocks.im) {
            *place = re * block_re + im * block_im;
        }
        self.right.extend_from_slice(right);
    }
}

/// Part of the product of a coefficient and a phasor.
#[derive(Clone, Copy)]
enum Part {
    Real,
    MinusImaginary,
}

/// Fills the even and the odd tables of a tile of terms.
struct Fill<'a> {
    tables: &'a mut [Tables; 2],
    terms: &'a [Term],
    blocks: &'a Blocks,
}

impl WithSimd for Fill<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        // Plain loops: the compiler turns them into the vectors that are allowed here.
        if S::IS_SCALAR { self.fill::<false>() } else { self.fill::<true>() }
    }
}

impl Fill<'_> {
    #[inline(always)]
    fn fill<const FUSED: bool>(mut self) {
        let (rows, columns) = (self.blocks.rows, self.blocks.columns);
        for tables in self.tables.iter_mut() {
            tables.begin(2 * self.terms.len(), rows, columns);
        }
        let (mut over_blocks, mut over_samples) = (Phasors::of(rows), Phasors::of(columns));
        let (mut drive_over_blocks, mut drive_over_samples) = (Phasors::of(rows), Phasors::of(columns));
        let (block, sample, stride) = self.blocks.origins();
        let step = self.blocks.grid.step;
        let (blocks, samples) = (Steps::new(block, stride, rows), Steps::new(sample, step, columns));
        let mut known = Exponentials::default();
        for root in self.terms.iter().flat_map(Term::roots) {
            blocks.push(root, &mut known);
            samples.push(root, &mut known);
        }
        known.evaluate::<FUSED>();
        let mut next = 0;
        for term in self.terms {
            let of_samples = next + blocks.count();
            let both = of_samples + samples.count();
            match term.function {
                Function::Exponential(_) => {
                    over_blocks.powers(&known, next);
                    over_samples.powers(&known, of_samples);
                    self.push(term.coefficient, &over_blocks, &over_samples, false);
                }
                // E(t + s) = e^(at) E(s) + E(t) e^(bs)
                Function::Divided(a, b) => {
                    let drive = 2 * of_samples - next + samples.count();
                    drive_over_samples.powers(&known, drive);
                    over_blocks.powers(&known, next);
                    over_samples.divided(a, b, sample, step, &drive_over_samples);
                    self.push(term.coefficient, &over_blocks, &over_samples, true);
                    drive_over_blocks.powers(&known, both);
                    over_blocks.divided(a, b, block, stride, &drive_over_blocks);
                    self.push(term.coefficient, &over_blocks, &drive_over_samples, false);
                    next = both;
                }
            }
            next += blocks.count() + samples.count();
        }
    }

    /// Adds the product of both phasors. `mirrored`: f(−s) = −f(s)* instead of f(s)*, which exchanges even and odd.
    #[inline(always)]
    fn push(&mut self, coefficient: Complex64, blocks: &Phasors, samples: &Phasors, mirrored: bool) {
        let exchanged = usize::from(mirrored && self.blocks.paired);
        self.tables[exchanged].push(coefficient, Part::Real, blocks, &samples.re);
        // Without pairs both products go into one sum.
        let other = if self.blocks.paired { 1 - exchanged } else { exchanged };
        self.tables[other].push(coefficient, Part::MinusImaginary, blocks, &samples.im);
    }
}

impl Term {
    /// The λ whose powers its tables are made of.
    fn roots(&self) -> impl Iterator<Item = Complex64> {
        let (first, second) = match self.function {
            Function::Exponential(root) => (root, None),
            Function::Divided(a, b) => (a, Some(b)),
        };
        std::iter::once(first).chain(second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::oscillator::divided_exponential;

    fn direct(terms: &[Term], grid: Grid) -> Vec<f64> {
        let value = |term: &Term, t: f64| match term.function {
            Function::Exponential(root) => (term.coefficient * (root * t).exp()).re,
            Function::Divided(a, b) => (term.coefficient * divided_exponential(a, b, t)).re,
        };
        let time = |k: usize| grid.first + k as f64 * grid.step;
        (0..grid.samples).map(|k| terms.iter().map(|term| value(term, time(k))).sum()).collect()
    }

    #[test]
    fn two_levels_give_what_each_time_alone_gives() {
        for decay in [0.0, -3.0] {
            let term = |k: f64, function| Term { coefficient: Complex64::new(1.0 / k, 0.3 * k), function };
            let mut terms: Vec<Term> = (1..400)
                .map(|k| term(f64::from(k), Function::Exponential(Complex64::new(decay, 20.0 * f64::from(k)))))
                .collect();
            let near = Function::Divided(Complex64::new(decay, 340.0), Complex64::new(0.0, 340.1));
            terms.push(term(1.0, near));
            for samples in [1, 2, 31, 32, 33, 1000, 2501] {
                let grid = Grid { first: 0.3, step: 1e-4, samples };
                let (mut ours, expected) = (vec![0.0; samples], direct(&terms, grid));
                add(&terms, grid, &mut [Target { values: &mut ours, sign: 1.0 }]);
                let scale: f64 = terms.iter().map(|term| term.coefficient.norm()).sum();
                for (a, b) in ours.iter().zip(&expected) {
                    // Phases of some thousand radians, at 1e-16 of them each.
                    assert!((a - b).abs() < 1e-12 * scale, "{a} {b}");
                }
            }
        }
    }
}
