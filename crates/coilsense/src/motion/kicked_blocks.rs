//! Modes under a jump of rate at every point of a grid, block by block: what came before a block is a few numbers per mode, what comes within it
//! one short answer, and both together are a small matrix product.
//!
//! Next door: which recordings lie on a grid (`recorded`), the matrix product (`panel`), one step after the other (`march`).

use aligned_vec::{AVec, avec};
use num_complex::Complex64;
use pulp::{Simd, WithSimd};

use super::exponentials::Exponentials;
use super::panel::{COLUMNS, Panel, ROWS};
use super::phasor_sum::Target;
use super::phasors::{Phasors, Steps};
use crate::simd::dispatch;

/// Points of a block, a multiple of [`COLUMNS`]. Longer ones have fewer beginnings, but a longer answer within: this costs least.
pub(super) const BLOCK: usize = 2 * COLUMNS;

/// Blocks that are processed at once, a multiple of [`COLUMNS`]: their table stays in the processor's second cache, and its rows do not
/// all begin at the same place of the first.
const BLOCKS: usize = 9 * COLUMNS;

/// Exponentials that are processed at once, for the same reason.
const TILE: usize = 48;

/// Exponentials that are carried from block to block side by side, since each waits for itself.
const ABREAST: usize = 4;

/// What one exponential of a mode answers to a unit kick, `Re(coefficient e^(λt))` from the kick on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Answer {
    pub root: Complex64,
    pub coefficient: Complex64,
}

/// Kicks at the points of a grid, and the points whose values are asked for.
pub(super) struct Kicks {
    step: f64,
    chunks: Vec<Chunk>,
    first: usize,
    stride: usize,
}

/// The kicks of some blocks.
struct Chunk {
    /// Point of the grid at which it begins.
    begin: usize,
    /// How many blocks, rounded up to a multiple of [`COLUMNS`].
    blocks: usize,
    /// Shape `BLOCK × blocks`.
    kicks: AVec<f64>,
}

impl Kicks {
    /// - `velocities`: the jump at each point of a grid with `step` between its points
    /// - `first`, `stride`: the points asked for are first, first + stride, …
    pub(super) fn new(step: f64, velocities: &[f64], first: usize, stride: usize) -> Self {
        let chunk = |(index, velocities): (usize, &[f64])| {
            let blocks = velocities.len().div_ceil(BLOCK).next_multiple_of(COLUMNS);
            let mut kicks = avec![0.0; BLOCK * blocks];
            for (block, velocities) in velocities.chunks(BLOCK).enumerate() {
                for (point, velocity) in velocities.iter().enumerate() {
                    kicks[point * blocks + block] = *velocity;
                }
            }
            Chunk { begin: index * BLOCKS * BLOCK, blocks, kicks }
        };
        Self { step, chunks: velocities.chunks(BLOCKS * BLOCK).enumerate().map(chunk).collect(), first, stride }
    }
}

