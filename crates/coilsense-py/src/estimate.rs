//! `coilsense.Estimate`: a value with its interval.
//!
//! Next door: what is estimated (`identification`).

use coilsense::identify::Estimate;
use pyo3::prelude::*;

use crate::quantity::Quantity;
use crate::value::{getters, named_value};

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

getters! {
    PyEstimate, self;
    /// The value, in SI units.
    value: f64 = self.0.value;
    /// Standard uncertainty, in the same unit.
    standard: f64 = self.0.standard;
    /// Half the width of the 95 % interval, in the same unit.
    expanded: f64 = self.0.expanded;
    /// Lower end of the 95 % interval.
    low: f64 = self.0.value - self.0.expanded;
    /// Upper end of the 95 % interval.
    high: f64 = self.0.value + self.0.expanded;
}

named_value! {
    /// Value, standard uncertainty and half width by name.
    PyEstimate, self;
    value, standard, expanded,
}

#[pymethods]
impl PyEstimate {
    #[new]
    fn new(value: Quantity, standard: Quantity, expanded: Quantity) -> PyResult<Self> {
        let (value, standard) = (value.plain("value")?, standard.plain("standard")?);
        Ok(Self(Estimate { value, standard, expanded: expanded.plain("expanded")? }))
    }

    fn __float__(&self) -> f64 {
        self.0.value
    }

    fn __contains__(&self, value: f64) -> bool {
        self.0.holds(value)
    }
}
