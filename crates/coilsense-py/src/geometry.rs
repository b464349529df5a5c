//! `coilsense.Geometry` and `Material`: from wire and coil to stiffness, mass and stress.
//!
//! Next door: the spring as Table I of the paper gives it (`spring`).

pub mod material;

use coilsense::geometry::{EndType, Geometry, GeometryParameters};
use coilsense_lab::quantity::Dimension::{Force, Length};
use pyo3::prelude::*;

pub use material::PyMaterial;

use crate::errors::{IntoPython, unknown};
use crate::names::Word;
use crate::noun::Noun;
use crate::quantity::Quantity;
use crate::samples::Samples;
use crate::spring::PySpring;
use crate::value::{getters, named_value};

/// Words for how the wire ends, those of a spec.
const ENDS: [(&str, EndType); 5] = [
    ("hooks", EndType::Hooks),
    ("open", EndType::Open),
    ("open-ground", EndType::OpenGround),
    ("closed", EndType::Closed),
    ("closed-ground", EndType::ClosedGround),
];

fn end_type(word: &str) -> PyResult<EndType> {
    let found = ENDS.iter().find(|(name, _)| *name == word);
    found.map(|(_, end)| *end).ok_or_else(|| unknown("end type", &ENDS.map(|(name, _)| name), word))
}

/// Wire and coil.
///
/// Parameters
/// ----------
/// wire_diameter : float or str
///     d [m].
/// coil_diameter : float or str
///     D, to the centre of the wire [m].
/// active_windings : float
///     n [1], may be fractional.
/// end_type : {"hooks", "open", "open-ground", "closed", "closed-ground"}
///     How the wire ends.
/// material : Material
///     What the wire is made of.
/// rest_length : float or str
///     l0, without force [m]; of an extension spring, closed.
/// total_windings : float, optional
///     n_t [1]; without it the active ones and what the ends take.
/// initial_tension : float or str, optional
///     F_0, force at which an extension spring begins to open [N].
///
/// Raises
/// ------
/// Error
///     For the first value that is not finite or not above zero, a wire that is not thinner than the coil, fewer windings in total than
///     active, a compression spring shorter than its solid length or with initial tension.
///
/// Notes
/// -----
/// Source: [Shigley2011] chapter 10, [EN13906-1].
///
/// Examples
/// --------
/// >>> from coilsense import Geometry, Material
/// >>> steel = Material(shear_modulus=81.5e9, youngs_modulus=206e9, density=7850)
/// >>> s_t = Geometry(wire_diameter=0.002, coil_diameter=0.016, active_windings=52, end_type="hooks", material=steel, rest_length=0.104)
/// >>> round(s_t.stiffness, 1)  # Table I: 760 N/m
/// 765.3
#[pyclass(name = "Geometry", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyGeometry(pub Geometry);

getters! {
    PyGeometry, self;
    /// What the wire is made of.
    material: PyMaterial = PyMaterial(*self.0.material());
    /// n_t: all windings [1].
    total_windings: f64 = self.0.total_windings();
    /// C: spring index D/d [1].
    index: f64 = self.0.index();
    /// Length with all windings touching, inactive ones included [m].
    solid_length: f64 = self.0.solid_length();
    /// Length at which the straight line of force over length crosses zero [m]: l0 - F_0/k.
    effective_rest_length: f64 = self.0.effective_rest_length();
    /// k = G d^4 / (8 D^3 n) [N/m]; index above 4, small helix angle.
    stiffness: f64 = self.0.stiffness();
    /// Mass of the active windings [kg].
    active_mass: f64 = self.0.active_mass();
    /// Mass of all windings [kg].
    total_mass: f64 = self.0.total_mass();
    /// f1 of a flat coil with both ends held [Hz].
    surge_frequency: f64 = self.0.surge_frequency();
    /// Length of the wire [m], helix angle left out.
    wire_length: f64 = self.0.wire_length();
    /// Resistance of the wire [Ohm]; None where the material's resistivity is not known.
    wire_resistance: Option<f64> = self.0.wire_resistance();
    /// Wahl's factor for the curvature of the wire [1]. Source: [Wahl1963].
    wahl_factor: f64 = self.0.wahl_factor();
}

