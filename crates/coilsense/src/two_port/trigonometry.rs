//! Complex circular functions that neither overflow nor cancel where the two-port needs them.
//!
//! Next door: the formulas made of them (`propagation`).

use num_complex::Complex64;

/// arcsin z, principal value.
///
/// Re = arctan(Re z / Re(√(1−z) √(1+z))), Im = arsinh(Im(conj √(1−z) √(1+z)))
///
/// Source:   `[Kahan1987]`. Accuracy: 1e-15 relative for |z| up to about 1; the textbook logarithm loses a small imaginary part.
pub(super) fn arcsine(z: Complex64) -> Complex64 {
    let (below, above) = ((1.0 - z).sqrt(), (1.0 + z).sqrt());
    Complex64::new(z.re.atan2((below * above).re), (below.conj() * above).im.asinh())
}

/// tan z = (t + jT) / (1 − j t T) with t = tan(Re z), T = tanh(Im z).
///
/// Source:   the sum of arguments. Accuracy: 1e-15 relative in each part, whatever Im z.
pub(super) fn tangent(z: Complex64) -> Complex64 {
    let (circular, hyperbolic) = (z.re.tan(), z.im.tanh());
    let falling = z.im.cosh().recip();
    let scale = 1.0 + (circular * hyperbolic).powi(2);
    Complex64::new(circular * falling * falling / scale, hyperbolic * (1.0 + circular * circular) / scale)
}

/// 1 / sin z, falling to zero as 2 e^(−|Im z|).
///
/// Source:   the sum of arguments, e^|Im z| taken out. Accuracy: 1e-15 relative.
pub(super) fn cosecant(z: Complex64) -> Complex64 {
    let height = z.im.abs();
    let fall = (-2.0 * height).exp();
    let scaled = Complex64::new(
        0.5 * z.re.sin() * (1.0 + fall),
        -0.5 * z.re.cos() * (-2.0 * height).exp_m1() * 1.0_f64.copysign(z.im),
    );
    quotient(Complex64::from((-height).exp()), scaled)
}

/// (1 − x cot x) / x² = 1 / (3 − x² / (5 − x² / (7 − …))), no cancellation.
///
/// - `square`: x², |x| at most about 1
///
/// Source:   `[DLMF]` 4.25.1. Accuracy: 2e-16 relative for |x| ≤ 1.
pub(super) fn cotangent_deficit(square: Complex64) -> Complex64 {
    (1..=LEVELS).rev().fold(Complex64::ZERO, |tail, level| (2.0 * f64::from(level) + 1.0 - square * tail).inv())
}

/// Levels of the continued fraction; each takes the error down by x²/4n², 10 are enough at |x| = 1.
const LEVELS: u8 = 12;

/// a / b without overflow inside; real and infinite where b is zero or a is infinite, zero where b alone is infinite.
pub(super) fn quotient(a: Complex64, b: Complex64) -> Complex64 {
    let size = b.re.abs().max(b.im.abs());
    if size == 0.0 || a.re.is_infinite() || a.im.is_infinite() {
        return Complex64::from(f64::INFINITY);
    }
    if size == f64::INFINITY {
        return Complex64::ZERO;
    }
    let unit = b / size;
    a * unit.conj() / unit.norm_sqr() / size
}
