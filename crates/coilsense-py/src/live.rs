//! `coilsense.Live`: a spring whose inputs come one sample at a time.
//!
//! Next door: many of them at once (`live_batch`), inputs known beforehand (`stream`).

use coilsense::Mount;
use coilsense::motion::Live;
use coilsense_lab::quantity::Dimension::{Length, Time};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{IntoPython, refused};
use crate::mount::PyMount;
use crate::quantity::Quantity;
use crate::series::Series;
use crate::spring::PySpring;
use crate::stream::{Sample, sample};
use crate::value::{self, getters};

/// What makes it anew, its arguments, and its state.
type Reduced<'py> = (Bound<'py, PyAny>, (PySpring, f64, f64, PyMount), Bound<'py, PyArray1<f64>>);

/// A spring whose inputs come one sample at a time, straight from sample to sample (first-order hold).
///
/// Windings never touch here: nothing tells where they would meet.
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
/// >>> saved = live.state
/// >>> once = live.advance(0.0, 0.2301)
/// >>> live.state = saved
/// >>> live.advance(0.0, 0.2301) == once
/// True
#[pyclass(name = "Live", module = "coilsense")]
pub struct PyLive(pub Live);

getters! {
    PyLive, self;
    /// The spring.
    spring: PySpring = PySpring(self.0.spring().clone());
    /// What its end 2 is tied to, and its damping.
    mount: PyMount = PyMount(self.0.mount().clone());
    /// The length at which it was made at rest [m].
    mean_length: f64 = self.0.mean_length();
    /// Time from sample to sample [s].
    step: f64 = self.0.step();
    /// t [s]: a step for each since it was made or `reset`.
    time: f64 = self.0.time();
}

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

    /// Back to t = 0, at rest: windings evenly between the ends, nothing moves.
    ///
    /// Parameters
    /// ----------
    /// u1, end2 : float, optional
    ///     Where it rests, as `advance` takes them; where it was made without them.
    ///
    /// Returns
    /// -------
    /// None
    ///
    /// Raises
    /// ------
    /// Error
    ///     As `advance`.
    #[pyo3(signature = (u1=None, end2=None))]
    fn reset(&mut self, u1: Option<f64>, end2: Option<f64>) -> PyResult<()> {
        let [first, second] = self.0.mean_ends();
        self.0.reset([u1.unwrap_or(first), end2.unwrap_or(second)]).python()
    }

    /// All that the next steps depend on, shape (2 modes + 5,): the modes' coordinates [m], their rates [m/s], both inputs about their means (u1 [m];
    /// u2 [m] or the force at end 2 [N]), their rates over the last step, and the steps taken. A copy; assigned to a spring made alike, that one goes
    /// on from there with the same bits.
    #[getter]
    fn state<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.0.state().into_pyarray(py)
    }

    #[setter]
    fn set_state(&mut self, state: Series<'_>) -> PyResult<()> {
        self.0.set_state(&state.values("state")?).python()
    }

    /// Another spring that goes on from here by itself, with the same bits.
    ///
    /// Returns
    /// -------
    /// Live
    fn copy(&self) -> Self {
        Self(self.0.clone())
    }

    fn __copy__(&self) -> Self {
        self.copy()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.copy()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        let Ok(other) = other.cast::<Self>() else { return false };
        // A spring that is compared with itself is borrowed twice, which is one too many only where it moves.
        other.try_borrow().is_ok_and(|other| is_alike(&self.0, &other.0) && self.0.state() == other.0.state())
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        let (class, live) = (slf.get_type().into_any(), slf.borrow());
        // A spring travels by its numbers, which are those of a uniform coil.
        if live.0.spring().parameters().sections.is_some() {
            return Err(refused(
                "spring of a live spring must be a uniform coil to be pickled, got sections; copy() takes them",
            ));
        }
        Ok((class, (live.spring(), live.mean_length(), live.step(), live.mount()), live.state(slf.py())))
    }

    fn __setstate__(&mut self, state: Series<'_>) -> PyResult<()> {
        self.set_state(state)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let arguments = PyDict::new(py);
        arguments.set_item("spring", self.spring())?;
        arguments.set_item("mean_length", self.mean_length())?;
        arguments.set_item("step", self.step())?;
        arguments.set_item("mount", self.mount())?;
        Ok(format!("<{} at t = {} s>", value::shown("Live", &arguments)?, self.time()))
    }
}

/// Whether two were made alike, whatever they do.
fn is_alike(one: &Live, other: &Live) -> bool {
    let made = |live: &Live| (live.spring().clone(), live.mount().clone(), live.mean_length(), live.step());
    made(one) == made(other)
}
