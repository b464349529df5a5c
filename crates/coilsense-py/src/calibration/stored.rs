//! A calibration that was stored, read back.
//!
//! Next door: how one is made (the parent).

use std::path::PathBuf;

use coilsense_lab::calibration::StoredCalibration;
use coilsense_lab::quantity::Dimension;
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::quantity::{Anything, Quantity, neither};
use crate::samples::Samples;
use crate::value::getters;

/// A calibration that was stored: length, force and their standard uncertainties from an inductance; read by `open_calibration`.
///
/// Notes
/// -----
/// Of windings at rest: while a coil rings, its inductance is that of other lengths.
///
/// Examples
/// --------
/// >>> import coilsense, pathlib, tempfile
/// >>> fit = coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6]))
/// >>> folder = pathlib.Path(tempfile.mkdtemp())
/// >>> _ = (folder / "calibration.toml").write_text(fit.stored("2026-11-21"))
/// >>> stored = coilsense.open_calibration(folder / "calibration.toml")
/// >>> stored.relation, stored.lengths
/// ('inverse-length', (0.1988, 0.2612))
#[pyclass(name = "StoredCalibration", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyStoredCalibration(StoredCalibration);

/// A calibration that was stored, or the file where it is.
#[derive(FromPyObject)]
pub enum StoredArgument<'py> {
    /// Read before.
    Read(Bound<'py, PyStoredCalibration>),
    /// The file.
    File(PathBuf),
    /// Something else.
    Other(Anything),
}

impl StoredArgument<'_> {
    /// The calibration.
    pub fn stored(self) -> PyResult<StoredCalibration> {
        match self {
            Self::Read(stored) => Ok(stored.get().0.clone()),
            Self::File(path) => StoredCalibration::read(&path).python(),
            Self::Other(object) => Err(neither("calibration", "a StoredCalibration or its file", &object)),
        }
    }
}

getters! {
    PyStoredCalibration, self;
    /// The relation it was made by: "inverse-length", "cubic" or "steel".
    relation: String = self.0.relation.clone();
    /// What it says of itself.
    about: String = self.0.about.clone();
    /// Lengths between which it reads [m].
    lengths: (f64, f64) = self.0.lengths().into();
    /// Inductances between which it reads [H].
    inductances: (f64, f64) = self.0.inductances().into();
    /// Standard uncertainty of L of a spring mounted anew, as a share [1]; 0 where it was zeroed since.
    remounting: f64 = self.0.remounting;
}

#[pymethods]
impl PyStoredCalibration {
    /// The length at an inductance and its standard uncertainty; nan where it is not told.
    ///
    /// Parameters
    /// ----------
    /// inductance : float, str or array_like of float
    ///     [H].
    ///
    /// Returns
    /// -------
    /// (float, float) or (numpy.ndarray, numpy.ndarray), of the shape of the inductance
    ///     [m].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, pathlib, tempfile
    /// >>> fit = coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6]))
    /// >>> folder = pathlib.Path(tempfile.mkdtemp())
    /// >>> _ = (folder / "calibration.toml").write_text(fit.stored("2026-11-21"))
    /// >>> stored = coilsense.open_calibration(folder / "calibration.toml")
    /// >>> length, doubt = stored.length("2.6 uH")
    /// >>> round(length, 3), doubt > 0
    /// (0.23, True)
    fn length<'py>(&self, py: Python<'py>, inductance: Samples<'py>) -> Pair<'py> {
        let of =
            |henry| self.0.at(henry).map_or([f64::NAN; 2], |read| [read.length, read.length_u.unwrap_or(f64::NAN)]);
        inductance.each_pair(py, "inductance", Dimension::Inductance, of)
    }

    /// The force at an inductance and its standard uncertainty; nan where it is not told.
    ///
    /// Parameters
    /// ----------
    /// inductance : float, str or array_like of float
    ///     [H].
    ///
    /// Returns
    /// -------
    /// (float, float) or (numpy.ndarray, numpy.ndarray), of the shape of the inductance
    ///     [N].
    fn force<'py>(&self, py: Python<'py>, inductance: Samples<'py>) -> Pair<'py> {
        let of = |henry| {
            let force = self.0.at(henry).and_then(|read| self.0.force_of(read));
            force.map_or([f64::NAN; 2], |(force, force_u)| [force, force_u.unwrap_or(f64::NAN)])
        };
        inductance.each_pair(py, "inductance", Dimension::Inductance, of)
    }

    /// The same of a spring that was mounted anew and has this inductance at this length.
    ///
    /// Parameters
    /// ----------
    /// length : float or str
    ///     [m].
    /// inductance : float or str
    ///     [H].
    ///
    /// Returns
    /// -------
    /// StoredCalibration
    ///
    /// Raises
    /// ------
    /// Error
    ///     For a length outside of the calibration.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, pathlib, tempfile
    /// >>> fit = coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6]))
    /// >>> folder = pathlib.Path(tempfile.mkdtemp())
    /// >>> _ = (folder / "calibration.toml").write_text(fit.stored("2026-11-21"))
    /// >>> stored = coilsense.open_calibration(folder / "calibration.toml")
    /// >>> moved = stored.re_zeroed("230 mm", "2.7 uH")
    /// >>> round(moved.length(2.7e-6)[0], 6)
    /// 0.23
    fn re_zeroed(&self, length: Quantity, inductance: Quantity) -> PyResult<Self> {
        let length = length.si("length", Dimension::Length)?;
        let inductance = inductance.si("inductance", Dimension::Inductance)?;
        Ok(Self(self.0.clone().re_zeroed(length, inductance).python()?))
    }

    fn __repr__(&self) -> String {
        let [shortest, longest] = self.0.lengths();
        format!("<StoredCalibration by {} from {shortest} to {longest} m>", self.0.relation)
    }
}

/// Values and their standard uncertainties.
type Pair<'py> = PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)>;

/// Reads a calibration that was stored: ``calibration.toml`` of ``coilsense calibrate --out``, or what `Calibration.stored` gives.
///
/// Parameters
/// ----------
/// path : str or os.PathLike
///     The file.
///
/// Returns
/// -------
/// StoredCalibration
///
/// Raises
/// ------
/// Error
///     For what is no such file.
///
/// Examples
/// --------
/// >>> import coilsense, pathlib, tempfile
/// >>> fit = coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6]))
/// >>> folder = pathlib.Path(tempfile.mkdtemp())
/// >>> _ = (folder / "calibration.toml").write_text(fit.stored("2026-11-21"))
/// >>> stored = coilsense.open_calibration(folder / "calibration.toml")
/// >>> stored
/// <StoredCalibration by inverse-length from 0.1988 to 0.2612 m>
#[pyfunction]
pub fn open_calibration(path: PathBuf) -> PyResult<PyStoredCalibration> {
    Ok(PyStoredCalibration(StoredCalibration::read(&path).python()?))
}
