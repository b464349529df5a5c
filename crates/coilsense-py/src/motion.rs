//! `coilsense.Motion`: how a spring moves, at any times.
//!
//! Next door: what is done to it (`excitation`), what comes out (`signals`, `windings`), step by step (`stream`).

mod kept;

use coilsense::modes::ChainModes;
use coilsense::{Motion, Mount};
use coilsense_lab::quantity::Dimension;
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::count::Count;
use crate::errors::IntoPython;
use crate::excitation::PyExcitation;
use crate::long_work::{each, of_series};
use crate::modes::PyChainModes;
use crate::mount::PyMount;
use crate::noun::{Noun, named};
use crate::quantity::Quantity;
use crate::samples::Samples;
use crate::series::Series;
use crate::signals::PySignals;
use crate::spring::PySpring;
use crate::stream::PyStream;
use crate::value::{Arguments, getters};
use crate::windings::PyWindings;

/// Forces at both ends.
type Forces<'py> = (Bound<'py, PyAny>, Bound<'py, PyAny>);

/// Motion of the paper's chain under one excitation.
///
/// Parameters
/// ----------
/// spring : Spring
///     The spring that moves.
/// excitation : Excitation
///     What is done to it.
/// mount : Mount, optional
///     What end 2 is tied to, and damping; without it the paper's: both positions prescribed, no damping. Where end 2's position is not
///     prescribed, its input is a force [N] about that of the mean length.
///
/// Raises
/// ------
/// Error
///     Where the excitation starts a number of windings that the spring's chain does not have, damping is given for another number of
///     modes, has a loss factor, or is above a ratio of 1000.
///
/// Notes
/// -----
/// Source: [Weijde2017] eqs. 4-7. Valid for windings that never touch. End forces and positions are within 1e-12 of their peak over 1 s,
/// against a 40-digit reference.
///
/// Examples
/// --------
/// >>> from coilsense import Excitation, Motion, Spring
/// >>> motion = Motion(Spring.of_paper("S_T"), Excitation.impact(0.23, 0.25))
/// >>> F_i, F_o = motion.end_forces([0.0, 0.75, 1.0])
/// >>> F_i[0].round(9)
/// np.float64(95.76)
#[pyclass(name = "Motion", module = "coilsense", frozen)]
pub struct PyMotion(pub Motion);

impl PyMotion {
    fn arguments<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        dict.set_item("spring", self.spring().into_pyobject(py)?)?;
        dict.set_item("excitation", self.excitation().into_pyobject(py)?)?;
        dict.set_item("mount", self.mount().into_pyobject(py)?)?;
        Ok(dict)
    }

    /// All modes of its chain.
    fn chain(&self) -> ChainModes {
        ChainModes::mounted(self.0.spring(), self.0.mount().far_end())
    }

    /// Steps of work that so many times are: one for each mode.
    fn steps(&self, times: usize) -> usize {
        times.saturating_mul(self.0.modes().count())
    }

    /// The same for the windings: of each mode to each winding, eight at a time.
    pub fn steps_of_windings(&self, times: usize) -> usize {
        self.steps(times).saturating_mul(self.0.spring().chain_masses().div_ceil(8))
    }

    /// How many modes a truncated motion has.
    fn kept_modes(&self) -> Option<usize> {
        let all = self.chain().count();
        Some(self.0.modes().count()).filter(|count| *count < all)
    }
}

getters! {
    PyMotion, self;
    /// The spring that moves.
    spring: PySpring = PySpring(self.0.spring().clone());
    /// What is done to it.
    excitation: PyExcitation = PyExcitation(self.0.excitation().clone());
    /// What its end 2 is tied to, and its damping.
    mount: PyMount = PyMount(self.0.mount().clone());
    /// Its modes.
    modes: PyChainModes = PyChainModes(self.chain().first(self.0.modes().count()));
    /// How far F_i and F_o of a truncated motion can be from those of all modes [N], as a tuple; zero where none is left out.
    truncation_bound: (f64, f64) = self.0.truncation_bound().into();
}

#[pymethods]
impl PyMotion {
    #[new]
    #[pyo3(signature = (spring, excitation, mount=None))]
    fn new(
        py: Python<'_>,
        spring: Noun<'_, PySpring>,
        excitation: Noun<'_, PyExcitation>,
        mount: Option<Noun<'_, PyMount>>,
    ) -> PyResult<Self> {
        let spring = spring.named("spring")?;
        let excitation = excitation.named("excitation")?;
        let mount = named(mount.as_ref(), "mount")?;
        let mount = mount.map_or_else(Mount::default, |mount| mount.0.clone());
        py.detach(|| Motion::mounted(&spring.0, &mount, &excitation.0)).python().map(Self)
    }

    /// Forces at both ends, tension positive.
    ///
    /// Parameters
    /// ----------
    /// times : float, str or array_like of float
    ///     [s], in any order, none below zero; equidistant ones in order are fastest.
    ///
    /// Returns
    /// -------
    /// F_i, F_o : float or numpy.ndarray, of the shape of the times
    ///     At end 1 and at end 2 [N].
    ///
    /// Raises
    /// ------
    /// Error
    ///     For no times, or the first that is not finite or below zero.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
    /// >>> F_i, F_o = motion.end_forces(0.1)
    /// >>> round(F_i, 3), round(F_o, 3)
    /// (98.035, 93.485)
    fn end_forces<'py>(slf: &Bound<'py, Self>, times: Samples<'py>) -> PyResult<Forces<'py>> {
        let (py, at) = (slf.py(), times.si("times", Dimension::Time)?);
        let steps = slf.get().steps(at.len());
        let forces = of_series(slf, steps, &at, |motion, times| motion.0.end_forces(times))?.python()?;
        Ok((times.shaped(py, forces.input)?, times.shaped(py, forces.output)?))
    }

