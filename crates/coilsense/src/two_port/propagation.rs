//! The undamped spring in closed form, at a phase that damping makes complex.
//!
//! Next door: which phase belongs to which damping (`super::TwoPort`), and sums over modes where no such phase exists (`modal`).

use std::f64::consts::FRAC_1_SQRT_2;

use num_complex::Complex64;

use super::trigonometry::{arcsine, cosecant, cotangent_deficit, quotient, tangent};

/// How much of the spring's mass its ends feel, and the force that runs through; all dimensionless.
///
/// Moved together (U1 = U2 = U) the ends need p U with p = k_d − k_t = −m ω² μ; moved apart, q U with
/// q = k_d + k_t = 2K − m ω² ν. At rest μ = 1/2 and ν = (1 − 1/N²)/6.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Inertia {
    /// μ
    pub together: Complex64,
    /// ν
    pub apart: Complex64,
}

/// The closed form at one phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Propagation {
    pub inertia: Inertia,
    /// k_t/k, which keeps its relative accuracy where it decays above cut-off; `None` where |φ| < 1 and 1 + z² (μ − ν)/2 is better.
    pub transfer: Option<Complex64>,
}

/// The chain at phase z.
///
/// sin y = z/2N, φ = Ny: p/k = −2N tan y tan φ, q/k = 2N tan y cot φ, k_t/k = 2N tan y / sin 2φ; θ = 2y
///
/// - `masses`: N; `phase`: z = ω̃τ, Re z ≥ 0
///
/// Source:   x_i = A cos((i−½)θ) + B sin((i−½)θ) in `[Weijde2017]` eqs. 5–7, half a segment at each end.
/// Valid:    below and above cut-off (z = 2N).
/// Accuracy: rounding of φ, so 1e-16 |φ| relative away from poles and zeros; 1e-15 for |φ| < 1.
pub(super) fn chain(masses: usize, phase: Complex64) -> Propagation {
    let count = masses as f64;
    let sine = phase / (2.0 * count);
    if sine.re > FRAC_1_SQRT_2 {
        return beside_cut_off(masses, phase, arcsine(((1.0 - sine) * (1.0 + sine)).sqrt()));
    }
    let half = arcsine(sine);
    if (count * half).norm() < 1.0 {
        let stretch = if sine.norm_sqr() == 0.0 { Complex64::ONE } else { half / sine };
        return slow(count * half, half, (count * count).recip(), stretch * stretch);
    }
    let (short, long) = (tangent(half), tangent(count * half));
    let forces = Forces {
        together: 2.0 * count * short * long,
        apart: 2.0 * count * quotient(short, long),
        transfer: 2.0 * count * short * cosecant(2.0 * count * half),
    };
    forces.over(phase)
}

/// The wave at phase z: p/k = −z tan(z/2), q/k = z cot(z/2), k_t/k = z / sin z.
///
/// Source:   the limit N → ∞ of [`chain`]. Valid: Re z ≥ 0. Accuracy: as [`chain`].
pub(super) fn wave(phase: Complex64) -> Propagation {
    let half = 0.5 * phase;
    if half.norm() < 1.0 {
        return slow(half, Complex64::ZERO, 0.0, Complex64::ONE);
    }
    let long = tangent(half);
    let forces = Forces { together: phase * long, apart: quotient(phase, long), transfer: phase * cosecant(phase) };
    forces.over(phase)
}

/// −p/k, q/k and k_t/k.
struct Forces {
    together: Complex64,
    apart: Complex64,
    transfer: Complex64,
}

impl Forces {
    /// As inertia.
    fn over(&self, phase: Complex64) -> Propagation {
        let square = phase * phase;
        Propagation {
            inertia: Inertia { together: quotient(self.together, square), apart: quotient(2.0 - self.apart, square) },
            transfer: Some(self.transfer),
        }
    }
}

/// The chain near and above cut-off, by ε = π/2 − y: tan y = cot ε; tan φ = cot Nε for odd N, −tan Nε for even N.
fn beside_cut_off(masses: usize, phase: Complex64, rest: Complex64) -> Propagation {
    let count = masses as f64;
    let (short, long) = (tangent(rest), tangent(count * rest));
    // tan Nε / tan ε, and what is infinite at cut-off itself.
    let ratio = if short.norm() == 0.0 { Complex64::from(count) } else { quotient(long, short) };
    let pole = quotient(Complex64::ONE, short * long);
    let through = quotient(cosecant(2.0 * count * rest), short);
    let scale = 2.0 * count;
    let forces = if masses.is_multiple_of(2) {
        Forces { together: -scale * ratio, apart: -scale * pole, transfer: -scale * through }
    } else {
        Forces { together: scale * pole, apart: scale * ratio, transfer: scale * through }
    };
    forces.over(phase)
}

/// Where φ is small: c(x) = 1 − x cot x without cancellation, so that μ, ν keep their relative accuracy down to ω = 0.
///
/// μ = ½ (y/sin y)² / ((1 − c(φ)) (1 − c(y))), ν = ½ (y/sin y)² (c(φ)/φ² − c(y)/φ²) / (1 − c(y))
///
/// - `long`: φ; `short`: y, zero for the wave; `spread`: 1/N²; `stretch`: (y/sin y)²
fn slow(long: Complex64, short: Complex64, spread: f64, stretch: Complex64) -> Propagation {
    let (long_square, short_square) = (long * long, short * short);
    let (long_deficit, short_deficit) = (cotangent_deficit(long_square), cotangent_deficit(short_square));
    let short_rest = 1.0 - short_square * short_deficit;
    let together = 0.5 * stretch / ((1.0 - long_square * long_deficit) * short_rest);
    let apart = 0.5 * stretch * (long_deficit - spread * short_deficit) / short_rest;
    Propagation { inertia: Inertia { together, apart }, transfer: None }
}
