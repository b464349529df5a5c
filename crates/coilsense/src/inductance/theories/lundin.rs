//! The current sheet by a handbook formula.
//!
//! Next door: the same without an approximation (`nagaoka`).

use std::f64::consts::PI;

use super::Coil;
use super::ideal::ideal_solenoid;
use crate::inductance::MU_0;

/// Inductance of a coil as a current sheet \[H\], by two rational functions.
///
/// - l ≥ d: L = μ₀ N² π r²/l (f₁(d²/l²) − 4d/(3πl)); l < d: L = μ₀ N² r ((ln(4d/l) − ½) f₁(l²/d²) + f₂(l²/d²)), d = 2r
/// - f₁(x) = (1 + 0.383901x + 0.017108x²)/(1 + 0.258952x), f₂(x) = 0.093842x + 0.002029x² − 0.000801x³
///
/// - `length`: l \[m\], above zero
///
/// Source:   `[Lundin1985]`.
/// Valid:    as [`super::nagaoka()`].
/// Accuracy: within 3e-6 relative of Nagaoka's over l/d = 1e-6…1e6, as the source states.
///
/// ```
/// use coilsense::inductance::theories::{Coil, lundin, nagaoka};
/// let coil = Coil::new(10.0, 0.01, 0.001)?;
/// assert!((lundin(&coil, 0.03) / nagaoka(&coil, 0.03) - 1.0).abs() < 3e-6);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn lundin(coil: &Coil, length: f64) -> f64 {
    let ratio = length / (2.0 * coil.coil_radius());
    if ratio >= 1.0 {
        let x = 1.0 / ratio;
        return ideal_solenoid(coil, length) * (f1(x * x) - 4.0 * x / (3.0 * PI));
    }
    let x = ratio * ratio;
    let f2 = x * (0.093842 + x * (0.002029 - 0.000801 * x));
    let windings = coil.windings();
    MU_0 * windings * windings * coil.coil_radius() * (((4.0 / ratio).ln() - 0.5) * f1(x) + f2)
}

fn f1(x: f64) -> f64 {
    (1.0 + x * (0.383901 + 0.017108 * x)) / (1.0 + 0.258952 * x)
}
