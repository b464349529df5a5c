//! `coilsense.Mount`, `FarEnd` and `Damping`: what end 2 is tied to, and what damps the windings.
//!
//! Next door: how the ends are driven (`excitation`).

mod damping;
mod far_end;

use coilsense::{Damping, FarEnd, Mount};
use pyo3::prelude::*;

pub use damping::PyDamping;
pub use far_end::PyFarEnd;

use crate::errors::IntoPython;
use crate::noun::{Noun, named};
use crate::value::{getters, named_value};

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

getters! {
    PyMount, self;
    /// What end 2 is tied to.
    far_end: PyFarEnd = PyFarEnd(self.0.far_end());
    /// What damps the windings.
    damping: PyDamping = PyDamping(self.0.damping().clone());
}

named_value! {
    /// The arguments by name, nouns as dicts of their own.
    PyMount, self;
    far_end, damping,
}

#[pymethods]
impl PyMount {
    #[new]
    #[pyo3(signature = (far_end=None, damping=None))]
    fn new(far_end: Option<Noun<'_, PyFarEnd>>, damping: Option<Noun<'_, PyDamping>>) -> PyResult<Self> {
        let far_end = named(far_end.as_ref(), "far_end")?;
        let damping = named(damping.as_ref(), "damping")?;
        let far_end = far_end.map_or(FarEnd::Position, |far_end| far_end.0);
        Mount::new(far_end, damping.map_or(Damping::None, |damping| damping.0.clone())).python().map(Self)
    }
}
