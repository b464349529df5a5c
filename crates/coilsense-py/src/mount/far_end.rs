//! `coilsense.FarEnd`: what end 2 is tied to.
//!
//! Next door: what damps the windings (`damping`).

use coilsense::{Damping, FarEnd, Mount};
use pyo3::prelude::*;
use pyo3::types::PyType;

use crate::errors::IntoPython;
use crate::value::{self, Arguments, Kind};

const KINDS: [&str; 3] = ["position", "force", "mass"];

/// What end 2 is tied to.
///
/// Made by ``FarEnd.position``, ``force`` or ``mass``.
#[pyclass(name = "FarEnd", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyFarEnd(pub FarEnd);

impl PyFarEnd {
    fn as_kind<'py>(&self, py: Python<'py>) -> PyResult<Kind<'py>> {
        match self.0 {
            FarEnd::Position => Ok(Kind::new(py, "position")),
            FarEnd::Force => Ok(Kind::new(py, "force")),
            FarEnd::Mass(mass) => Kind::new(py, "mass").with("mass", mass),
        }
    }
}

#[pymethods]
impl PyFarEnd {
    /// A prescribed position; held where the input is. The paper's case.
    ///
    /// Returns
    /// -------
    /// FarEnd
    #[staticmethod]
    fn position() -> Self {
        Self(FarEnd::Position)
    }

    /// A prescribed force.
    ///
    /// Returns
    /// -------
    /// FarEnd
    #[staticmethod]
    fn force() -> Self {
        Self(FarEnd::Force)
    }

    /// A mass, pulled by the spring and by a prescribed force.
    ///
    /// Parameters
    /// ----------
    /// mass : float
    ///     [kg], above zero.
    ///
    /// Returns
    /// -------
    /// FarEnd
    #[staticmethod]
    fn mass(mass: f64) -> PyResult<Self> {
        let far_end = FarEnd::Mass(mass);
        Mount::new(far_end, Damping::None).python().map(|_| Self(far_end))
    }

    /// Which constructor makes it: "position", "force" or "mass".
    #[getter]
    fn kind(&self, py: Python<'_>) -> PyResult<&'static str> {
        Ok(self.as_kind(py)?.name)
    }

    /// Its kind and its arguments by name.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        self.as_kind(py)?.to_dict()
    }

    /// The way back from `to_dict`.
    ///
    /// Parameters
    /// ----------
    /// dict : dict
    ///     The kind, and the arguments of the constructor of that name.
    ///
    /// Returns
    /// -------
    /// FarEnd
    #[classmethod]
    fn from_dict<'py>(class: &Bound<'py, PyType>, dict: Arguments<'py>) -> PyResult<Bound<'py, PyAny>> {
        value::of_dict(class, &dict, &KINDS)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (Arguments<'py>,))> {
        slf.get().as_kind(slf.py())?.reduced(slf.get_type().as_any())
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        self.as_kind(py)?.shown("FarEnd")
    }
}