named_value! {
    /// The arguments by name, the material as a dict.
    PyGeometry, self;
    wire_diameter = self.0.parameters().wire_diameter,
    coil_diameter = self.0.parameters().coil_diameter,
    active_windings = self.0.parameters().active_windings,
    end_type, material,
    rest_length = self.0.parameters().rest_length,
    total_windings = self.0.parameters().total_windings,
    initial_tension = self.0.parameters().initial_tension,
}

#[pymethods]
impl PyGeometry {
    #[new]
    #[pyo3(signature = (*, wire_diameter, coil_diameter, active_windings, end_type, material, rest_length, total_windings=None,
                        initial_tension=Quantity::Number(0.0)),
           text_signature = "(*, wire_diameter, coil_diameter, active_windings, end_type, material, rest_length, total_windings=None, \
                             initial_tension=0.0)")]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per dimension")]
    fn new(
        wire_diameter: Quantity,
        coil_diameter: Quantity,
        active_windings: Quantity,
        end_type: Word,
        material: Noun<'_, PyMaterial>,
        rest_length: Quantity,
        total_windings: Option<Quantity>,
        initial_tension: Quantity,
    ) -> PyResult<Self> {
        let material = material.named("material")?;
        let parameters = GeometryParameters {
            wire_diameter: wire_diameter.si("wire_diameter", Length)?,
            coil_diameter: coil_diameter.si("coil_diameter", Length)?,
            active_windings: active_windings.plain("active_windings")?,
            total_windings: total_windings.map(|count| count.plain("total_windings")).transpose()?,
            end_type: self::end_type(end_type.text("end_type")?)?,
            material: material.0,
            rest_length: rest_length.si("rest_length", Length)?,
            initial_tension: initial_tension.si("initial_tension", Force)?,
        };
        Geometry::new(parameters).python().map(Self)
    }

    /// Wire and coil of a spring whose stiffness and mass are known from elsewhere: all windings active, no initial tension.
    ///
    /// Parameters
    /// ----------
    /// spring : Spring
    ///     The spring.
    /// end_type : {"hooks", "open", "open-ground", "closed", "closed-ground"}
    ///     How the wire ends.
    /// material : Material
    ///     What the wire is made of.
    ///
    /// Returns
    /// -------
    /// Geometry
    ///     Its stiffness and mass are the formulas', not the spring's.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> geometry = coilsense.Geometry.of_spring(coilsense.Spring.of_paper("S_T"), "hooks", coilsense.Material.named("steel EN 10270-1"))
    /// >>> round(geometry.stiffness)
    /// 765
    #[staticmethod]
    fn of_spring(spring: Noun<'_, PySpring>, end_type: Word, material: Noun<'_, PyMaterial>) -> PyResult<Self> {
        let spring = spring.named("spring")?;
        let material = material.named("material")?;
        Geometry::of_spring(&spring.0, self::end_type(end_type.text("end_type")?)?, material.0).python().map(Self)
    }

    /// How the wire ends.
    #[getter]
    fn end_type(&self) -> &'static str {
        let own = self.0.parameters().end_type;
        ENDS.iter().find(|(_, end)| *end == own).map_or("", |(word, _)| word)
    }

    /// Shear stress in the wire, curvature left out.
    ///
    /// Parameters
    /// ----------
    /// force : float, str or array_like of float
    ///     F [N].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the force
    ///     8 F D / (pi d^3) [Pa]; for static strength.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> geometry = coilsense.Geometry.of_spring(coilsense.Spring.of_paper("S_T"), "hooks", coilsense.Material.named("steel EN 10270-1"))
    /// >>> print(f"{1e-6 * geometry.shear_stress('100 N'):.0f} MPa")
    /// 509 MPa
    fn shear_stress<'py>(&self, py: Python<'py>, force: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        force.each(py, "force", Force, |force| self.0.shear_stress(force))
    }

    /// Shear stress at the inside of the coil, for fatigue.
    ///
    /// Parameters
    /// ----------
    /// force : float, str or array_like of float
    ///     F [N].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the force
    ///     With Wahl's factor [Pa].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> geometry = coilsense.Geometry.of_spring(coilsense.Spring.of_paper("S_T"), "hooks", coilsense.Material.named("steel EN 10270-1"))
    /// >>> (geometry.corrected_shear_stress([50.0, 100.0]) / geometry.shear_stress([50.0, 100.0])).round(3)
    /// array([1.184, 1.184])
    fn corrected_shear_stress<'py>(&self, py: Python<'py>, force: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        force.each(py, "force", Force, |force| self.0.corrected_shear_stress(force))
    }
}
