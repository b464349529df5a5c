//! `coilsense.Material`: what a wire is made of.
//!
//! Next door: the coil wound from it (the parent).

use coilsense::geometry::{Material, MaterialParameters};
use coilsense_lab::quantity::Dimension;
use coilsense_lab::spec::named_materials;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{IntoPython, unknown};
use crate::names::Word;
use crate::quantity::{Quantity, si};
use crate::samples::Samples;
use crate::value::{getters, named_value};

/// What a wire is made of, at 20 degrees Celsius.
///
/// Parameters
/// ----------
/// shear_modulus : float or str
///     G [Pa].
/// youngs_modulus : float or str
///     E [Pa].
/// density : float or str
///     [kg/m^3].
/// shear_modulus_temperature : float or str, optional
///     (dG/dT)/G [1/K], below zero for steel.
/// expansion : float or str, optional
///     Thermal expansion [1/K].
/// resistivity : float or str, optional
///     [Ohm m].
/// relative_permeability : float, optional
///     mu_r [1].
///
/// Raises
/// ------
/// Error
///     For the first value that is not finite or not of a size that solids have.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> steel = coilsense.Material(shear_modulus="81.5 GPa", youngs_modulus="206 GPa", density=7850)
/// >>> steel.shear_modulus, steel.resistivity is None
/// (81500000000.0, True)
#[pyclass(name = "Material", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyMaterial(pub Material);

getters! {
    PyMaterial, self;
    /// G: shear modulus [Pa].
    shear_modulus: f64 = self.0.shear_modulus();
    /// E: Young's modulus [Pa].
    youngs_modulus: f64 = self.0.youngs_modulus();
    /// Density [kg/m^3].
    density: f64 = self.0.density();
    /// (dG/dT)/G [1/K]; None where it is not known.
    shear_modulus_temperature: Option<f64> = self.0.parameters().shear_modulus_temperature;
    /// Thermal expansion [1/K]; None where it is not known.
    expansion: Option<f64> = self.0.parameters().expansion;
    /// Electrical resistivity [Ohm m]; None where it is not known.
    resistivity: Option<f64> = self.0.resistivity();
    /// mu_r: relative magnetic permeability [1]; None where it is not known.
    relative_permeability: Option<f64> = self.0.relative_permeability();
    /// How the stiffness of a spring of it drifts, (dk/dT)/k [1/K]; None where a part is not known.
    stiffness_temperature: Option<f64> = self.0.stiffness_temperature();
}

named_value! {
    /// The values by name.
    PyMaterial, self;
    shear_modulus, youngs_modulus, density, shear_modulus_temperature, expansion, resistivity, relative_permeability,
}

#[pymethods]
impl PyMaterial {
    #[new]
    #[pyo3(signature = (*, shear_modulus, youngs_modulus, density, shear_modulus_temperature=None, expansion=None, resistivity=None,
                        relative_permeability=None))]
    fn new(
        shear_modulus: Quantity,
        youngs_modulus: Quantity,
        density: Quantity,
        shear_modulus_temperature: Option<Quantity>,
        expansion: Option<Quantity>,
        resistivity: Option<Quantity>,
        relative_permeability: Option<Quantity>,
    ) -> PyResult<Self> {
        let parameters = MaterialParameters {
            shear_modulus: shear_modulus.si("shear_modulus", Dimension::Modulus)?,
            youngs_modulus: youngs_modulus.si("youngs_modulus", Dimension::Modulus)?,
            density: density.si("density", Dimension::Density)?,
            shear_modulus_temperature: si(
                shear_modulus_temperature.as_ref(),
                "shear_modulus_temperature",
                Dimension::PerKelvin,
            )?,
            expansion: si(expansion.as_ref(), "expansion", Dimension::PerKelvin)?,
            resistivity: si(resistivity.as_ref(), "resistivity", Dimension::Resistivity)?,
            relative_permeability: relative_permeability.map(|mu| mu.plain("relative_permeability")).transpose()?,
        };
        Material::new(parameters).python().map(Self)
    }

    /// A material of the table that a spec's ``material`` names, too; `materials` has all of them.
    ///
    /// Parameters
    /// ----------
    /// name : str
    ///     As ``"steel EN 10270-1"``.
    ///
    /// Returns
    /// -------
    /// Material
    ///
    /// Raises
    /// ------
    /// Error
    ///     For a name that the table does not have; it says which there are.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Material.named("steel EN 10270-1").density
    /// 7850.0
    #[staticmethod]
    fn named(name: Word) -> PyResult<Self> {
        let name = name.text("name")?;
        let all = named_materials().python()?;
        let names: Vec<&str> = all.iter().map(|(name, _)| *name).collect();
        let found = all.iter().find(|(known, _)| *known == name).ok_or_else(|| unknown("material", &names, name))?;
        Material::new(found.1).python().map(Self)
    }

    /// Highest stress that an impact adds to the wire, whatever the spring's dimensions.
    ///
    /// Parameters
    /// ----------
    /// velocity : float, str or array_like of float
    ///     v [m/s], of one end against the other.
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the velocity
    ///     v sqrt(2 rho G) [Pa].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> steel = coilsense.Material.named("steel EN 10270-1")
    /// >>> (1e-6 * steel.impact_stress([1.0, 5.0])).round(1)
    /// array([ 35.8, 178.9])
    fn impact_stress<'py>(&self, py: Python<'py>, velocity: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        velocity.each(py, "velocity", Dimension::Velocity, |velocity| self.0.impact_stress(velocity))
    }
}

/// The materials that come with coilsense, by their names in a spec; each value has its source in what ``coilsense spring
/// --materials`` prints.
///
/// Returns
/// -------
/// dict of str to Material
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> round(coilsense.materials()["steel EN 10270-1"].density)
/// 7850
#[pyfunction]
pub fn materials(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let dict = PyDict::new(py);
    for (name, parameters) in named_materials().python()? {
        dict.set_item(name, PyMaterial(Material::new(parameters).python()?))?;
    }
    Ok(dict)
}
