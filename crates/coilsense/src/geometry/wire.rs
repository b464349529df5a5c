//! The wire: how long, how heavy, of what resistance.
//!
//! Next door: how stiff the coil is that is wound from it (`stiffness`).

use std::f64::consts::PI;

use super::Geometry;

impl Geometry {
    /// Length of the wire in the active windings of a flat coil \[m\].
    ///
    /// L = π D n
    ///
    /// Source:   geometry.
    /// Valid:    small helix angle; S_T's true wire is 0.08 % longer at rest.
    /// Accuracy: 2e-16 relative.
    pub fn wire_length(&self) -> f64 {
        PI * self.parameters.coil_diameter * self.parameters.active_windings
    }

    /// Length of the wire in the active windings of a helix \[m\].
    ///
    /// L = √((π D n)² + l²)
    ///
    /// - `length`: l \[m\] that the active windings span where D was measured, commonly the rest length: stretching makes no wire
    ///
    /// Source:   geometry.
    /// Valid:    a uniform helix.
    /// Accuracy: 4e-16 relative.
    pub fn wire_length_at(&self, length: f64) -> f64 {
        self.wire_length().hypot(length)
    }

    /// What the active windings span along the axis at a length of the spring \[m\], from wire centre to wire centre.
    ///
    /// l_a = l − (l_s − n d)
    ///
    /// - `length`: l \[m\] over all, see [`super::EndType::solid_length`]
    ///
    /// Source:   solid, the active windings span n wires; what is left of the length is dead windings and the wire's own thickness.
    /// Valid:    dead windings that lie wire on wire. Hooks: l itself; closed and ground: l − 2 d.
    /// Accuracy: rounding of the difference.
    pub fn active_span(&self, length: f64) -> f64 {
        let p = &self.parameters;
        length - (p.end_type.solid_length(self.total_windings, p.wire_diameter) - p.active_windings * p.wire_diameter)
    }

    /// Cross-section of the wire \[m²\]: π d²/4.
    pub fn wire_area(&self) -> f64 {
        0.25 * PI * self.parameters.wire_diameter.powi(2)
    }

    /// m: mass of the active windings \[kg\], wire length of a flat coil.
    ///
    /// m = ρ (π d²/4) π D n
    ///
    /// Source:   geometry; the mass that `[EN13906-1]` puts into its surge frequency.
    /// Valid:    small helix angle, bare wire.
    /// Accuracy: 5e-16 relative. Table I's springs from steel at 7850 kg/m³: 64.5 and 79.3 g for 65 and 80 g (`tests/geometry`).
    pub fn active_mass(&self) -> f64 {
        self.material().density() * self.wire_area() * self.wire_length()
    }

    /// m: mass of the active windings \[kg\], wire length of a helix.
    ///
    /// m = ρ (π d²/4) √((π D n)² + l²)
    ///
    /// - `length`: l \[m\], see [`Self::wire_length_at`]
    ///
    /// Source:   geometry.
    /// Valid:    a uniform helix, bare wire.
    /// Accuracy: 6e-16 relative.
    pub fn active_mass_at(&self, length: f64) -> f64 {
        self.material().density() * self.wire_area() * self.wire_length_at(length)
    }

    /// Mass of all windings \[kg\], inactive ones flat; hooks and loops come on top.
    ///
    /// m_t = m n_t / n
    ///
    /// Source:   geometry.
    /// Valid:    small helix angle; grinding takes away up to about half a winding, hooks add one or two.
    /// Accuracy: 6e-16 relative to the formula.
    pub fn total_mass(&self) -> f64 {
        self.active_mass() * (self.total_windings / self.parameters.active_windings)
    }

    /// Resistance of the active windings to a constant current \[Ω\]; `None` where the material's resistivity is unknown.
    ///
    /// R = ρ_e L / (π d²/4)
    ///
    /// Source:   Ohm's law.
    /// Valid:    constant current: at the frequency of an inductance meter the skin effect adds to it, in steel (μ_r far above 1) by far.
    /// Accuracy: 5e-16 relative.
    ///
    /// ```
    /// use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material, MaterialParameters};
    ///
    /// let mut steel = MaterialParameters::elastic(81.5e9, 206e9, 7850.0);
    /// steel.resistivity = Some(2e-7);
    /// let s_t = Geometry::new(GeometryParameters { wire_diameter: 0.002, coil_diameter: 0.016, active_windings: 52.0,
    ///     total_windings: None, end_type: EndType::Hooks, material: Material::new(steel)?, rest_length: 0.104,
    ///     initial_tension: 0.0 })?;
    /// assert!((s_t.wire_resistance().unwrap_or_default() - 0.1664).abs() < 1e-4);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn wire_resistance(&self) -> Option<f64> {
        Some(self.material().resistivity()? * self.wire_length() / self.wire_area())
    }
}
