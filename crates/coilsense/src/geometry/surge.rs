//! The first surge frequency from dimensions and material alone.
//!
//! Next door: from stiffness and mass ([`crate::Spring::surge_frequency`]), with any end ([`crate::modes::continuous_frequencies`]).

use std::f64::consts::{PI, SQRT_2};

use super::Geometry;

impl Geometry {
    /// f1: first surge frequency, both ends held \[Hz\].
    ///
    /// f1 = ½ √(k/m) = d / (2π n D²) √(G / 2ρ)
    ///
    /// Source:   `[Weijde2017]` eq. 3 with k and m of this module.
    /// Valid:    a flat coil, bare wire, no damping.
    /// Accuracy: 5e-16 relative; equal to ½ √(k/m) to 1e-15 (`tests/geometry`).
    pub fn surge_frequency(&self) -> f64 {
        let p = &self.parameters;
        let speed = (p.material.shear_modulus() / p.material.density()).sqrt();
        p.wire_diameter / (2.0 * SQRT_2 * PI * p.active_windings * p.coil_diameter.powi(2)) * speed
    }

    /// First surge frequency as the standard prints it \[Hz\], with its rounded constant.
    ///
    /// f_e = 3560 d / (n D²) √(G/ρ), with d and D in mm, G in MPa, ρ in kg/dm³
    ///
    /// Source:   `[EN13906-1]`, natural frequency of a spring with both ends held.
    /// Valid:    as [`Self::surge_frequency`].
    /// Accuracy: the exact constant in these units is 10³ √10³ / (2π √2) = 3558.81: what is printed lies 0.0334 % above
    ///           [`Self::surge_frequency`] for every spring (`tests/geometry`).
    ///
    /// ```
    /// # use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material, MaterialParameters};
    /// # let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
    /// # let s_t = Geometry::new(GeometryParameters { wire_diameter: 0.002, coil_diameter: 0.016, active_windings: 52.0,
    /// #     total_windings: None, end_type: EndType::Hooks, material: steel, rest_length: 0.104, initial_tension: 0.0 })?;
    /// assert!((s_t.surge_frequency_en13906() - 54.50).abs() < 0.01);
    /// assert!((s_t.surge_frequency() - 54.48).abs() < 0.01);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn surge_frequency_en13906(&self) -> f64 {
        let p = &self.parameters;
        let (d, diameter) = (1e3 * p.wire_diameter, 1e3 * p.coil_diameter);
        let (modulus, density) = (1e-6 * p.material.shear_modulus(), 1e-3 * p.material.density());
        3560.0 * d / (p.active_windings * diameter * diameter) * (modulus / density).sqrt()
    }
}
