//! `coilsense.Stream` and `Live`: the motion step by step, in constant memory.
//!
//! Next door: the same for all times at once (`motion`).

use coilsense::Mount;
use coilsense::motion::{ForceSample, Live, Stream};
use coilsense_lab::quantity::Dimension::{Length, Time};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::long_work::taken;
use crate::motion::PyMotion;
use crate::mount::PyMount;
use crate::quantity::Quantity;
use crate::spring::PySpring;

/// t [s], F_i [N], F_o [N].
type Sample = (f64, f64, f64);

/// The same for many samples.
type Samples<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

fn sample(forces: ForceSample) -> Sample {
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

/// A spring whose inputs come one sample at a time, straight from sample to sample (first-order hold).
///
/// Parameters
/// ----------
/// spring : Spring
///     The spring, at rest at first.
/// mean_length : float or str
///     Its length then [m].
/// step : float or str
///     Time from sample to sample [s].
/// mount : Mount, optional
///     What end 2 is tied to, and damping; without it both positions prescribed, no damping.
///
/// Raises
/// ------
/// Error
///     For a length or step that is not above zero, and damping as `Motion`.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> live = coilsense.Live(coilsense.Spring.of_paper("S_T"), 0.23, 1e-3)
/// >>> t, F_i, F_o = live.advance(0.0, 0.2301)  # end 2 moves by 0.1 mm within a millisecond
/// >>> t, round(F_o - 95.76, 3)
/// (0.001, 0.565)
#[pyclass(name = "Live", module = "coilsense")]
pub struct PyLive(Live);

#[pymethods]
impl PyLive {
    #[new]
    #[pyo3(signature = (spring, mean_length, step, mount=None))]
    fn new(
        spring: &PySpring,
        mean_length: Quantity,
        step: Quantity,
        mount: Option<PyRef<'_, PyMount>>,
    ) -> PyResult<Self> {
        let (mean_length, step) = (mean_length.si("mean_length", Length)?, step.si("step", Time)?);
        let mount = mount.map_or_else(Mount::default, |mount| mount.0.clone());
        Live::new(&spring.0, &mount, mean_length, step).python().map(Self)
    }

    /// Goes on by one step.
    ///
    /// Parameters
    /// ----------
    /// u1 : float
    ///     Where end 1 then is [m], as `Signals` has it: 0 at first.
    /// end2 : float
    ///     u2 [m], as `Signals` has it: the mean length at first. Where end 2's position is not prescribed, the force on it [N], tension positive:
    ///     k (mean length - l0) at first.
    ///
    /// Returns
    /// -------
    /// t, F_i, F_o : float
    ///     [s], [N], [N].
    ///
    /// Raises
    /// ------
    /// Error
    ///     For a number that is not finite, or ends that have passed each other; the spring then stays where it is.
    fn advance(&mut self, u1: f64, end2: f64) -> PyResult<Sample> {
        self.0.advance_to([u1, end2]).python().map(sample)
    }
}
