//! `coilsense.Estimate`: a value with its interval.
//!
//! Next door: what is estimated (`identification`).

use coilsense::identify::Estimate;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::value::{self, Arguments, NewArguments};

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyEstimate>()
}

/// What was found, and how far to trust it; ``float()`` of it is its value.
///
/// Parameters
/// ----------
/// value : float
///     In SI units.
/// standard : float
///     Standard uncertainty, in the same unit.
/// expanded : float
///     Half the width of the interval that holds the true value with a probability of 95 %.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> stiffness = coilsense.Estimate(760.0, 0.5, 1.0)
/// >>> stiffness.low, stiffness.high, 760.8 in stiffness
/// (759.0, 761.0, True)
#[pyclass(name = "Estimate", module = "coilsense", frozen, eq)]
#[derive(Clone, PartialEq)]
pub struct PyEstimate(pub Estimate);

impl PyEstimate {
    fn arguments<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        dict.set_item("value", self.0.value)?;
        dict.set_item("standard", self.0.standard)?;
        dict.set_item("expanded", self.0.expanded)?;
        Ok(dict)
    }
}

#[pymethods]
impl PyEstimate {
    #[new]
    fn new(value: f64, standard: f64, expanded: f64) -> Self {
        Self(Estimate { value, standard, expanded })
    }

    /// The value, in SI units.
    #[getter]
    fn value(&self) -> f64 {
        self.0.value
    }

    /// Standard uncertainty, in the same unit.
    #[getter]
    fn standard(&self) -> f64 {
        self.0.standard
    }

    /// Half the width of the 95 % interval, in the same unit.
    #[getter]
    fn expanded(&self) -> f64 {
        self.0.expanded
    }

    /// Lower end of the 95 % interval.
    #[getter]
    fn low(&self) -> f64 {
        self.0.value - self.0.expanded
    }

    /// Upper end of the 95 % interval.
    #[getter]
    fn high(&self) -> f64 {
        self.0.value + self.0.expanded
    }

    /// Value, standard uncertainty and half width by name.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        self.arguments(py)
    }

    fn __float__(&self) -> f64 {
        self.0.value
    }

    fn __contains__(&self, value: f64) -> bool {
        self.0.holds(value)
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<NewArguments<'py>> {
        Ok(value::new_arguments(self.arguments(py)?))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        value::shown("Estimate", &self.arguments(py)?)
    }
}
