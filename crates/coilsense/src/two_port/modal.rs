//! Inertia of the two-port as a sum over modes, where each mode has a damping ratio of its own and no single phase exists.
//!
//! Next door: the closed forms (`propagation`).

use std::f64::consts::PI;

use num_complex::Complex64;

use super::propagation::Inertia;
use super::trigonometry::quotient;

/// One mode of the chain: ω_j τ \[1\] and ζ_j \[1\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mode {
    pub frequency: f64,
    pub ratio: f64,
}

/// The chain's modes, j = 1…N: ω_j τ = 2N sin(jπ/2N).
pub(super) fn chain_frequencies(masses: usize) -> Vec<f64> {
    let count = masses as f64;
    (1..=masses).map(|mode| 2.0 * count * (0.5 * PI * mode as f64 / count).sin()).collect()
}

/// μ, ν of the chain at ωτ, a sum over all its modes.
///
/// μ = Σ_{j odd} (2N/n_j) / ((ω_j² − ω²) τ² + 2j ζ_j ω_j ω τ²), ν the same over even j; n_j = N/2, N for j = N
///
/// Source:   modal coordinates of `[Weijde2017]` eqs. 5–7 about the straight line between the ends.
/// Valid:    all frequencies; N terms.
/// Accuracy: 1e-15 relative away from zeros.
pub(super) fn chain(modes: &[Mode], phase: f64) -> Inertia {
    let mut sums = [Complex64::ZERO; 2];
    for (index, mode) in modes.iter().enumerate().rev() {
        let weight = if index + 1 == modes.len() { 2.0 } else { 4.0 };
        sums[index % 2] += quotient(Complex64::from(weight), detuning(mode.frequency, mode.ratio, phase));
    }
    Inertia { together: sums[0], apart: sums[1] }
}

/// (ω_j² − ω² + 2j ζ ω_j ω) τ².
fn detuning(frequency: f64, ratio: f64, phase: f64) -> Complex64 {
    Complex64::new((frequency - phase) * (frequency + phase), 2.0 * ratio * frequency * phase)
}

/// μ, ν of the wave at ωτ, over all its modes without end.
///
/// μ = Σ_{j odd} 4 / (j²π² − (ωτ)² + 2j ζ_j jπ ωτ), ν the same over even j
///
/// - `ratios`: ζ_j of the first modes; those past the last take the last one's. Not empty
///
/// Source:   the limit N → ∞ of [`chain`]; the rest past the given modes by [`pole_pair_sum`].
/// Valid:    all frequencies.
/// Accuracy: 1e-15 relative away from zeros.
pub(super) fn wave(ratios: &[f64], phase: f64) -> Inertia {
    let mut sums = [Complex64::ZERO; 2];
    for (index, &ratio) in ratios.iter().enumerate().rev() {
        let frequency = PI * (index + 1) as f64;
        sums[index % 2] += quotient(Complex64::from(4.0), detuning(frequency, ratio, phase));
    }
    let listed = ratios.len();
    let (a, b) = poles(ratios.last().copied().unwrap_or_default(), phase / PI);
    let scale = (PI * PI).recip();
    // Odd j = 2i − 1 and even j = 2i: the poles move, the sum over i stays the same.
    let odd = pole_pair_sum(listed.div_ceil(2) + 1, 0.5 * (a + 1.0), 0.5 * (b + 1.0));
    let even = pole_pair_sum(listed / 2 + 1, 0.5 * a, 0.5 * b);
    Inertia { together: sums[0] + scale * odd, apart: sums[1] + scale * even }
}

