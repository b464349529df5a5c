//! The quadratic form of several samples at once, one sample to a lane.
//!
//! Next door: its coefficients (`expansion`), its bound (`second_order`).

use super::expansion::{Expansion, LANES, Lanes};
use crate::simd;

/// Samples near uniform turns.
pub(super) struct Samples<'a> {
    /// What they are near to.
    pub(super) expansion: &'a Expansion,
    /// δ \[m\], by turn.
    pub(super) displacements: &'a [Lanes],
}

/// What becomes of each sample.
pub(super) struct Forms {
    /// gᵀδ + ½ δᵀHδ \[H\].
    pub(super) change: Lanes,
    /// Σ_a ⅓ |M‴(ap)| ap Σ_i e² \[H\] over pairs a apart, e the change of their distance.
    pub(super) remainder: Lanes,
    /// The largest |e| of neighbours \[m\].
    pub(super) largest: Lanes,
}

impl Samples<'_> {
    pub(super) fn forms(self) -> Forms {
        simd::dispatch(self)
    }

    #[inline(always)]
    fn evaluate<const FUSED: bool>(&self) -> Forms {
        let add_product = |sum: &mut Lanes, a: &Lanes, b: &Lanes| {
            for lane in 0..LANES {
                sum[lane] = if FUSED { a[lane].mul_add(b[lane], sum[lane]) } else { sum[lane] + a[lane] * b[lane] };
            }
        };
        let (mut change, mut remainder) = ([0.0; LANES], [0.0; LANES]);
        for (gradient, displacement) in self.expansion.gradient.iter().zip(self.displacements) {
            add_product(&mut change, gradient, displacement);
        }
        for (lag, (curvature, third)) in self.expansion.curvatures.iter().zip(&self.expansion.remainders).enumerate() {
            let squares = squares::<FUSED>(self.displacements, lag + 1);
            add_product(&mut change, curvature, &squares);
            add_product(&mut remainder, third, &squares);
        }
        Forms { change, remainder, largest: self.largest() }
    }

    #[inline(always)]
    fn largest(&self) -> Lanes {
        let mut largest = [0.0; LANES];
        for (far, near) in self.displacements.iter().skip(1).zip(self.displacements) {
            for lane in 0..LANES {
                let change = (far[lane] - near[lane]).abs();
                // Kept where it is not a number, too: the bound is then none.
                largest[lane] = if change <= largest[lane] { largest[lane] } else { change };
            }
        }
        largest
    }
}

/// Σ_i (δ_{i+a} − δ_i)² for turns a apart, in four sums that do not wait for each other.
#[inline(always)]
fn squares<const FUSED: bool>(displacements: &[Lanes], apart: usize) -> Lanes {
    let mut sums = [[0.0; LANES]; 4];
    let square = |sum: &mut Lanes, far: &Lanes, near: &Lanes| {
        for lane in 0..LANES {
            let e = far[lane] - near[lane];
            sum[lane] = if FUSED { e.mul_add(e, sum[lane]) } else { sum[lane] + e * e };
        }
    };
    let (far, near) = (&displacements[apart..], &displacements[..displacements.len() - apart]);
    let (far, near) = (far.chunks_exact(4), near.chunks_exact(4));
    for (far, near) in far.remainder().iter().zip(near.remainder()) {
        square(&mut sums[0], far, near);
    }
    for (far, near) in far.zip(near) {
        for index in 0..4 {
            square(&mut sums[index], &far[index], &near[index]);
        }
    }
    std::array::from_fn(|lane| (sums[0][lane] + sums[1][lane]) + (sums[2][lane] + sums[3][lane]))
}

impl pulp::WithSimd for Samples<'_> {
    type Output = Forms;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Forms {
        if S::IS_SCALAR { self.evaluate::<false>() } else { self.evaluate::<true>() }
    }
}
