//! `coilsense.Start`: where the windings are, and how fast, at t = 0.
//!
//! Next door: how the ends are driven (`input`).

use coilsense::excitation::{EndInput, Excitation, Start, VelocityProfile};
use coilsense_lab::quantity::Dimension::Velocity;
use numpy::PyArray1;
use pyo3::prelude::*;

use super::profile_word;
use crate::errors::{IntoPython, unknown};
use crate::quantity::Quantity;
use crate::series::Series;
use crate::value::{Kind, value_of_kinds};

/// Where the windings are, and how fast, at t = 0.
///
/// Made by ``Start.rest``, ``massless``, ``steady``, ``moving`` or ``windings``.
///
/// Examples
/// --------
/// >>> from coilsense import Start
/// >>> Start.moving(0.25, "linear")
/// Start.moving(velocity=0.25, profile='linear')
#[pyclass(name = "Start", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyStart(pub Start);

impl PyStart {
    /// Lets through what an excitation would let through.
    fn checked(start: Start) -> PyResult<Self> {
        Excitation::new(1.0, EndInput::Held, EndInput::Held, start.clone()).python().map(|_| Self(start))
    }

    fn as_kind<'py>(&self, py: Python<'py>) -> PyResult<Kind<'py>> {
        let kind = |name| Kind::new(py, name);
        match &self.0 {
            Start::Rest => Ok(kind("rest")),
            Start::Massless => Ok(kind("massless")),
            Start::Steady => Ok(kind("steady")),
            Start::Moving { velocity, profile } => {
                kind("moving").with("velocity", velocity)?.with("profile", profile_word(*profile))
            }
            Start::Windings { positions, velocities } => kind("windings")
                .with("positions", PyArray1::from_slice(py, positions))?
                .with("velocities", PyArray1::from_slice(py, velocities)),
        }
    }
}

value_of_kinds! {
    /// Which constructor makes it: "rest", "massless", "steady", "moving" or "windings".
    PyStart, "Start"; "rest", "massless", "steady", "moving", "windings"
}

#[pymethods]
impl PyStart {
    /// Uniform for the mean length, velocity zero, wherever the ends are.
    ///
    /// Returns
    /// -------
    /// Start
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Start.rest()
    /// Start.rest()
    #[staticmethod]
    fn rest() -> Self {
        Self(Start::Rest)
    }

    /// As a spring without mass: uniform between the ends' positions, velocities linear between the ends' velocities.
    ///
    /// Returns
    /// -------
    /// Start
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Excitation(0.23, coilsense.EndInput.harmonic(1e-3, 10.0), start=coilsense.Start.massless()).start.kind
    /// 'massless'
    #[staticmethod]
    fn massless() -> Self {
        Self(Start::Massless)
    }

    /// As the sines of both ends have left it after a long time: the motion repeats from the first period on.
    ///
    /// Returns
    /// -------
    /// Start
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Excitation(0.23, coilsense.EndInput.harmonic(1e-3, 10.0), start=coilsense.Start.steady()).start.kind
    /// 'steady'
    #[staticmethod]
    fn steady() -> Self {
        Self(Start::Steady)
    }

    /// Uniform for the mean length, moving.
    ///
    /// Parameters
    /// ----------
    /// velocity : float or str
    ///     v [m/s], positive from end 1 to end 2.
    /// profile : {"uniform", "linear"}, optional
    ///     v for every winding, or v (i - 1/2)/N for winding i.
    ///
    /// Returns
    /// -------
    /// Start
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Start.moving("25 cm/s")
    /// Start.moving(velocity=0.25, profile='uniform')
    #[staticmethod]
    #[pyo3(signature = (velocity, profile="uniform"))]
    fn moving(velocity: Quantity, profile: &str) -> PyResult<Self> {
        let velocity = velocity.si("velocity", Velocity)?;
        Self::checked(Start::Moving { velocity, profile: self::profile(profile)? })
    }

    /// Given winding by winding, winding 1 first.
    ///
    /// Parameters
    /// ----------
    /// positions : array_like of float, shape (N,)
    ///     [m], measured from the mean position of end 1.
    /// velocities : array_like of float, shape (N,)
    ///     [m/s].
    ///
    /// Returns
    /// -------
    /// Start
    ///
    /// Raises
    /// ------
    /// Error
    ///     For unlike numbers of positions and velocities, or a value that is not finite.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Start.windings([0.1, 0.2], [0.0, 0.3]).kind
    /// 'windings'
    #[staticmethod]
    fn windings(positions: Series<'_>, velocities: Series<'_>) -> PyResult<Self> {
        Self::checked(Start::Windings {
            positions: positions.to_vec("positions")?,
            velocities: velocities.to_vec("velocities")?,
        })
    }
}

/// A profile by its word.
pub fn profile(word: &str) -> PyResult<VelocityProfile> {
    match word {
        "uniform" => Ok(VelocityProfile::Uniform),
        "linear" => Ok(VelocityProfile::Linear),
        _ => Err(unknown("profile", &["uniform", "linear"], word)),
    }
}
