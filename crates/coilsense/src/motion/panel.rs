//! A small matrix product, in the processor's vector instructions: the inner loop of many times at once.
//!
//! Next door: what is multiplied (`phasor_sum`).

use pulp::{Simd, WithSimd};

/// Rows of `left` and columns of `right` come in multiples of these: what the inner loop holds in registers at once.
pub(super) const ROWS: usize = 4;
pub(super) const COLUMNS: usize = 16;

/// `sums[p][q] = Σ_k left[k][first_row + p] right[k][q]` for [`ROWS`] rows.
pub(super) struct Panel<'a> {
    /// How many rows `left` has, a multiple of [`ROWS`].
    pub rows: usize,
    /// The first of those that are processed.
    pub first_row: usize,
    /// How many columns `right` has, a multiple of [`COLUMNS`].
    pub columns: usize,
    /// Shape `K × rows`.
    pub left: &'a [f64],
    /// Shape `K × columns`.
    pub right: &'a [f64],
    /// Shape `ROWS × columns`.
    pub sums: &'a mut [f64],
}

impl WithSimd for Panel<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let width = self.columns / S::F64_LANES;
        let (right, _) = S::as_simd_f64s(self.right);
        let (sums, _) = S::as_mut_simd_f64s(self.sums);
        for column in (0..width).step_by(2) {
            let mut tile = [[simd.splat_f64s(0.0); 2]; ROWS];
            for (left, right) in self.left.chunks_exact(self.rows).zip(right.chunks_exact(width)) {
                let left = &left[self.first_row..self.first_row + ROWS];
                let right = [right[column], right[column + 1]];
                for (sums, &factor) in tile.iter_mut().zip(left) {
                    let factor = simd.splat_f64s(factor);
                    sums[0] = simd.mul_add_e_f64s(factor, right[0], sums[0]);
                    sums[1] = simd.mul_add_e_f64s(factor, right[1], sums[1]);
                }
            }
            for (sums, tile) in sums.chunks_exact_mut(width).zip(tile) {
                sums[column] = tile[0];
                sums[column + 1] = tile[1];
            }
        }
    }
}

/// Adds even and odd sums to the samples that they stand for, a row to a block: `even ± odd` to each pair about the block's middle,
/// or the even ones alone.
pub(super) struct Unfold<'a> {
    /// Shape `ROWS × columns` each.
    pub sums: [&'a [f64]; 2],
    pub columns: usize,
    pub paired: bool,
    pub sign: f64,
    /// The samples of the blocks; the last block may be cut short.
    pub values: &'a mut [f64],
}

impl WithSimd for Unfold<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        // Plain loops: the compiler turns them into the vectors that are allowed here.
        let (columns, sign) = (self.columns, self.sign);
        let width = if self.paired { 2 * columns } else { columns };
        let rows = self.sums[0].chunks_exact(columns).zip(self.sums[1].chunks_exact(columns));
        for (values, (even, odd)) in self.values.chunks_mut(width).zip(rows) {
            if !self.paired {
                for (value, even) in values.iter_mut().zip(even) {
                    *value += sign * even;
                }
                continue;
            }
            let (before, after) = values.split_at_mut(columns.min(values.len()));
            // A block may end before its middle: then its pairs begin further out.
            let missing = columns - before.len();
            for ((value, even), odd) in before.iter_mut().rev().zip(&even[missing..]).zip(&odd[missing..]) {
                *value += sign * (even - odd);
            }
            for ((value, even), odd) in after.iter_mut().zip(even).zip(odd) {
                *value += sign * (even + odd);
            }
        }
    }
}

/// How many of some times are within `tolerance` of equidistant ones, `first + k step`; NaN is not.
pub(super) struct CountOn<'a> {
    pub times: &'a [f64],
    pub first: f64,
    pub step: f64,
    pub tolerance: f64,
}

impl WithSimd for CountOn<'_> {
    type Output = u64;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> u64 {
        let mut on = [0_u64; COLUMNS];
        let mut begin = 0.0;
        let chunks = self.times.chunks_exact(COLUMNS);
        let rest = chunks.remainder();
        for times in chunks {
            for (k, (on, time)) in on.iter_mut().zip(times).enumerate() {
                let expected = self.first + (begin + k as f64) * self.step;
                *on += u64::from((time - expected).abs() <= self.tolerance);
            }
            begin += COLUMNS as f64;
        }
        for (k, time) in rest.iter().enumerate() {
            let expected = self.first + (begin + k as f64) * self.step;
            on[0] += u64::from((time - expected).abs() <= self.tolerance);
        }
        on.iter().sum()
    }
}
