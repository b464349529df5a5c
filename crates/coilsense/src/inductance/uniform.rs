//! Maxwell's sum over uniform turns, for many pitches at once.
//!
//! Next door: one pair (`reduced`), turns anywhere (`pairs`), what the sum means (`maxwell`).

use super::reduced;
use crate::simd;

/// Σ_{i<j} y³ D(c) of uniform turns, for each pitch \[m\]; shape `pitches`.
///
/// - `turns`: how many; `radius`: r \[m\]
pub(super) fn sums(turns: usize, radius: f64, pitches: &[f64]) -> Vec<f64> {
    let mut sums = vec![0.0; pitches.len()];
    let mut ratios = vec![0.0; turns.saturating_sub(1)];
    for (sum, pitch) in sums.iter_mut().zip(pitches) {
        // Farthest first: what is small is added up before it meets what is large.
        for (ratio, apart) in ratios.iter_mut().zip((1..turns).rev()) {
            *ratio = apart as f64 * pitch / radius;
        }
        *sum = simd::dispatch(Weighted { ratios: &mut ratios });
    }
    sums
}

/// Partial sums: as many as the widest path has numbers in a vector, on every path.
const LANES: usize = 8;

/// Σ n F of the n-th of some ratios.
struct Weighted<'a> {
    ratios: &'a mut [f64],
}

impl Weighted<'_> {
    #[inline(always)]
    fn total<const FUSED: bool>(self) -> f64 {
        for ratio in self.ratios.iter_mut() {
            *ratio = reduced::mutual::<FUSED>(*ratio);
        }
        let mut lanes = [0.0; LANES];
        for (index, value) in self.ratios.iter().enumerate() {
            lanes[index % LANES] += (index + 1) as f64 * value;
        }
        lanes.iter().sum()
    }
}

impl pulp::WithSimd for Weighted<'_> {
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> f64 {
        if S::IS_SCALAR { self.total::<false>() } else { self.total::<true>() }
    }
}
