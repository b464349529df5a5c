//! `coilsense.Windings`: where both ends and all windings are over time.
//!
//! Next door: who makes them (`motion`), whether they touch (`measures`), what they do to a coil (`inductance`). As in `signals`, the arrays are
//! Python's own.

use coilsense::motion::Windings;
use numpy::{PyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{Error, IntoPython};
use crate::results::table_and_figure;
use crate::series::{Table, frozen_rows, numbers};
use crate::value::{Arguments, getters};

/// Positions of both ends and of all windings over time.
///
/// Parameters
/// ----------
/// ends : array_like of float, shape (samples, 2)
///     u1 and u2 [m].
/// positions : array_like of float, shape (samples, N)
///     x_1 to x_N [m].
///
/// Raises
/// ------
/// Error
///     Where there is no sample, or another number of samples of the windings than of the ends, or a position that is not finite.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
/// >>> motion.windings([0.0, 0.001, 0.002]).positions.shape
/// (3, 52)
#[pyclass(name = "Windings", module = "coilsense", frozen)]
pub struct PyWindings {
    ends: Py<PyArray2<f64>>,
    positions: Py<PyArray2<f64>>,
}

impl PyWindings {
    /// Windings moved to Python.
    pub fn of(py: Python<'_>, windings: Windings) -> PyResult<Self> {
        let count = windings.count();
        let (ends, positions) = windings.into_parts();
        let ends = frozen_rows(py, ends.into_flattened(), 2)?;
        Ok(Self { ends, positions: frozen_rows(py, positions, count)? })
    }

    /// The same for Rust, copied.
    pub fn to_rust(&self, py: Python<'_>) -> PyResult<Windings> {
        let ends = numbers(self.ends.bind(py)).as_chunks::<2>().0.to_vec();
        Windings::new(ends, numbers(self.positions.bind(py))).python()
    }
}

getters! {
    PyWindings, self;
    /// u1 and u2 [m], shape (samples, 2); read-only.
    ends<'py>(py): &Bound<'py, PyArray2<f64>> = self.ends.bind(py);
    /// x_1 to x_N [m], shape (samples, N); read-only.
    positions<'py>(py): &Bound<'py, PyArray2<f64>> = self.positions.bind(py);
    /// N: windings per sample.
    count<'py>(py): usize = self.positions.bind(py).shape()[1];
    /// How many samples there are.
    samples<'py>(py): usize = self.positions.bind(py).shape()[0];
}

table_and_figure! {
    PyWindings;
    /// Positions as a data frame of pandas: one row per sample, u1, x_1 to x_N, u2 [m]; ``pip install coilsense[pandas]``.
    to_pandas = "windings_frame";
    /// Draws the path of every winding with matplotlib; ``pip install coilsense[plot]``.
    plot = "windings_plot";
}

#[pymethods]
impl PyWindings {
    #[new]
    fn new(py: Python<'_>, ends: Table<'_>, positions: Table<'_>) -> PyResult<Self> {
        let (ends, columns) = ends.to_vec("ends")?;
        if columns != 2 {
            return Err(Error::new_err(format!("ends must have 2 columns, got {columns}")));
        }
        let (ends, positions) = (ends.as_chunks::<2>().0.to_vec(), positions.to_vec("positions")?.0);
        Self::of(py, Windings::new(ends, positions).python()?)
    }

    /// Ends and positions as lists of rows.
    ///
    /// Returns
    /// -------
    /// dict
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Windings([[0.0, 0.2]], [[0.05, 0.15]]).to_dict()
    /// {'ends': [[0.0, 0.2]], 'positions': [[0.05, 0.15]]}
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        dict.set_item("ends", self.ends.bind(py).call_method0("tolist")?)?;
        dict.set_item("positions", self.positions.bind(py).call_method0("tolist")?)?;
        Ok(dict)
    }

    fn __len__(&self, py: Python<'_>) -> usize {
        self.samples(py)
    }

    fn __eq__(&self, py: Python<'_>, other: &Bound<'_, PyAny>) -> PyResult<bool> {
        let Ok(other) = other.cast::<Self>() else { return Ok(false) };
        Ok(self.to_rust(py)? == other.get().to_rust(py)?)
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>) {
        (self.ends.bind(py).clone(), self.positions.bind(py).clone())
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        format!("<Windings: {} of {} samples>", self.count(py), self.samples(py))
    }
}
