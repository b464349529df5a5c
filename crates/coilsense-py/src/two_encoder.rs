//! `coilsense.TwoEncoder`: force from two encoders with a drive train between.
//!
//! Next door: what each encoder makes of its position (`readout`).

use coilsense::Spring;
use coilsense::sensors::TwoEncoder;
use coilsense_lab::quantity::Dimension::{Compliance, Force, Length};
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::noun::Noun;
use crate::quantity::Quantity;
use crate::samples::{Samples, Together};
use crate::spring::PySpring;
use crate::value::{getters, named_value};

/// An encoder on the motor's side of the drive train and one at end 2, of a series elastic actuator; zeroed under a static load.
///
/// Parameters
/// ----------
/// spring : Spring
///     The spring between them.
/// compliance : float or str
///     c of the drive train [m/N], not below zero.
/// backlash : float or str
///     b of the drive train, the whole gap [m], not below zero.
/// mean_length : float or str
///     Length at which it was zeroed [m].
///
/// Raises
/// ------
/// Error
///     For a compliance or backlash below zero, or a value that is not finite.
///
/// Notes
/// -----
/// k_s = 1 / (1/k + c); a static load at the mean length reads exactly. Valid for a massless drive train, linear but for its gap.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> encoders = coilsense.TwoEncoder(coilsense.Spring.of_paper("S_T"), compliance=1e-5, backlash=2e-4, mean_length=0.204)
/// >>> encoders.force(encoders.elongation([0.0], [0.204], [76.0])).round(9)
/// array([76.])
#[pyclass(name = "TwoEncoder", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyTwoEncoder {
    encoders: TwoEncoder,
    spring: Spring,
    compliance: f64,
    backlash: f64,
    mean_length: f64,
}

getters! {
    PyTwoEncoder, self;
    /// The spring between them.
    spring: PySpring = PySpring(self.spring.clone());
    /// c of the drive train [m/N].
    compliance: f64 = self.compliance;
    /// b of the drive train, the whole gap [m].
    backlash: f64 = self.backlash;
    /// Length at which it was zeroed [m].
    mean_length: f64 = self.mean_length;
    /// k_s: stiffness of spring and drive train in series [N/m].
    stiffness: f64 = self.encoders.stiffness();
    /// Elongation at which it reads no force [m].
    zero: f64 = self.encoders.zero();
}

named_value! {
    /// The arguments by name, the spring as a dict.
    PyTwoEncoder, self;
    spring, compliance, backlash, mean_length,
}

#[pymethods]
impl PyTwoEncoder {
    #[new]
    fn new(
        spring: Noun<'_, PySpring>,
        compliance: Quantity,
        backlash: Quantity,
        mean_length: Quantity,
    ) -> PyResult<Self> {
        let spring = spring.named("spring")?;
        let compliance = compliance.si("compliance", Compliance)?;
        let (backlash, mean_length) = (backlash.si("backlash", Length)?, mean_length.si("mean_length", Length)?);
        let encoders = TwoEncoder::new(&spring.0, compliance, backlash, mean_length).python()?;
        Ok(Self { encoders, spring: spring.0.clone(), compliance, backlash, mean_length })
    }

    /// Distance between the two encoders.
    ///
    /// Parameters
    /// ----------
    /// u1, u2 : float, str or array_like of float
    ///     Positions of the spring's ends [m].
    /// f_i : float, str or array_like of float
    ///     Force at end 1 [N], tension positive.
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the three together
    ///     u2 - u_motor = (u2 - u1) + c F_i + (b/2) sgn F_i [m].
    ///
    /// Raises
    /// ------
    /// Error
    ///     For shapes that do not go together, or a value beyond 1e9 either way.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> encoders = coilsense.TwoEncoder(coilsense.Spring.of_paper("S_T"), compliance="10 um/N", backlash="0.2 mm", mean_length="204 mm")
    /// >>> round(encoders.elongation(0.0, "204 mm", "76 N"), 6)
    /// 0.20486
    fn elongation<'py>(
        &self,
        py: Python<'py>,
        u1: Samples<'py>,
        u2: Samples<'py>,
        f_i: Samples<'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let all = Together::of(py, [(&u1, "u1", Length), (&u2, "u2", Length), (&f_i, "f_i", Force)])?;
        let [u1, u2, f_i] = &all.values;
        all.shaped(py, self.encoders.elongation(u1, u2, f_i).python()?)
    }

    /// Force that the two encoders tell.
    ///
    /// Parameters
    /// ----------
    /// elongation : float, str or array_like of float
    ///     As `elongation` gives it, through an instrument or not [m].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the elongation
    ///     k_s (e - zero) [N].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> encoders = coilsense.TwoEncoder(coilsense.Spring.of_paper("S_T"), compliance="10 um/N", backlash="0.2 mm", mean_length="204 mm")
    /// >>> round(encoders.force(encoders.zero), 9)
    /// 0.0
    fn force<'py>(&self, py: Python<'py>, elongation: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        let force = self.encoders.force(&elongation.si("elongation", Length)?);
        elongation.shaped(py, force)
    }
}
