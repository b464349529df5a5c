//! How stiff a coil is: flat, and with the helix angle of its length.
//!
//! Next door: its mass (`wire`), what tolerances do to both (`tolerance`).

use super::Geometry;
use crate::error::{Error, check};

impl Geometry {
    /// k: stiffness \[N/m\].
    ///
    /// k = G d⁴ / (8 D³ n)
    ///
    /// Source:   `[EN13906-1]`; `[Shigley2011]` eq. 10–9: torsion of a flat coil.
    /// Valid:    small helix angle (see [`Self::pitch_corrected_stiffness`]), linear material, index above 4: real stiffness scatters by
    ///           some per cent with the tolerances of d and D ([`super::Sensitivities::of_stiffness`]).
    /// Accuracy: 5e-16 relative. Against Table I with G = 81.5 GPa: S_T 765 for 760 N/m, S_A 10432 for 9100 N/m (`tests/geometry`).
    pub fn stiffness(&self) -> f64 {
        let p = &self.parameters;
        p.material.shear_modulus() * p.wire_diameter.powi(4) / (8.0 * p.coil_diameter.powi(3) * p.active_windings)
    }

    /// Stiffness of the coil at a length \[N/m\], ends free to turn about the spring's axis.
    ///
    /// k = k_0 cos α / (cos²α + (2G/E) sin²α), tan α = l / (π D n)
    ///
    /// A force F twists the wire by F R cos α and bends it by F R sin α over L = π D n / cos α, so Castigliano's theorem gives
    /// δ = F R² L (cos²α/GJ + sin²α/EI), where J = 2I = π d⁴/32.
    ///
    /// - `length`: l \[m\] that the active windings span
    ///
    /// Source:   derived in the line above; `[AnckerGoodier1958]` carry the same expansion further, with the curvature of the wire.
    /// Valid:    the tangent stiffness of a helix of coil diameter D and n windings at this length; the change of D and n as a spring
    ///           opens, of the same order, is left out. Held ends: [`Self::pitch_corrected_stiffness_held`].
    /// Accuracy: 1e-15 relative to the formula; S_T at 230 mm lies 0.22 % below the flat coil.
    pub fn pitch_corrected_stiffness(&self, length: f64) -> f64 {
        let (cos2, sin2) = self.helix(length);
        let m = self.material();
        self.stiffness() * cos2.sqrt() / (cos2 + 2.0 * m.shear_modulus() / m.youngs_modulus() * sin2)
    }

    /// Stiffness of the coil at a length \[N/m\], ends held against turning about the spring's axis.
    ///
    /// k = k_0 cos α (cos²α + (E/2G) sin²α)
    ///
    /// With a couple C on the ends the wire is twisted by F R cos α + C sin α and bent by F R sin α − C cos α; the C that keeps
    /// the ends from turning is eliminated, k = (GJ cos²α + EI sin²α)/(R² L).
    ///
    /// - `length`: l \[m\] that the active windings span
    ///
    /// Source:   derived in the line above, by Castigliano's theorem.
    /// Valid:    as [`Self::pitch_corrected_stiffness`]; real ends lie between the two, hooks near to held.
    /// Accuracy: 1e-15 relative to the formula; S_T at 230 mm lies 0.18 % below the flat coil.
    pub fn pitch_corrected_stiffness_held(&self, length: f64) -> f64 {
        let (cos2, sin2) = self.helix(length);
        let m = self.material();
        self.stiffness() * cos2.sqrt() * (cos2 + 0.5 * m.youngs_modulus() / m.shear_modulus() * sin2)
    }

    /// cos²α and sin²α of the helix angle at a length.
    fn helix(&self, length: f64) -> (f64, f64) {
        let tan2 = (length / self.wire_length()).powi(2);
        let cos2 = 1.0 / (1.0 + tan2);
        (cos2, tan2 * cos2)
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
