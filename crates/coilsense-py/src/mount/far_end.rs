//! `coilsense.FarEnd`: what end 2 is tied to.
//!
//! Next door: what damps the windings (`damping`).

use coilsense::{Damping, FarEnd, Mount};
use coilsense_lab::quantity::Dimension;
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::quantity::Quantity;
use crate::value::{Kind, value_of_kinds};

/// What end 2 is tied to.
///
/// Made by ``FarEnd.position``, ``force`` or ``mass``.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> coilsense.FarEnd.mass("500 g")
/// FarEnd.mass(mass=0.5)
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

value_of_kinds! {
    /// Which constructor makes it: "position", "force" or "mass".
    PyFarEnd, "FarEnd"; "position", "force", "mass"
}

#[pymethods]
impl PyFarEnd {
    /// A prescribed position; held where the input is. The paper's case.
    ///
    /// Returns
    /// -------
    /// FarEnd
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Mount(coilsense.FarEnd.position()) == coilsense.Mount()
    /// True
    #[staticmethod]
    fn position() -> Self {
        Self(FarEnd::Position)
    }

    /// A prescribed force.
    ///
    /// Returns
    /// -------
    /// FarEnd
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.FarEnd.force().kind
    /// 'force'
    #[staticmethod]
    fn force() -> Self {
        Self(FarEnd::Force)
    }

    /// A mass, pulled by the spring and by a prescribed force.
    ///
    /// Parameters
    /// ----------
    /// mass : float or str
    ///     [kg], above zero.
    ///
    /// Returns
    /// -------
    /// FarEnd
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> modes = coilsense.ChainModes(coilsense.Spring.of_paper("S_T"), coilsense.FarEnd.mass("500 g"))
    /// >>> print(f"{modes.frequencies[0]:.2f} Hz")
    /// 6.07 Hz
    #[staticmethod]
    fn mass(mass: Quantity) -> PyResult<Self> {
        let far_end = FarEnd::Mass(mass.si("mass", Dimension::Mass)?);
        Mount::new(far_end, Damping::None).python().map(|_| Self(far_end))
    }
}
