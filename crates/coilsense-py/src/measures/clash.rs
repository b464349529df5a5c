//! `coilsense.Clash`: windings that touch, where the linear model ends.
//!
//! Next door: forces that are off (`deviation`).

use coilsense::Clash;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::IntoPython;
use crate::motion::PyMotion;
use crate::series::Series;
use crate::value::{self, Arguments, NewArguments};

/// How near neighbouring windings come over a motion.
///
/// Made by ``Clash.of``; the constructor takes what is known already.
///
/// Parameters
/// ----------
/// smallest_pitch : float
///     Smallest distance between neighbouring windings [m], centre to centre; infinite for a single winding.
/// time : float
///     When [s].
/// winding : int
///     The lower-numbered of the two windings, from 1.
/// contact_pitch : float
///     At this pitch windings touch [m].
/// first_contact : float or None
///     First time at which they touch [s]; None where they stay clear.
#[pyclass(name = "Clash", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyClash(pub Clash);

impl PyClash {
    fn arguments<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        dict.set_item("smallest_pitch", self.0.smallest_pitch)?;
        dict.set_item("time", self.0.time)?;
        dict.set_item("winding", self.0.winding)?;
        dict.set_item("contact_pitch", self.0.contact_pitch)?;
        dict.set_item("first_contact", self.0.first_contact)?;
        Ok(dict)
    }
}

#[pymethods]
impl PyClash {
    #[new]
    #[pyo3(signature = (*, smallest_pitch, time, winding, contact_pitch, first_contact))]
    fn new(smallest_pitch: f64, time: f64, winding: usize, contact_pitch: f64, first_contact: Option<f64>) -> Self {
        Self(Clash { smallest_pitch, time, winding, contact_pitch, first_contact })
    }

    /// Of a motion, watched at some times; the first contact is then refined between samples.
    ///
    /// Parameters
    /// ----------
    /// motion : Motion
    ///     The motion.
    /// times : array_like of float, shape (samples,)
    ///     [s], strictly increasing.
    /// contact_pitch : float, optional
    ///     At this pitch windings touch [m]; without it the wire's diameter.
    ///
    /// Returns
    /// -------
    /// Clash
    ///
    /// Raises
    /// ------
    /// Error
    ///     For no times, or a time that is not finite, below zero, or not after its predecessor.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
    /// >>> coilsense.Clash.of(motion, coilsense.sampled_window(10_000, 0.0, 0.1)).happens
    /// False
    #[staticmethod]
    #[pyo3(signature = (motion, times, contact_pitch=None))]
    fn of(py: Python<'_>, motion: &PyMotion, times: Series<'_>, contact_pitch: Option<f64>) -> PyResult<Self> {
        let times = times.values();
        let found = py.detach(|| match contact_pitch {
            None => Clash::of(&motion.0, &times),
            Some(pitch) => Clash::seen(&motion.0, &times, &motion.0.windings(&times)?, pitch),
        });
        found.python().map(Self)
    }

    /// Smallest distance between neighbouring windings [m], centre to centre; infinite for a single winding.
    #[getter]
    fn smallest_pitch(&self) -> f64 {
        self.0.smallest_pitch
    }

    /// When they are that near [s].
    #[getter]
    fn time(&self) -> f64 {
        self.0.time
    }

    /// The lower-numbered of the two windings, from 1.
    #[getter]
    fn winding(&self) -> usize {
        self.0.winding
    }

    /// At this pitch windings touch [m].
    #[getter]
    fn contact_pitch(&self) -> f64 {
        self.0.contact_pitch
    }

    /// First time at which they touch [s]; None where they stay clear.
    #[getter]
    fn first_contact(&self) -> Option<f64> {
        self.0.first_contact
    }

    /// Whether windings touch.
    #[getter]
    fn happens(&self) -> bool {
        self.0.happens()
    }

    /// Smallest distance between the wires' surfaces [m], below zero where they would overlap.
    #[getter]
    fn clearance(&self) -> f64 {
        self.0.clearance()
    }

    /// The values by name.
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

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        value::shown("Clash", &self.arguments(py)?)
    }
}