    /// u1, u2, F_i, F_o and F_x over time; sensors add theirs.
    ///
    /// Parameters
    /// ----------
    /// times : array_like of float, shape (samples,)
    ///     [s], strictly increasing, none below zero.
    ///
    /// Returns
    /// -------
    /// Signals
    ///
    /// Raises
    /// ------
    /// Error
    ///     For the first time that is not finite, below zero, or not after its predecessor.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
    /// >>> signals = motion.signals(coilsense.sampled_window(1000, 0, 0.1))
    /// >>> list(signals), len(signals.time)
    /// (['u1', 'u2', 'F_i', 'F_o', 'F_x'], 101)
    fn signals(slf: &Bound<'_, Self>, times: Series<'_>) -> PyResult<PySignals> {
        let times = times.values("times")?;
        let steps = slf.get().steps(times.len());
        let signals = of_series(slf, steps, &times, |motion, times| motion.0.signals(times))?.python()?;
        Ok(PySignals::of(slf.py(), signals))
    }

    /// Positions of both ends and all windings.
    ///
    /// Parameters
    /// ----------
    /// times : array_like of float, shape (samples,)
    ///     [s], in any order, none below zero.
    ///
    /// Returns
    /// -------
    /// Windings
    ///
    /// Raises
    /// ------
    /// Error
    ///     For no times, the first that is not finite or below zero, or more than 5000 windings.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
    /// >>> motion.windings([0.0, 0.01]).count
    /// 52
    fn windings(slf: &Bound<'_, Self>, times: Series<'_>) -> PyResult<PyWindings> {
        let times = times.values("times")?;
        let steps = slf.get().steps_of_windings(times.len());
        let windings = of_series(slf, steps, &times, |motion, times| motion.0.windings(times))?.python()?;
        PyWindings::of(slf.py(), windings)
    }

    /// Velocities of all windings.
    ///
    /// Parameters
    /// ----------
    /// time : float or str
    ///     [s], not below zero.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray, shape (N,)
    ///     [m/s].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
    /// >>> motion.velocities(0.0).round(3)[:3]
    /// array([0.25, 0.25, 0.25])
    fn velocities<'py>(&self, py: Python<'py>, time: Quantity) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let time = time.si("time", Dimension::Time)?;
        Ok(py.detach(|| self.0.velocities(time)).python()?.into_pyarray(py))
    }

    /// Positions of both ends; end 1 has its mean at 0.
    ///
    /// Parameters
    /// ----------
    /// times : float, str or array_like of float
    ///     [s], none below zero.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray, shape (2,) or (samples, 2)
    ///     u1 and u2 [m], behind the dimensions of the times.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
    /// >>> motion.ends([0.0, 1.0])
    /// array([[0.  , 0.23],
    ///        [0.  , 0.23]])
    fn ends<'py>(slf: &Bound<'py, Self>, times: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        let at = times.si("times", Dimension::Time)?;
        let steps = slf.get().steps(at.len());
        let ends = of_series(slf, steps, &at, |motion, times| motion.0.ends(times))?.python()?;
        times.with_axes(slf.py(), ends.into_flattened(), &[2])
    }

    /// The chain's mechanical energy: kinetic plus elastic (counted from the rest length), without an end mass.
    ///
    /// Parameters
    /// ----------
    /// time : float, str or array_like of float
    ///     [s], not below zero.
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the time
    ///     [J]; constant while both ends are held and nothing is damped.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
    /// >>> motion.energy([0.0, 1.0]).round(6)
    /// array([6.034911, 6.034911])
    fn energy<'py>(&self, py: Python<'py>, time: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        let at = time.si("time", Dimension::Time)?;
        let energies = each(py, &at, |time| self.0.energy(time))?.into_iter().collect::<Result<Vec<_>, _>>();
        time.shaped(py, energies.python()?)
    }

    /// The same motion with its first modes only; those left out keep their static answer in the end forces.
    ///
    /// Parameters
    /// ----------
    /// modes : int
    ///     How many, at least 1.
    ///
    /// Returns
    /// -------
    /// Motion
    ///     Off by at most its `truncation_bound`.
    ///
    /// Notes
    /// -----
    /// Source: mode-acceleration method. Valid for inputs that are slow against the first mode left out.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
    /// >>> few = motion.truncated(5)
    /// >>> len(few.modes), len(motion.modes)
    /// (5, 52)
    fn truncated(&self, py: Python<'_>, modes: Count) -> PyResult<Self> {
        let modes = modes.size("modes")?;
        py.detach(|| self.0.truncated(modes)).python().map(Self)
    }

    /// Forces at t = 0, h, 2h, ... in constant memory, without end.
    ///
    /// Parameters
    /// ----------
    /// step : float or str
    ///     h [s], above zero.
    ///
    /// Returns
    /// -------
    /// Stream
    ///     An iterator of (t [s], F_i [N], F_o [N]).
    ///
    /// Examples
    /// --------
    /// >>> from itertools import islice
    /// >>> from coilsense import Excitation, Motion, Spring
    /// >>> motion = Motion(Spring.of_paper("S_T"), Excitation.impact(0.23, 0.25))
    /// >>> [round(t, 6) for t, F_i, F_o in islice(motion.stream(1e-4), 3)]
    /// [0.0, 0.0001, 0.0002]
    fn stream(&self, step: Quantity) -> PyResult<PyStream> {
        PyStream::of(self, step.si("step", Dimension::Time)?)
    }
}
