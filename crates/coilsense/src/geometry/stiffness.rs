//! How stiff a coil is by the formula of a flat one.
//!
//! Next door: the same as a helix at its length (`crate::helix`), its mass (`wire`), what tolerances do to both (`tolerance`).

use super::Geometry;
use crate::error::{Error, check};

impl Geometry {
    /// k: stiffness \[N/m\].
    ///
    /// k = G d⁴ / (8 D³ n)
    ///
    /// Source:   `[EN13906-1]`; `[Shigley2011]` eq. 10–9: torsion of a flat coil.
    /// Valid:    small helix angle (that of a helix at its length: [`crate::helix::Helix::stiffness`]), linear material, index above 4: real stiffness scatters by
    ///           some per cent with the tolerances of d and D ([`super::Sensitivities::of_stiffness`]).
    /// Accuracy: 5e-16 relative. Against Table I with G = 81.5 GPa: S_T 765 for 760 N/m, S_A 10432 for 9100 N/m (`tests/geometry`).
    pub fn stiffness(&self) -> f64 {
        let p = &self.parameters;
        p.material.shear_modulus() * p.wire_diameter.powi(4) / (8.0 * p.coil_diameter.powi(3) * p.active_windings)
    }
}

/// l0 − F_0/k \[m\], which must be above zero.
pub(super) fn effective_rest_length(geometry: &Geometry) -> Result<f64, Error> {
    let p = geometry.parameters();
    let length = p.rest_length - p.initial_tension / geometry.stiffness();
    let most = geometry.stiffness() * p.rest_length;
    let allowed = format!("below {most} N, stiffness times rest length");
    check(length > 0.0, "initial_tension", p.initial_tension, "N", allowed)?;
    Ok(length)
}
