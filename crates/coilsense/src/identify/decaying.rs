//! Decaying cosines and sines, sample after sample: what a line of a ring-down is made of.
//!
//! Next door: who fits them (`ring_down`, `weak_lines`).

use nalgebra::DMatrix;
use num_complex::Complex;

/// After so many products the next value is computed anew, before rounding adds up.
const ANEW: usize = 32;

/// e^(−σn) cos ωn and e^(−σn) sin ωn of each (σ, ω) \[per sample\], two columns a pole, shape `samples` of `2 poles`.
///
/// Accuracy: 1e-14, by the test below.
pub(super) fn decaying_pairs(poles: &[(f64, f64)], samples: usize) -> DMatrix<f64> {
    let mut shapes = DMatrix::zeros(samples, 2 * poles.len());
    for (index, &(decay, angular)) in poles.iter().enumerate() {
        let at = |sample: usize| Complex::from_polar((-decay * sample as f64).exp(), angular * sample as f64);
        let (turn, mut value) = (at(1), at(0));
        let (mut cosines, mut sines) = shapes.columns_range_pair_mut(2 * index, 2 * index + 1);
        for (sample, (cosine, sine)) in cosines.iter_mut().zip(sines.iter_mut()).enumerate() {
            if sample % ANEW == 0 {
                value = at(sample);
            }
            (*cosine, *sine) = (value.re, value.im);
            value *= turn;
        }
    }
    shapes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sample_is_that_of_its_own_formula() {
        let poles = [(1e-4, 0.037), (0.3, 3.1), (0.0, 1.0)];
        let shapes = decaying_pairs(&poles, 20_001);
        for (index, (decay, angular)) in poles.into_iter().enumerate() {
            for sample in [0, 1, 31, 32, 33, 63, 64, 19_999, 20_000] {
                let n = sample as f64;
                let size = (-decay * n).exp();
                assert!((shapes[(sample, 2 * index)] - size * (angular * n).cos()).abs() < 1e-14);
                assert!((shapes[(sample, 2 * index + 1)] - size * (angular * n).sin()).abs() < 1e-14);
            }
        }
    }
}
