//! The sum over all pairs of turns, in vectors.
//!
//! Next door: one pair (`reduced`), what the sum means (`maxwell`).

use super::reduced;
use crate::simd;

/// Distances that are gathered before they are evaluated: all pairs of 64 turns, a small part of the first-level cache.
const BLOCK: usize = 2048;
/// Partial sums: as many as the widest path has numbers in a vector, on every path, so that the order of the sum is one.
const LANES: usize = 8;
/// Blocks are filled up to a multiple of this, so that no vector loop has a remainder.
const PADDING: usize = 32;

/// Σ_{i<j} y³ D(c) over all pairs of turns: Maxwell's sum but for the factor 2 μ₀ r.
///
/// - `radius`: r \[m\]; `turns`: positions \[m\], in any order
pub(super) fn sum(radius: f64, turns: &[f64]) -> f64 {
    simd::dispatch(PairSum { per_radius: 1.0 / radius, turns })
}

/// One call of [`sum`].
struct PairSum<'a> {
    per_radius: f64,
    turns: &'a [f64],
}

impl PairSum<'_> {
    #[inline(always)]
    fn total<const FUSED: bool>(self) -> f64 {
        let mut block = [0.0; BLOCK];
        let mut filled = 0;
        let mut lanes = [0.0; LANES];
        for apart in 1..self.turns.len() {
            let mut pairs = (&self.turns[apart..], self.turns);
            while !pairs.0.is_empty() {
                let taken = pairs.0.len().min(BLOCK - filled);
                for ((slot, far), near) in block[filled..filled + taken].iter_mut().zip(pairs.0).zip(pairs.1) {
                    *slot = (far - near) * self.per_radius;
                }
                pairs = (&pairs.0[taken..], &pairs.1[taken..]);
                filled += taken;
                if filled == BLOCK {
                    add::<FUSED>(&mut block, &mut lanes);
                    filled = 0;
                }
            }
        }
        let padded = filled.next_multiple_of(PADDING);
        block[filled..padded].fill(f64::INFINITY);
        add::<FUSED>(&mut block[..padded], &mut lanes);
        lanes.iter().sum()
    }
}

/// Adds F of every distance of a block, whose length is a multiple of [`PADDING`]. Leaves the block's contents undefined.
#[inline(always)]
fn add<const FUSED: bool>(block: &mut [f64], lanes: &mut [f64; LANES]) {
    for value in block.iter_mut() {
        *value = reduced::mutual::<FUSED>(*value);
    }
    for chunk in block.chunks_exact(LANES) {
        for (lane, value) in lanes.iter_mut().zip(chunk) {
            *lane += value;
        }
    }
}

impl pulp::WithSimd for PairSum<'_> {
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> f64 {
        if S::IS_SCALAR { self.total::<false>() } else { self.total::<true>() }
    }
}