/// Adds the sum of all answers to all kicks, at the points asked for, to each target; a kick counts from its own point on.
///
/// z ← e^(λB) z + Σ_r v_r e^(λ(B−r)) from block to block of B points; within one `Re(c e^(λs) z) + Σ_{r ≤ s} v_r h(s − r)`,
/// h the answer to a unit kick
///
/// Source:   the convolution sum of the kicks with h, cut into blocks.
/// Valid:    any λ with Re λ ≤ 0, any kicks.
/// Accuracy: 1e-12 of the peak beside the sum taken kick by kick (test); an exponential takes B times fewer products than steps one by one.
pub(super) fn add(answers: &[Answer], kicks: &Kicks, targets: &mut [Target<'_>]) {
    for answers in answers.chunks(TILE) {
        let most_blocks = kicks.chunks.first().map_or(0, |chunk| chunk.blocks);
        let mut tile = Tile::new(answers, kicks.step, most_blocks);
        for chunk in &kicks.chunks {
            tile.follow(chunk);
            tile.add_to(chunk, kicks, targets);
        }
    }
}

/// Some exponentials: their tables, and where the blocks so far have left them.
struct Tile {
    /// Rows of real and imaginary parts, rounded up to a multiple of [`ROWS`].
    rows: usize,
    /// What a kick at each point of a block leaves at its end, shape `BLOCK × rows`.
    remains: AVec<f64>,
    /// What each row at a block's begin, and each kick within it, gives at each of its points, shape `(rows + BLOCK) × BLOCK`.
    answers: AVec<f64>,
    /// e^(λB), and z now; padded to a multiple of [`ABREAST`].
    over_block: Vec<Complex64>,
    now: Vec<Complex64>,
    /// Every row at the begin of each block of a chunk, and below them the chunk's kicks; shape `(rows + BLOCK) × blocks`.
    begins: AVec<f64>,
}

impl Tile {
    fn new(answers: &[Answer], step: f64, most_blocks: usize) -> Self {
        // A multiple of what is carried abreast, two rows to each.
        let count = answers.len().next_multiple_of(ABREAST);
        let rows = (2 * count).next_multiple_of(ROWS);
        let mut tile = Self {
            rows,
            remains: avec![0.0; BLOCK * rows],
            answers: avec![0.0; (rows + BLOCK) * BLOCK],
            over_block: vec![Complex64::default(); count],
            now: vec![Complex64::default(); count],
            begins: avec![0.0; (rows + BLOCK) * most_blocks],
        };
        dispatch(Tabulate { tile: &mut tile, answers, step });
        tile
    }

    #[inline(always)]
    fn tabulate<const FUSED: bool>(&mut self, answers: &[Answer], step: f64) {
        let steps = Steps::new(0.0, step, BLOCK + 1);
        let mut direct = Exponentials::default();
        for answer in answers {
            steps.push(answer.root, &mut direct);
        }
        direct.evaluate::<FUSED>();
        let mut powers = Phasors::of(BLOCK + 1);
        let mut whole = [0.0; BLOCK];
        for (index, answer) in answers.iter().enumerate() {
            powers.powers(&direct, index * steps.count());
            self.over_block[index] = Complex64::new(powers.re[BLOCK], powers.im[BLOCK]);
            for (point, remains) in self.remains.chunks_exact_mut(self.rows).enumerate() {
                (remains[2 * index], remains[2 * index + 1]) = (powers.re[BLOCK - point], powers.im[BLOCK - point]);
            }
            let c = answer.coefficient;
            let (real, imaginary) = self.answers[2 * index * BLOCK..][..2 * BLOCK].split_at_mut(BLOCK);
            for point in 0..BLOCK {
                real[point] = c.re * powers.re[point] - c.im * powers.im[point];
                imaginary[point] = -(c.re * powers.im[point] + c.im * powers.re[point]);
                whole[point] += real[point];
            }
        }
        for (kicked, row) in self.answers[self.rows * BLOCK..].chunks_exact_mut(BLOCK).enumerate() {
            row[kicked..].copy_from_slice(&whole[..BLOCK - kicked]);
        }
    }

    /// Finds where each block of a chunk begins.
    fn follow(&mut self, chunk: &Chunk) {
        let blocks = chunk.blocks;
        let (begins, kicks) = self.begins[..(self.rows + BLOCK) * blocks].split_at_mut(self.rows * blocks);
        kicks.copy_from_slice(&chunk.kicks);
        for (first, sums) in begins.chunks_exact_mut(ROWS * blocks).enumerate() {
            let (rows, left) = (self.rows, &self.remains);
            dispatch(Panel { rows, first_row: first * ROWS, columns: blocks, left, right: kicks, sums });
        }
        dispatch(Carry { blocks, begins, over_block: &self.over_block, now: &mut self.now });
    }

    /// Adds a chunk's values where they are asked for.
    fn add_to(&self, chunk: &Chunk, kicks: &Kicks, targets: &mut [Target<'_>]) {
        let mut sums: AVec<f64> = avec![0.0; ROWS * BLOCK];
        let left = &self.begins[..(self.rows + BLOCK) * chunk.blocks];
        for first_row in (0..chunk.blocks).step_by(ROWS) {
            let begin = chunk.begin + first_row * BLOCK;
            if begin + ROWS * BLOCK <= kicks.first {
                continue;
            }
            let right = &self.answers;
            dispatch(Panel { rows: chunk.blocks, first_row, columns: BLOCK, left, right, sums: &mut sums });
            for target in &mut *targets {
                spread(&sums, begin, kicks, target);
            }
        }
    }
}

/// Adds values at the points from `begin` on to those samples of a target that stand for them.
fn spread(values: &[f64], begin: usize, kicks: &Kicks, target: &mut Target<'_>) {
    let sample = begin.saturating_sub(kicks.first).div_ceil(kicks.stride);
    let offset = kicks.first + sample * kicks.stride - begin;
    let (Some(samples), Some(values)) = (target.values.get_mut(sample..), values.get(offset..)) else {
        return; // behind the last sample, or between two
    };
    let sign = target.sign;
    if kicks.stride == 1 {
        samples.iter_mut().zip(values).for_each(|(sample, value)| *sample += sign * value);
    } else {
        samples.iter_mut().zip(values.iter().step_by(kicks.stride)).for_each(|(sample, value)| *sample += sign * value);
    }
}

/// Fills a tile's tables.
struct Tabulate<'a> {
    tile: &'a mut Tile,
    answers: &'a [Answer],
    step: f64,
}

impl WithSimd for Tabulate<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        if S::IS_SCALAR {
            self.tile.tabulate::<false>(self.answers, self.step);
        } else {
            self.tile.tabulate::<true>(self.answers, self.step);
        }
    }
}

/// Turns what each block leaves of its own kicks into where each block begins.
struct Carry<'a> {
    blocks: usize,
    /// Shape `rows × blocks`.
    begins: &'a mut [f64],
    over_block: &'a [Complex64],
    now: &'a mut [Complex64],
}

impl WithSimd for Carry<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let each = self.over_block.as_chunks::<ABREAST>().0.iter().zip(self.now.as_chunks_mut::<ABREAST>().0);
        for ((turns, now), begins) in each.zip(self.begins.chunks_exact_mut(2 * ABREAST * self.blocks)) {
            for block in 0..self.blocks {
                for (mode, (turn, now)) in turns.iter().zip(&mut *now).enumerate() {
                    let (re, im) = (2 * mode * self.blocks + block, (2 * mode + 1) * self.blocks + block);
                    let left = Complex64::new(begins[re], begins[im]);
                    (begins[re], begins[im]) = (now.re, now.im);
                    *now = turn * *now + left;
                }
            }
        }
    }
}
