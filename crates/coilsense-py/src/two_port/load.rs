//! `coilsense.Load`: what hangs on end 2, over frequency.
//!
//! Next door: the spring that carries it (the parent).

use coilsense::two_port::Load;
use coilsense_lab::quantity::Dimension;
use num_complex::Complex64;
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::quantity::Quantity;
use crate::value::{Kind, value_of_kinds};

/// A load at end 2, by the force over the displacement it answers with.
///
/// Made by ``Load.held``, ``free``, ``mass`` or ``stiffness``.
#[pyclass(name = "Load", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyLoad(Load);

/// The load, held where none is given.
pub fn given(load: Option<PyRef<'_, PyLoad>>) -> Load {
    load.map_or(Load::HELD, |load| load.0)
}

impl PyLoad {
    fn as_kind<'py>(&self, py: Python<'py>) -> PyResult<Kind<'py>> {
        // Where K_L changes with frequency it is that of a mass.
        match (self.0.at(0.0), self.0.at(1.0)) {
            (None, _) => Ok(Kind::new(py, "held")),
            (Some(still), Some(moving)) if still != moving => Kind::new(py, "mass").with("mass", -moving.re),
            (Some(stiffness), _) if self.0 == Load::FREE || stiffness == Complex64::ZERO => Ok(Kind::new(py, "free")),
            (Some(stiffness), _) => {
                Kind::new(py, "stiffness").with("real", stiffness.re)?.with("imaginary", stiffness.im)
            }
        }
    }
}

value_of_kinds! {
    /// Which constructor makes it: "held", "free", "mass" or "stiffness".
    PyLoad, "Load"; "held", "free", "mass", "stiffness"
}

#[pymethods]
impl PyLoad {
    /// End 2 does not move.
    ///
    /// Returns
    /// -------
    /// Load
    #[staticmethod]
    fn held() -> Self {
        Self(Load::HELD)
    }

    /// Nothing at end 2.
    ///
    /// Returns
    /// -------
    /// Load
    #[staticmethod]
    fn free() -> Self {
        Self(Load::FREE)
    }

    /// A rigid mass.
    ///
    /// Parameters
    /// ----------
    /// mass : float or str
    ///     M [kg], from zero on.
    ///
    /// Returns
    /// -------
    /// Load
    #[staticmethod]
    fn mass(mass: Quantity) -> PyResult<Self> {
        let mass = mass.si("mass", Dimension::Mass)?;
        // No mass is no load.
        if mass == 0.0 { Ok(Self::free()) } else { Load::mass(mass).python().map(Self) }
    }

    /// Any linear load, by its force over displacement at the frequency in question.
    ///
    /// Parameters
    /// ----------
    /// real, imaginary : float or str
    ///     Parts of K_L [N/m]; a mechanical impedance Z_L is K_L = j omega Z_L.
    ///
    /// Returns
    /// -------
    /// Load
    #[staticmethod]
    #[pyo3(signature = (real, imaginary=Quantity::Number(0.0)), text_signature = "(real, imaginary=0.0)")]
    fn stiffness(real: Quantity, imaginary: Quantity) -> PyResult<Self> {
        let (real, imaginary) =
            (real.si("real", Dimension::Stiffness)?, imaginary.si("imaginary", Dimension::Stiffness)?);
        Load::stiffness(Complex64::new(real, imaginary)).python().map(Self)
    }
}
