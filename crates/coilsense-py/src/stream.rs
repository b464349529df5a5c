//! `coilsense.Stream`: the motion step by step, in constant memory.
//!
//! Next door: the same for all times at once (`motion`), for inputs as they come (`live`).

use coilsense::motion::{ForceSample, Stream};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::long_work::taken;
use crate::motion::PyMotion;

/// t [s], F_i [N], F_o [N].
pub type Sample = (f64, f64, f64);

/// The same for many samples.
pub type Samples<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

/// As Python has it.
pub fn sample(forces: ForceSample) -> Sample {
    (forces.time, forces.input, forces.output)
}

/// Forces of a motion at t = 0, h, 2h, ..., one after the other and without end; made by `Motion.stream`.
///
/// An iterator of (t [s], F_i [N], F_o [N]).
#[pyclass(name = "Stream", module = "coilsense")]
pub struct PyStream(Stream<'static>);

impl PyStream {
    /// The stream of a motion.
    pub fn of(motion: &PyMotion, step: f64) -> PyResult<Self> {
        motion.0.clone().into_stream(step).python().map(Self)
    }
}

#[pymethods]
impl PyStream {
    /// The next samples at once.
    ///
    /// Parameters
    /// ----------
    /// count : int
    ///     How many.
    ///
    /// Returns
    /// -------
    /// times, F_i, F_o : numpy.ndarray, shape (count,)
    ///     [s], [N], [N].
    ///
    /// Notes
    /// -----
    /// Ctrl-C ends it; the stream then goes on behind the samples that were computed.
    fn take<'py>(&mut self, py: Python<'py>, count: usize) -> PyResult<Samples<'py>> {
        let forces: Vec<ForceSample> = taken(py, &mut self.0, count)?;
        let series = |part: fn(&ForceSample) -> f64| forces.iter().map(part).collect::<Vec<_>>().into_pyarray(py);
        Ok((series(|at| at.time), series(|at| at.input), series(|at| at.output)))
    }

    fn __iter__(slf: PyRef<'_, Self>) -> PyRef<'_, Self> {
        slf
    }

    fn __next__(&mut self) -> Option<Sample> {
        self.0.next().map(sample)
    }
}
