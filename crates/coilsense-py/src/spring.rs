//! `coilsense.Spring`.
//!
//! Next door: from wire and coil (`geometry`), what is done to it (`excitation`).

use coilsense::{Spring, SpringParameters};
use coilsense_lab::spec::{Spec, template};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{IntoPython, unknown};
use crate::value::{self, Arguments, NewArguments};

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PySpring>()
}

/// Springs of the paper's Table I.
const OF_PAPER: [&str; 2] = ["S_T", "S_A"];

/// A spring whose every value has been checked.
///
/// Parameters
/// ----------
/// rest_length : float
///     l0, length without force [m].
/// windings : float
///     N, active windings [1]; may be fractional.
/// coil_radius : float
///     r, from the coil's axis to the centre of the wire [m].
/// wire_radius : float
///     Radius of the wire [m].
/// mass : float
///     m, mass of the active coil [kg].
/// stiffness : float
///     k [N/m].
/// min_length, max_length : float
///     Shortest and longest length in use [m].
/// nominal_force : float, optional
///     F_nom [N]; without it k max(\|min_length - l0\|, \|max_length - l0\|).
/// inductance_windings : float, optional
///     Windings that carry the current [1]; without it the active ones.
///
/// Raises
/// ------
/// Error
///     For the first value that is not finite, not above zero, a wire that is not thinner than the coil, or an operating range that
///     is empty or reversed.
///
/// Notes
/// -----
/// Source: Table I of van der Weijde, van Ostayen and Vallery [Weijde2017].
///
/// Examples
/// --------
/// >>> from coilsense import Spring
/// >>> spring = Spring(rest_length=0.104, windings=52, coil_radius=0.008, wire_radius=0.001, mass=0.065, stiffness=760,
/// ...                 min_length=0.196, max_length=0.264)
/// >>> spring == Spring.of_paper("S_T")
/// True
/// >>> round(spring.surge_frequency, 3)
/// 54.065
#[pyclass(name = "Spring", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PySpring(pub Spring);

impl PySpring {
    fn arguments<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let p = self.0.parameters();
        let dict = PyDict::new(py);
        dict.set_item("rest_length", p.rest_length)?;
        dict.set_item("windings", p.windings)?;
        dict.set_item("coil_radius", p.coil_radius)?;
        dict.set_item("wire_radius", p.wire_radius)?;
        dict.set_item("mass", p.mass)?;
        dict.set_item("stiffness", p.stiffness)?;
        dict.set_item("min_length", p.min_length)?;
        dict.set_item("max_length", p.max_length)?;
        dict.set_item("nominal_force", p.nominal_force)?;
        dict.set_item("inductance_windings", p.inductance_windings)?;
        Ok(dict)
    }
}

