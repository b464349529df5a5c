//! What a wire is made of.
//!
//! Next door: the table of named materials (`data/materials.toml`), read by `coilsense-lab`; how a coil is wound from it (`geometry`).

use crate::error::{Error, check};

/// What describes a material, by name and in SI units at 20 °C; [`Material::new`] checks it.
///
/// The last four are known for some materials only. What needs one of them is `None` where it is not given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MaterialParameters {
    /// G: shear modulus \[Pa\].
    pub shear_modulus: f64,
    /// E: Young's modulus \[Pa\].
    pub youngs_modulus: f64,
    /// Density \[kg/m³\].
    pub density: f64,
    /// (dG/dT)/G \[1/K\], below zero for steel.
    pub shear_modulus_temperature: Option<f64>,
    /// Thermal expansion \[1/K\].
    pub expansion: Option<f64>,
    /// Electrical resistivity \[Ω m\].
    pub resistivity: Option<f64>,
    /// μ_r: relative magnetic permeability \[1\].
    pub relative_permeability: Option<f64>,
}

impl MaterialParameters {
    /// What a spring needs at the least: shear modulus \[Pa\], Young's modulus \[Pa\], density \[kg/m³\].
    pub fn elastic(shear_modulus: f64, youngs_modulus: f64, density: f64) -> Self {
        Self {
            shear_modulus,
            youngs_modulus,
            density,
            shear_modulus_temperature: None,
            expansion: None,
            resistivity: None,
            relative_permeability: None,
        }
    }
}

/// A material whose every value has been checked.
///
/// ```
/// use coilsense::geometry::{Material, MaterialParameters};
///
/// let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
/// assert_eq!(steel.shear_modulus(), 81.5e9);
/// assert_eq!(steel.resistivity(), None);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    parameters: MaterialParameters,
}

impl Material {
    /// Checks the parameters.
    ///
    /// # Errors
    /// [`Error::Value`] for the first value that is not finite or not of a size that solids have: moduli from 1 Pa to 1e13 Pa, density
    /// from 1e-3 to 1e6 kg/m³, temperature coefficients within 0.1 1/K of zero, resistivity from 1e-12 to 1e20 Ω m, permeability
    /// from 1e-3 to 1e9.
    pub fn new(parameters: MaterialParameters) -> Result<Self, Error> {
        let p = &parameters;
        within("shear_modulus", p.shear_modulus, "Pa", (1.0, 1e13))?;
        within("youngs_modulus", p.youngs_modulus, "Pa", (1.0, 1e13))?;
        within("density", p.density, "kg/m3", (1e-3, 1e6))?;
        for (quantity, value, unit, range) in [
            ("shear_modulus_temperature", p.shear_modulus_temperature, "1/K", (-0.1, 0.1)),
            ("expansion", p.expansion, "1/K", (-0.1, 0.1)),
            ("resistivity", p.resistivity, "Ohm m", (1e-12, 1e20)),
            ("relative_permeability", p.relative_permeability, "", (1e-3, 1e9)),
        ] {
            if let Some(value) = value {
                within(quantity, value, unit, range)?;
            }
        }
        Ok(Self { parameters })
    }

    /// The parameters it was made from.
    pub fn parameters(&self) -> &MaterialParameters {
        &self.parameters
    }

    /// G: shear modulus \[Pa\].
    pub fn shear_modulus(&self) -> f64 {
        self.parameters.shear_modulus
    }

    /// E: Young's modulus \[Pa\].
    pub fn youngs_modulus(&self) -> f64 {
        self.parameters.youngs_modulus
    }

    /// Density \[kg/m³\].
    pub fn density(&self) -> f64 {
        self.parameters.density
    }

    /// α: thermal expansion \[1/K\], where it is known.
    pub fn expansion(&self) -> Option<f64> {
        self.parameters.expansion
    }

    /// Electrical resistivity \[Ω m\], where it is known.
    pub fn resistivity(&self) -> Option<f64> {
        self.parameters.resistivity
    }

    /// μ_r: relative magnetic permeability \[1\], where it is known.
    pub fn relative_permeability(&self) -> Option<f64> {
        self.parameters.relative_permeability
    }

    /// How the stiffness of a spring of this material drifts with temperature, (dk/dT)/k \[1/K\]; `None` where a part is unknown.
    ///
    /// (dk/dT)/k = (dG/dT)/G + α
    ///
    /// Source:   k = G d⁴/(8 D³ n), where G drifts and d⁴/D³ grows as a length does.
    /// Valid:    small changes about 20 °C, the whole spring at one temperature.
    /// Accuracy: exact to first order.
    ///
    /// ```
    /// use coilsense::geometry::{Material, MaterialParameters};
    ///
    /// let mut steel = MaterialParameters::elastic(81.5e9, 206e9, 7850.0);
    /// steel.shear_modulus_temperature = Some(-3.6e-4);
    /// steel.expansion = Some(12e-6);
    /// let drift = Material::new(steel)?.stiffness_temperature().unwrap_or_default();
    /// assert!((drift + 3.48e-4).abs() < 1e-12);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn stiffness_temperature(&self) -> Option<f64> {
        Some(self.parameters.shear_modulus_temperature? + self.parameters.expansion?)
    }

    /// Highest stress that an impact at a velocity adds to the wire \[Pa\], whatever the spring's dimensions.
    ///
    /// σ = v √(2 ρ G)
    ///
    /// - `velocity`: v \[m/s\], of one end against the other; its sign is kept
    ///
    /// Source:   the wave force v √(k m) (see [`crate::Spring::wave_impedance`]) in 8 F D/(π d³), with k = G d⁴/(8 D³ n) and
    ///           m = ρ π² d² D n/4: all dimensions cancel. For steel 36 MPa per m/s.
    /// Valid:    a uniform coil, the first passage of the wave, before the correction for curvature ([`super::Geometry::wahl_factor`]);
    ///           an end that reflects doubles it.
    /// Accuracy: 3e-16 relative; equal to the two formulas it comes from to 1e-14 (`tests/geometry`).
    ///
    /// ```
    /// use coilsense::geometry::{Material, MaterialParameters};
    ///
    /// let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
    /// assert!((steel.impact_stress(1.0) - 35.77e6).abs() < 0.01e6);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn impact_stress(&self, velocity: f64) -> f64 {
        velocity * (2.0 * self.parameters.density * self.parameters.shear_modulus).sqrt()
    }
}

/// Lets through a value of a size that solids have.
fn within(quantity: &'static str, value: f64, unit: &'static str, (low, high): (f64, f64)) -> Result<f64, Error> {
    if (low..=high).contains(&value) {
        return Ok(value);
    }
    let unit_text = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    check(false, quantity, value, unit, format!("from {low:e} to {high:e}{unit_text}"))
}
