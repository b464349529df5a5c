//! What Python asks of any value: a motion as a dict, with another argument, compared, pickled, printed.
//!
//! Next door: what moves (the parent).

use coilsense::Motion;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use super::PyMotion;
use crate::value::{self, Arguments};

/// A function and its arguments, as `pickle` keeps them.
type Reduced<'py> = (Bound<'py, PyAny>, Bound<'py, PyTuple>);

#[pymethods]
impl PyMotion {
    /// Spring, excitation and mount as dicts; of a truncated motion also how many modes it has.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = value::plain(&self.arguments(py)?)?;
        if let Some(modes) = self.kept_modes() {
            dict.set_item("modes", modes)?;
        }
        Ok(dict)
    }

    /// The same with another spring, excitation or mount; a truncated motion keeps its number of modes. ``copy.replace`` of Python 3.13 calls it, too.
    ///
    /// Parameters
    /// ----------
    /// **changes
    ///     Arguments of the constructor by name.
    ///
    /// Returns
    /// -------
    /// Motion
    ///
    /// Raises
    /// ------
    /// TypeError
    ///     For a name that is none of them; it says which there are.
    /// Error
    ///     Where the constructor would.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
    /// >>> damped = motion.replace(mount=motion.mount.replace(damping=coilsense.Damping.modal(0.005)))
    /// >>> damped.mount.damping
    /// Damping.modal(ratio=0.005)
    #[pyo3(signature = (**changes))]
    fn replace<'py>(slf: &Bound<'py, Self>, changes: Option<Arguments<'py>>) -> PyResult<Bound<'py, PyAny>> {
        let arguments = value::replaced("Motion", slf.get().arguments(slf.py())?, changes)?;
        let full = slf.get_type().call((), Some(&arguments))?;
        slf.get().kept_modes().map_or(Ok(full.clone()), |modes| full.call_method1("truncated", (modes,)))
    }

    #[pyo3(signature = (**changes))]
    fn __replace__<'py>(slf: &Bound<'py, Self>, changes: Option<Arguments<'py>>) -> PyResult<Bound<'py, PyAny>> {
        Self::replace(slf, changes)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        let Ok(other) = other.cast::<Self>() else { return false };
        let parts = |motion: &Motion| (motion.spring().clone(), motion.excitation().clone(), motion.mount().clone());
        let other = &other.get().0;
        self.0.modes() == other.modes() && parts(&self.0) == parts(other)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        let (py, motion) = (slf.py(), slf.get());
        let make = py.import("coilsense._pickle")?.getattr("motion")?;
        let kept = (motion.spring(), motion.excitation(), motion.mount(), motion.kept_modes());
        Ok((make, kept.into_pyobject(py)?))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let full = value::shown("Motion", &self.arguments(py)?)?;
        Ok(self.kept_modes().map_or(full.clone(), |modes| format!("{full}.truncated({modes})")))
    }
}
