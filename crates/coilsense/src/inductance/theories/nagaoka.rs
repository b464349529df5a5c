//! The current sheet: Nagaoka's coefficient, exactly.
//!
//! Next door: its approximations (`lundin`, `wheeler`), what round wire changes (`round_wire`).

use std::f64::consts::{LN_2, PI};

use super::Coil;
use super::ideal::ideal_solenoid;
use crate::inductance::elliptic::{complete_d, complete_e};

/// Up to this k' the bracket is summed as a series of positive terms; above it nothing cancels by more than a factor 3.
const SERIES_BELOW: f64 = 0.6;

/// Nagaoka's coefficient K_L of a cylindrical current sheet \[1\]: its inductance over that of the ideal solenoid.
///
/// K_L = (4/3π) (k'²D + E − k)/k' = (4/3π) k' (D + (E − 1)/k'² + 1/(1 + k)), k = d/√(d² + l²), k' = l/√(d² + l²), D = (K − E)/k²,
/// (E − 1)/k'² = ½ Σ_{m≥0} a_m k'^(2m) (ln(4/k') − e_m), a_0 = 1, a_m = a_{m−1} (m − ½)(m + ½)/(m(m + 1)),
/// e_m = Σ_{j≤m} 2/((2j − 1)2j) + 1/((2m + 1)(2m + 2))
///
/// - `ratio`: l/d, length over diameter \[1\], above zero
///
/// Source:   `[Nagaoka1909]`; the series `[DLMF]` 19.12.2.
/// Valid:    a sheet of current without thickness, pitch or axial current.
/// Accuracy: 1e-15 relative over l/d = 1e-6…1e6, against 40 digits.
/// Differs:  the classical form takes K − E over k² and E − k as they stand: it loses (d/l)⁻² of its digits for long coils and d/l for
///           short ones. The second form, by the series, is used up to k' = 0.6, the first above.
///
/// ```
/// use coilsense::inductance::theories::nagaoka_coefficient;
/// assert!((nagaoka_coefficient(1.0) - 0.688_423).abs() < 1e-6); // the classical tables
/// ```
pub fn nagaoka_coefficient(ratio: f64) -> f64 {
    let diagonal = ratio.hypot(1.0);
    let (k, kc) = (1.0 / diagonal, ratio / diagonal);
    let bracket = if kc <= SERIES_BELOW {
        kc * (complete_d(kc) + series(kc) + 1.0 / (1.0 + k))
    } else {
        (kc * kc * complete_d(kc) + complete_e(kc) - k) / kc
    };
    4.0 / (3.0 * PI) * bracket
}

/// (E − 1)/k'².
fn series(kc: f64) -> f64 {
    let square = kc * kc;
    let logarithm = 2.0 * LN_2 - kc.ln();
    let (mut sum, mut factor, mut harmonic) = (0.0, 0.5, 0.0);
    // 0.36^m is below the last bit from m = 36 on.
    for m in 0..40 {
        let (m, odd) = (f64::from(m), f64::from(2 * m + 1));
        if m > 0.0 {
            factor *= square * (m - 0.5) * (m + 0.5) / (m * (m + 1.0));
            harmonic += 2.0 / ((odd - 2.0) * (odd - 1.0));
        }
        sum += factor * (logarithm - harmonic - 1.0 / (odd * (odd + 1.0)));
    }
    sum
}

/// Inductance of a coil as a current sheet \[H\].
///
/// L = K_L(l/2r) μ₀ N² π r² / l
///
/// - `length`: l \[m\], above zero
///
/// Source:   `[Nagaoka1909]`.
/// Valid:    windings so many and so close that they make a sheet: see [`super::nagaoka_rosa`] for round wire.
/// Accuracy: 1e-15 relative over l/r = 2e-6…2e6, against 40 digits.
///
/// ```
/// use coilsense::inductance::theories::{Coil, ideal_solenoid, nagaoka};
/// let coil = Coil::new(10.0, 0.01, 0.001)?;
/// assert!((nagaoka(&coil, 0.02) / ideal_solenoid(&coil, 0.02) - 0.688_423).abs() < 1e-6);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn nagaoka(coil: &Coil, length: f64) -> f64 {
    nagaoka_coefficient(length / (2.0 * coil.coil_radius())) * ideal_solenoid(coil, length)
}
