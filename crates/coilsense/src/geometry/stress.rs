//! What a force does to the wire.
//!
//! Next door: what an impact does, which no dimension changes ([`super::Material::impact_stress`]).

use std::f64::consts::PI;

use super::Geometry;

impl Geometry {
    /// Shear stress in the wire under a force \[Pa\], without correction for curvature.
    ///
    /// σ = 8 F D / (π d³)
    ///
    /// - `force`: F \[N\]; its sign is kept
    ///
    /// Source:   `[EN13906-1]`: torsion of a straight wire by F D/2.
    /// Valid:    static strength; for fatigue see [`Self::corrected_shear_stress`].
    /// Accuracy: 5e-16 relative.
    pub fn shear_stress(&self, force: f64) -> f64 {
        let p = &self.parameters;
        8.0 * force * p.coil_diameter / (PI * p.wire_diameter.powi(3))
    }

    /// Shear stress at the inside of the winding under a force \[Pa\], where it is highest.
    ///
    /// σ = K_W 8 F D / (π d³)
    ///
    /// - `force`: F \[N\]; its sign is kept
    ///
    /// Source:   `[Wahl1963]`.
    /// Valid:    linear material, index above about 3.
    /// Accuracy: 6e-16 relative to the formula.
    pub fn corrected_shear_stress(&self, force: f64) -> f64 {
        self.wahl_factor() * self.shear_stress(force)
    }

    /// K_W: how much curvature and direct shear raise the stress at the inside of the winding \[1\].
    ///
    /// K_W = (4C − 1)/(4C − 4) + 0.615/C
    ///
    /// Source:   `[Wahl1963]`; `[Shigley2011]` eq. 10–4.
    /// Valid:    round wire, index C above about 3; it grows without bound as C falls to 1.
    /// Accuracy: 5e-16 relative to the formula, more as C nears 1.
    /// Differs:  `[EN13906-1]` takes Bergsträsser's (C + ½)/(C − ¾): 1.4 % lower at C = 4, 1.0 % at C = 8.
    ///
    /// ```
    /// # use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material, MaterialParameters};
    /// # let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
    /// # let s_t = Geometry::new(GeometryParameters { wire_diameter: 0.002, coil_diameter: 0.016, active_windings: 52.0,
    /// #     total_windings: None, end_type: EndType::Hooks, material: steel, rest_length: 0.104, initial_tension: 0.0 })?;
    /// assert!((s_t.wahl_factor() - 1.1840).abs() < 1e-4); // C = 8
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn wahl_factor(&self) -> f64 {
        let c = self.index();
        1.0 + 0.75 / (c - 1.0) + 0.615 / c
    }
}
