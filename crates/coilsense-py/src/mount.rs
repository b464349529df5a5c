//! `coilsense.Mount`, `FarEnd` and `Damping`: what end 2 is tied to, and what damps the windings.
//!
//! Next door: how the ends are driven (`excitation`).

mod damping;
mod far_end;

use coilsense::{Damping, FarEnd, Mount};
use pyo3::prelude::*;
use pyo3::types::PyDict;

pub use damping::PyDamping;
pub use far_end::PyFarEnd;

use crate::errors::IntoPython;
use crate::value::{self, Arguments, NewArguments};

/// Adds the classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyDamping>()?;
    module.add_class::<PyFarEnd>()?;
    module.add_class::<PyMount>()
}

/// End 2 and damping. End 1 always has a prescribed position.
///
/// Parameters
/// ----------
/// far_end : FarEnd, optional
///     What end 2 is tied to; without it a prescribed position, the paper's case.
/// damping : Damping, optional
///     What damps the windings; none without it, the paper's case.
///
/// Examples
/// --------
/// >>> from coilsense import Damping, FarEnd, Mount
/// >>> Mount(FarEnd.mass(0.5), Damping.modal(0.005)).damping
/// Damping.modal(ratio=0.005)
#[pyclass(name = "Mount", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyMount(pub Mount);

impl PyMount {
    fn arguments<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        dict.set_item("far_end", self.far_end().into_pyobject(py)?)?;
        dict.set_item("damping", self.damping().into_pyobject(py)?)?;
        Ok(dict)
    }
}

#[pymethods]
impl PyMount {
    #[new]
    #[pyo3(signature = (far_end=None, damping=None))]
    fn new(far_end: Option<PyRef<'_, PyFarEnd>>, damping: Option<PyRef<'_, PyDamping>>) -> PyResult<Self> {
        let far_end = far_end.map_or(FarEnd::Position, |far_end| far_end.0);
        Mount::new(far_end, damping.map_or(Damping::None, |damping| damping.0.clone())).python().map(Self)
    }

    /// What end 2 is tied to.
    #[getter]
    fn far_end(&self) -> PyFarEnd {
        PyFarEnd(self.0.far_end())
    }

    /// What damps the windings.
    #[getter]
    fn damping(&self) -> PyDamping {
        PyDamping(self.0.damping().clone())
    }

    /// The arguments by name, nouns as dicts of their own.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        value::plain(&self.arguments(py)?)
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<NewArguments<'py>> {
        Ok(value::new_arguments(self.arguments(py)?))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        value::shown("Mount", &self.arguments(py)?)
    }
}