/// The zeros a, b of n² + 2jζxn − x²: x (−jζ ± √(1 − ζ²)), Re a ≥ 0 ≥ Re b.
fn poles(ratio: f64, x: f64) -> (Complex64, Complex64) {
    if ratio <= 1.0 {
        let (real, imaginary) = (x * ((1.0 - ratio) * (1.0 + ratio)).sqrt(), -x * ratio);
        return (Complex64::new(real, imaginary), Complex64::new(-real, imaginary));
    }
    let sum = ratio + ((ratio - 1.0) * (ratio + 1.0)).sqrt();
    (Complex64::new(0.0, -x / sum), Complex64::new(0.0, -x * sum))
}

/// Distance from the poles at which the Euler–Maclaurin terms below reach 1e-17.
const CLEAR: f64 = 12.0;

/// Σ_{n=first}^∞ 1 / ((n − a)(n − b)).
///
/// Terms near the poles one by one, those before and after by the Euler–Maclaurin formula: at most about 50 terms wherever the
/// poles are. A difference of digamma functions is the same sum but cancels where a and b are close.
///
/// Source:   `[DLMF]` 2.10.1. Valid: Re b ≤ 1/2, Im a, Im b ≤ 0. Accuracy: 1e-15 relative to the sum of magnitudes.
fn pole_pair_sum(first: usize, a: Complex64, b: Complex64) -> Complex64 {
    let first = first as f64;
    let near = (a.re.floor() - CLEAR).max(first);
    let far = (a.re.floor() + CLEAR + 1.0).max(CLEAR + 2.0).max(near);
    let mut sum = integral_to_infinity(far, a, b) + correction(far, a, b);
    for step in (0..(far - near) as usize).rev() {
        let n = near + step as f64;
        sum += quotient(Complex64::ONE, (n - a) * (n - b));
    }
    if near > first {
        sum += integral(first, near, a, b) + correction(first, a, b) - correction(near, a, b);
    }
    sum
}

/// ∫ dn / ((n − a)(n − b)) from `from` to `to`, both on the same side of the poles' real parts.
fn integral(from: f64, to: f64, a: Complex64, b: Complex64) -> Complex64 {
    (((to - a) / (from - a)).ln() - ((to - b) / (from - b)).ln()) / (a - b)
}

/// The same to infinity, also where a and b are close or equal.
fn integral_to_infinity(from: f64, a: Complex64, b: Complex64) -> Complex64 {
    let to_a = (from - a).inv();
    let gap = (a - b) * to_a;
    if gap.norm() > 0.25 {
        return ((from - b) * to_a).ln() / gap * to_a;
    }
    // ln(1 + w)/w = 2/(2 + w) Σ s^i/(2i + 1), s = (w/(2 + w))²; |s| ≤ 1/49.
    let square = (gap / (2.0 + gap)).powi(2);
    let series = (0..12_u8).rev().fold(Complex64::ZERO, |tail, i| tail * square + (2.0 * f64::from(i) + 1.0).recip());
    2.0 / (2.0 + gap) * series * to_a
}

/// B_2k / 2k for k = 1…8, B the Bernoulli numbers (`[DLMF]` 24.2).
const BERNOULLI: [f64; 8] =
    [1.0 / 12.0, -1.0 / 120.0, 1.0 / 252.0, -1.0 / 240.0, 1.0 / 132.0, -691.0 / 32760.0, 1.0 / 12.0, -3617.0 / 8160.0];

/// f/2 − Σ B_2k/(2k)! f^(2k−1) at n, with f^(r) = (−1)^r r! Σ_i u^(1+i) v^(1+r−i), u = 1/(n − a), v = 1/(n − b).
fn correction(n: f64, a: Complex64, b: Complex64) -> Complex64 {
    let (u, v) = ((n - a).inv(), (n - b).inv());
    let mut power = Complex64::ONE;
    let mut mixed = Complex64::ONE;
    let mut sum = Complex64::from(0.5);
    for bernoulli in BERNOULLI {
        power *= u;
        mixed = mixed * v + power; // of odd order 2k − 1
        sum += bernoulli * mixed;
        power *= u;
        mixed = mixed * v + power;
    }
    u * v * sum
}
