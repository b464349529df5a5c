//! Up to which frequency the current in a wire is that of direct current.
//!
//! Next door: theories of direct current (`theories`, `permeable`).

use std::f64::consts::PI;

use super::mutual::MU_0;
use crate::error::{Error, above_zero};

/// A wire's radius in skin depths up to which direct current's inductance holds.
const SKIN: f64 = 0.5;

/// The frequency \[Hz\] up to which a theory of direct current holds for a coil's inductance, by the skin effect in its wire.
///
/// f = ρ/(π μ₀ μ_r δ²), δ = 2a
///
/// - `wire_radius`: a \[m\]; `resistivity`: ρ \[Ω m\]; `permeability`: μ_r \[1\]; all above zero
///
/// Source:   skin depth, `[Jackson1999]` 5.18; the limit by axisymmetric finite elements of a coil of wire of 2 mm.
/// Valid:    round wire; turns near each other crowd the current somewhat earlier.
/// Accuracy: there L is some 0.05 % below that of direct current, 0.14 % at 1.6 times and 0.12 % at twice the frequency (μ_r 2.5 and 10).
///
/// ```
/// // Stainless wire of 2 mm, and carbon steel.
/// let stainless = coilsense::inductance::direct_up_to(1e-3, 7.5e-7, 2.5)?;
/// let carbon = coilsense::inductance::direct_up_to(1e-3, 1.8e-7, 60.0)?;
/// assert!((stainless / 19e3 - 1.0).abs() < 0.01 && carbon < 200.0);
/// # Ok::<(), coilsense::Error>(())
/// ```
///
/// # Errors
/// [`Error::Value`] for the first value that is not above zero and finite.
pub fn direct_up_to(wire_radius: f64, resistivity: f64, permeability: f64) -> Result<f64, Error> {
    above_zero("wire_radius", wire_radius, "m")?;
    above_zero("resistivity", resistivity, "Ohm m")?;
    above_zero("permeability", permeability, "")?;
    let depth = wire_radius / SKIN;
    Ok(resistivity / (PI * MU_0 * permeability * depth * depth))
}
