//! What tolerances of wire, coil and material do to a spring, relative to relative.
//!
//! Next door: the formulas of which these are the exponents (`stiffness`, `wire`, `surge`).

/// How many per cent a quantity changes per per cent of each dimension or property: the exponents of its power law \[1\].
///
/// To first order Δy/y = Σ s_i Δx_i/x_i, and standard uncertainties that are independent add as the root of the sum of their squares.
///
/// Source:   exponents of the formulas of [`super::Geometry`].
/// Valid:    changes small against the value: 5 % of d is 21.6 % of k, not 20 %. The windings' own uncertainty is that of their count.
/// Accuracy: exact derivatives of ln y by ln x, checked by finite differences (`tests/geometry`).
///
/// ```
/// use coilsense::geometry::Sensitivities;
///
/// // A wire 0.5 % and a coil 1 % off, both uncertain and independent.
/// let k = Sensitivities::of_stiffness();
/// let uncertainty = (k.wire_diameter * 0.005).hypot(k.coil_diameter * 0.01);
/// assert!((uncertainty - 0.0361).abs() < 1e-4);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensitivities {
    /// To d, the diameter of the wire.
    pub wire_diameter: f64,
    /// To D, the mean diameter of the coil.
    pub coil_diameter: f64,
    /// To n, the active windings.
    pub active_windings: f64,
    /// To G, the shear modulus.
    pub shear_modulus: f64,
    /// To ρ, the density.
    pub density: f64,
}

impl Sensitivities {
    /// Of the stiffness, k ∝ G d⁴ D⁻³ n⁻¹.
    pub const fn of_stiffness() -> Self {
        Self { wire_diameter: 4.0, coil_diameter: -3.0, active_windings: -1.0, shear_modulus: 1.0, density: 0.0 }
    }

    /// Of the active mass, m ∝ ρ d² D n.
    pub const fn of_mass() -> Self {
        Self { wire_diameter: 2.0, coil_diameter: 1.0, active_windings: 1.0, shear_modulus: 0.0, density: 1.0 }
    }

    /// Of the surge frequency, f1 ∝ d D⁻² n⁻¹ G^½ ρ^−½.
    pub const fn of_surge_frequency() -> Self {
        Self { wire_diameter: 1.0, coil_diameter: -2.0, active_windings: -1.0, shear_modulus: 0.5, density: -0.5 }
    }
}
