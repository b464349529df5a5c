//! Σ_i (δ_{i+a} − δ_i)² of many samples, for each number of turns apart: what the second-order form and its bound are made of.
//!
//! Next door: the form (`near_uniform`), samples about pitches of their own (`quadratic`).

use pulp::{Simd, WithSimd};

use super::turn_block::{Columns, TurnBlock};
use crate::motion::WIDTH;
use crate::simd::dispatch;

/// Vectors that are processed together, so that no sum waits for itself.
const VECTORS: usize = 8;

/// Fills `squares`, which begins with turns next to each other, as far as it goes.
pub(super) fn fill(block: &TurnBlock, squares: &mut [Columns]) {
    dispatch(Fill { block, squares });
}

/// One call of [`fill`].
struct Fill<'a> {
    block: &'a TurnBlock,
    squares: &'a mut [Columns],
}

impl WithSimd for Fill<'_> {
    type Output = ();

    // Taken apart, Σ δ_i² + Σ δ_{i+a}² − 2 Σ δ_i δ_{i+a} is half of the arithmetic but as many loads, and took longer.
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let turns = self.block.turns();
        let width = WIDTH / S::F64_LANES;
        let (displacements, _) = S::as_simd_f64s(&self.block.displacements);
        for (lag, squares) in (1..turns).zip(self.squares) {
            let (vectors, _) = S::as_mut_simd_f64s(squares);
            for (chunk, vectors) in vectors.chunks_exact_mut(VECTORS).enumerate() {
                let mut sums = [simd.splat_f64s(0.0); VECTORS];
                for turn in 0..turns - lag {
                    let near = &displacements[turn * width + VECTORS * chunk..][..VECTORS];
                    let far = &displacements[(turn + lag) * width + VECTORS * chunk..][..VECTORS];
                    for vector in 0..VECTORS {
                        let change = simd.sub_f64s(far[vector], near[vector]);
                        sums[vector] = simd.mul_add_e_f64s(change, change, sums[vector]);
                    }
                }
                vectors.copy_from_slice(&sums);
            }
        }
    }
}
