//! `coilsense.InductanceSensor`: a meter of L with a calibration; and the theories of a coil side by side.
//!
//! Next door: the coil by its windings (`maxwell_sum`), what is fitted to measurements (`calibration`).

use coilsense::inductance::theories::{Coil, Theory};
use coilsense::{Calibration, InductanceSensor, Spring};
use coilsense_lab::quantity::Dimension;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::IntoPython;
use crate::long_work::each;
use crate::maxwell_sum::PyMaxwellSum;
use crate::noun::Noun;
use crate::quantity::Quantity;
use crate::samples::Samples;
use crate::spring::PySpring;
use crate::value::{getters, named_value};

/// A meter of L with a calibration: L in, F_L out.
///
/// Parameters
/// ----------
/// spring : Spring
///     The spring that it is on.
/// alpha : float
///     Of eq. (13), 1/l = alpha L + beta [1/(H m)], not zero.
/// beta : float
///     Of eq. (13) [1/m].
///
/// Raises
/// ------
/// Error
///     For an alpha that is zero or not finite, or a beta that is not finite.
///
/// Notes
/// -----
/// F_L = k (1 / (alpha L + beta) - l0). Source: [Weijde2017] eq. 13 and section III-C.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> coil = coilsense.MaxwellSum(coilsense.Spring.of_paper("S_T"))
/// >>> sensor = coilsense.InductanceSensor.theoretical(coil, 0.23)
/// >>> sensor.force(coil.at_lengths([0.23])).round(9)  # at the preload it is right
/// array([95.76])
#[pyclass(name = "InductanceSensor", module = "coilsense", frozen)]
pub struct PyInductanceSensor {
    sensor: InductanceSensor,
    spring: Spring,
}

impl PyInductanceSensor {
    fn of(spring: &Spring, calibration: Calibration) -> Self {
        Self { sensor: InductanceSensor::new(spring, calibration), spring: spring.clone() }
    }
}

getters! {
    PyInductanceSensor, self;
    /// The spring that it is on.
    spring: PySpring = PySpring(self.spring.clone());
    /// Of eq. (13) [1/(H m)].
    alpha: f64 = self.sensor.calibration().alpha();
    /// Of eq. (13) [1/m].
    beta: f64 = self.sensor.calibration().beta();
}

named_value! {
    /// The arguments by name, the spring as a dict.
    PyInductanceSensor, self;
    spring, alpha, beta,
}

#[pymethods]
impl PyInductanceSensor {
    #[new]
    fn new(spring: Noun<'_, PySpring>, alpha: Quantity, beta: Quantity) -> PyResult<Self> {
        let spring = spring.named("spring")?;
        let (alpha, beta) = (alpha.plain("alpha")?, beta.plain("beta")?);
        Ok(Self::of(&spring.0, Calibration::new(alpha, beta).python()?))
    }

    /// Calibrated by a coil's own theory: uniform windings over the operating range, through a preload.
    ///
    /// Parameters
    /// ----------
    /// coil : MaxwellSum
    ///     The theory, and the spring.
    /// preload_length : float or str
    ///     Where it is right [m].
    ///
    /// Returns
    /// -------
    /// InductanceSensor
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coil = coilsense.MaxwellSum(coilsense.Spring.of_paper("S_T"))
    /// >>> sensor = coilsense.InductanceSensor.theoretical(coil, "230 mm")
    /// >>> round(sensor.force(coil.at_lengths(0.23)), 6)
    /// 95.76
    #[staticmethod]
    fn theoretical(py: Python<'_>, coil: Noun<'_, PyMaxwellSum>, preload_length: Quantity) -> PyResult<Self> {
        let coil = coil.named("coil")?;
        let preload_length = preload_length.si("preload_length", Dimension::Length)?;
        let fitted = py.detach(|| Calibration::theoretical(&coil.spring, &coil.sum, preload_length));
        Ok(Self::of(&coil.spring, fitted.python()?))
    }

    /// F_L.
    ///
    /// Parameters
    /// ----------
    /// inductance : float, str or array_like of float
    ///     L [H].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the inductance
    ///     [N].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coil = coilsense.MaxwellSum(coilsense.Spring.of_paper("S_T"))
    /// >>> sensor = coilsense.InductanceSensor.theoretical(coil, 0.23)
    /// >>> sensor.force([[3e-6, 2.9e-6]]).shape
    /// (1, 2)
    fn force<'py>(&self, py: Python<'py>, inductance: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        let force = self.sensor.force(&inductance.si("inductance", Dimension::Inductance)?);
        inductance.shaped(py, force)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            self.spring == other.spring && (self.alpha(), self.beta()) == (other.alpha(), other.beta())
        })
    }
}

/// The inductance of a spring's coil by every theory, side by side.
///
/// Parameters
/// ----------
/// spring : Spring
///     The spring, its windings uniform.
/// lengths : float, str or array_like of float
///     l [m], above zero.
///
/// Returns
/// -------
/// dict of str to float or numpy.ndarray, of the shape of the lengths
///     L [H] by the theory's name, the simplest theory first; NaN for a length that is not above zero.
///
/// Raises
/// ------
/// Error
///     For a coil that the theories cannot take.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> found = coilsense.theories(coilsense.Spring.of_paper("S_T"), [0.23])
/// >>> all(2.7e-6 < L[0] < 3.1e-6 for L in found.values()), len(found)
/// (True, 9)
#[pyfunction]
pub fn theories<'py>(
    py: Python<'py>,
    spring: Noun<'_, PySpring>,
    lengths: Samples<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let spring = spring.named("spring")?;
    let (coil, each_length) = (Coil::of(&spring.0).python()?, lengths.si("lengths", Dimension::Length)?);
    let dict = PyDict::new(py);
    for theory in Theory::ALL {
        let found = each(py, &each_length, |length| theory.inductance(&coil, length))?;
        dict.set_item(theory.name(), lengths.shaped(py, found)?)?;
    }
    Ok(dict)
}
