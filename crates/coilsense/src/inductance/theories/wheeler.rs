//! Wheeler's two formulas for a pocket calculator.
//!
//! Next door: what they approximate (`nagaoka`).

use std::f64::consts::PI;

use super::Coil;
use crate::inductance::MU_0;

/// Inductance of a long coil \[H\] by Wheeler's formula of 1928.
///
/// L = 10⁻⁶ r² N² / (9r + 10l) with lengths in inches, so L = (10⁻⁶/0.0254) r² N² / (9r + 10l) in metres
///
/// - `length`: l \[m\], above zero
///
/// Source:   `[Wheeler1928]`.
/// Valid:    l > 0.8 r.
/// Accuracy: from −0.6 to +0.05 % of Nagaoka's wherever l > 0.8 r; −0.28 % at l → ∞.
/// Differs:  often cited as μ₀ π r² N² / (l + 0.9 r), which is 0.28 % higher.
///
/// ```
/// use coilsense::inductance::theories::{Coil, nagaoka, wheeler_1928};
/// let coil = Coil::new(10.0, 0.01, 0.001)?;
/// assert!((wheeler_1928(&coil, 0.03) / nagaoka(&coil, 0.03) - 1.0).abs() < 5e-3);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn wheeler_1928(coil: &Coil, length: f64) -> f64 {
    let flux = coil.windings() * coil.coil_radius();
    1e-6 / 0.0254 * flux * flux / (9.0 * coil.coil_radius() + 10.0 * length)
}

/// Inductance of a coil of any length \[H\] by Wheeler's continuous formula of 1982.
///
/// L = μ₀ N² r (ln(1 + πr/l) + 1/(2.3 + 1.6 l/r + 0.44 l²/r²))
///
/// - `length`: l \[m\], above zero
///
/// Source:   `[Wheeler1982]`.
/// Valid:    any length.
/// Accuracy: within 0.1 % of Nagaoka's over l/r = 2e-6…2e6.
///
/// ```
/// use coilsense::inductance::theories::{Coil, nagaoka, wheeler_1982};
/// let coil = Coil::new(10.0, 0.01, 0.001)?;
/// assert!((wheeler_1982(&coil, 0.001) / nagaoka(&coil, 0.001) - 1.0).abs() < 1e-3);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn wheeler_1982(coil: &Coil, length: f64) -> f64 {
    let (windings, ratio) = (coil.windings(), length / coil.coil_radius());
    let bracket = (PI / ratio).ln_1p() + 1.0 / (2.3 + ratio * (1.6 + 0.44 * ratio));
    MU_0 * windings * windings * coil.coil_radius() * bracket
}
