//! The solenoid without ends.
//!
//! Next door: what its ends do (`nagaoka`).

use super::Coil;
use crate::inductance::MU_0;

/// Inductance of an ideal solenoid \[H\]: the field of an endless one over its whole length.
///
/// L = μ₀ N² π r² / l
///
/// - `length`: l \[m\], above zero
///
/// Source:   `[Vlasblom2015]`; the limit l/r → ∞ of `[Nagaoka1909]`.
/// Valid:    l far above r: it is too high by 8r/(3πl), 4 % at l = 20 r.
/// Accuracy: 4e-16 relative.
///
/// ```
/// use coilsense::inductance::{MU_0, theories::{Coil, ideal_solenoid}};
/// let coil = Coil::new(10.0, 0.01, 0.001)?;
/// assert!((ideal_solenoid(&coil, 0.1) / (MU_0 * 0.1 * std::f64::consts::PI) - 1.0).abs() < 1e-15);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn ideal_solenoid(coil: &Coil, length: f64) -> f64 {
    let flux = coil.windings() * coil.coil_radius();
    MU_0 * std::f64::consts::PI * flux * flux / length
}