#[pymethods]
impl PySpring {
    #[new]
    #[pyo3(signature = (*, rest_length, windings, coil_radius, wire_radius, mass, stiffness, min_length, max_length,
                        nominal_force=None, inductance_windings=None))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per value of Table I")]
    fn new(
        rest_length: f64,
        windings: f64,
        coil_radius: f64,
        wire_radius: f64,
        mass: f64,
        stiffness: f64,
        min_length: f64,
        max_length: f64,
        nominal_force: Option<f64>,
        inductance_windings: Option<f64>,
    ) -> PyResult<Self> {
        let parameters = SpringParameters {
            rest_length,
            windings,
            coil_radius,
            wire_radius,
            mass,
            stiffness,
            min_length,
            max_length,
            nominal_force,
            inductance_windings,
        };
        Spring::new(parameters).python().map(Self)
    }

    /// A spring of the paper's Table I.
    ///
    /// Parameters
    /// ----------
    /// name : {"S_T", "S_A"}
    ///     S_T is the ankle spring of the humanoid TUlip, S_A that of the lower-leg prosthesis ANGELAA.
    ///
    /// Returns
    /// -------
    /// Spring
    ///
    /// Raises
    /// ------
    /// Error
    ///     For another name.
    ///
    /// Notes
    /// -----
    /// Source: [Weijde2017] Table I.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> round(coilsense.Spring.of_paper("S_A").surge_frequency, 2)
    /// 168.63
    #[staticmethod]
    fn of_paper(name: &str) -> PyResult<Self> {
        if !OF_PAPER.contains(&name) {
            return Err(unknown("spring of the paper", &OF_PAPER, name));
        }
        let spec = Spec::parse(name, &template(Some(name)).python()?, &|_| Err(String::new())).python()?;
        Ok(Self(spec.spring.spring))
    }

    /// l0: length without force [m].
    #[getter]
    fn rest_length(&self) -> f64 {
        self.0.rest_length()
    }

    /// N: active windings [1], may be fractional.
    #[getter]
    fn windings(&self) -> f64 {
        self.0.windings()
    }

    /// r: radius of the coil to the centre of the wire [m].
    #[getter]
    fn coil_radius(&self) -> f64 {
        self.0.coil_radius()
    }

    /// Radius of the wire [m].
    #[getter]
    fn wire_radius(&self) -> f64 {
        self.0.wire_radius()
    }

    /// Diameter of the wire [m].
    #[getter]
    fn wire_diameter(&self) -> f64 {
        self.0.wire_diameter()
    }

    /// m: mass of the active coil [kg].
    #[getter]
    fn mass(&self) -> f64 {
        self.0.mass()
    }

    /// k: stiffness [N/m].
    #[getter]
    fn stiffness(&self) -> f64 {
        self.0.stiffness()
    }

    /// Windings that carry the current [1].
    #[getter]
    fn inductance_windings(&self) -> f64 {
        self.0.inductance_windings()
    }

    /// Masses of the chain that stands for the spring: the active windings rounded, at least 1.
    #[getter]
    fn chain_masses(&self) -> usize {
        self.0.chain_masses()
    }

    /// Shortest length in use [m].
    #[getter]
    fn min_length(&self) -> f64 {
        self.0.operating_range().0
    }

    /// Longest length in use [m].
    #[getter]
    fn max_length(&self) -> f64 {
        self.0.operating_range().1
    }

    /// Shortest and longest length in use [m], as a tuple.
    #[getter]
    fn operating_range(&self) -> (f64, f64) {
        self.0.operating_range()
    }

    /// Half way through the operating range [m].
    #[getter]
    fn mid_length(&self) -> f64 {
        self.0.mid_length()
    }

    /// Time in which a surge wave runs through the coil once [s]: tau = sqrt(m/k). Source: [Weijde2017] eq. 2.
    #[getter]
    fn transit_time(&self) -> f64 {
        self.0.transit_time()
    }

    /// f1: first surge frequency of the continuous coil with both ends held [Hz]: 1/(2 tau). Source: [Weijde2017] eq. 3.
    #[getter]
    fn surge_frequency(&self) -> f64 {
        self.0.surge_frequency()
    }

    /// F_nom: largest static force in use [N]. Source: [Weijde2017] eq. 14.
    #[getter]
    fn nominal_force(&self) -> f64 {
        self.0.nominal_force()
    }

    /// Wave impedance [N s/m]: sqrt(k m), what an impact adds to an end force per m/s.
    #[getter]
    fn wave_impedance(&self) -> f64 {
        self.0.wave_impedance()
    }

    /// Length with all active windings touching [m].
    #[getter]
    fn solid_length(&self) -> f64 {
        self.0.solid_length()
    }

    /// Distance from winding to winding when they are spread uniformly over a length.
    ///
    /// Parameters
    /// ----------
    /// length : float
    ///     l [m].
    ///
    /// Returns
    /// -------
    /// float
    ///     l/N [m].
    fn pitch_at(&self, length: f64) -> f64 {
        self.0.pitch_at(length)
    }

    /// Whether a length lies in the operating range, its ends included.
    ///
    /// Parameters
    /// ----------
    /// length : float
    ///     l [m].
    ///
    /// Returns
    /// -------
    /// bool
    fn in_operating_range(&self, length: f64) -> bool {
        self.0.in_operating_range(length)
    }

    /// Force of a spring without mass, tension positive.
    ///
    /// Parameters
    /// ----------
    /// length : float
    ///     l [m].
    ///
    /// Returns
    /// -------
    /// float
    ///     k (l - l0) [N].
    ///
    /// Notes
    /// -----
    /// Source: Hooke's law; the paper's F_x.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> round(coilsense.Spring.of_paper("S_T").static_force(0.264), 6)
    /// 121.6
    fn static_force(&self, length: f64) -> f64 {
        self.0.static_force(length)
    }

    /// The parameters by name, as the constructor takes them.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        self.arguments(py)
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<NewArguments<'py>> {
        Ok(value::new_arguments(self.arguments(py)?))
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        crate::html::shown(slf.as_any(), "spring")
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        value::shown("Spring", &self.arguments(py)?)
    }
}
