//! `coilsense.Damping`: what damps the windings.
//!
//! Next door: what end 2 is tied to (`far_end`).

use coilsense::{Damping, FarEnd, Mount};
use coilsense_lab::quantity::Dimension;
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::hertz::angular;
use crate::quantity::Quantity;
use crate::samples::Samples;
use crate::series::Series;
use crate::value::{Kind, value_of_kinds};

/// Damping of the windings, relative to the straight line between the ends.
///
/// Made by ``Damping.none``, ``modal``, ``modal_each``, ``mass_proportional``, ``stiffness_proportional`` or ``hysteretic``.
///
/// Examples
/// --------
/// >>> from coilsense import Damping
/// >>> Damping.stiffness_proportional(1e-4).ratios([10.0, 20.0]).round(6)
/// array([0.003142, 0.006283])
#[pyclass(name = "Damping", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyDamping(pub Damping);

impl PyDamping {
    /// Lets through what a mount would let through.
    fn checked(damping: Damping) -> PyResult<Self> {
        Mount::new(FarEnd::Position, damping.clone()).python().map(|_| Self(damping))
    }

    fn as_kind<'py>(&self, py: Python<'py>) -> PyResult<Kind<'py>> {
        let kind = |name| Kind::new(py, name);
        match &self.0 {
            Damping::None => Ok(kind("none")),
            Damping::Modal(ratio) => kind("modal").with("ratio", ratio),
            Damping::ModalEach(ratios) => kind("modal_each").with("ratios", ratios.clone()),
            Damping::MassProportional { rate } => kind("mass_proportional").with("rate", rate),
            Damping::StiffnessProportional { time } => kind("stiffness_proportional").with("time", time),
            Damping::Hysteretic { loss_factor } => kind("hysteretic").with("loss_factor", loss_factor),
        }
    }
}

value_of_kinds! {
    /// Which constructor makes it: "none", "modal", "modal_each", "mass_proportional", "stiffness_proportional" or "hysteretic".
    PyDamping, "Damping"; "none", "modal", "modal_each", "mass_proportional", "stiffness_proportional", "hysteretic"
}

#[pymethods]
impl PyDamping {
    /// None: the paper's case.
    ///
    /// Returns
    /// -------
    /// Damping
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Damping.none().ratios(54.0)
    /// 0.0
    #[staticmethod]
    fn none() -> Self {
        Self(Damping::None)
    }

    /// The same damping ratio in every mode.
    ///
    /// Parameters
    /// ----------
    /// ratio : float or str
    ///     zeta [1], not below zero.
    ///
    /// Returns
    /// -------
    /// Damping
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Damping.modal("0.5 %").ratios([54.0, 108.0])
    /// array([0.005, 0.005])
    #[staticmethod]
    fn modal(ratio: Quantity) -> PyResult<Self> {
        let ratio = ratio.si("ratio", Dimension::Share)?;
        Self::checked(Damping::Modal(ratio))
    }

    /// A damping ratio for each mode, lowest first.
    ///
    /// Parameters
    /// ----------
    /// ratios : array_like of float, shape (modes,)
    ///     zeta_j [1], not below zero.
    ///
    /// Returns
    /// -------
    /// Damping
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Damping.modal_each([0.005, 0.01])
    /// Damping.modal_each(ratios=[0.005, 0.01])
    #[staticmethod]
    fn modal_each(ratios: Series<'_>) -> PyResult<Self> {
        Self::checked(Damping::ModalEach(ratios.to_vec("ratios")?))
    }

    /// zeta_j = rate / 2 omega_j, omega_j = 2 pi f_j: as in a viscous fluid.
    ///
    /// Parameters
    /// ----------
    /// rate : float or str
    ///     alpha [1/s], not below zero.
    ///
    /// Returns
    /// -------
    /// Damping
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Damping.mass_proportional(1.0).ratios([54.0, 108.0]).round(6)
    /// array([0.001474, 0.000737])
    #[staticmethod]
    fn mass_proportional(rate: Quantity) -> PyResult<Self> {
        let rate = rate.si("rate", Dimension::Rate)?;
        Self::checked(Damping::MassProportional { rate })
    }

    /// zeta_j = time omega_j / 2, omega_j = 2 pi f_j: a dashpot beside every segment.
    ///
    /// Parameters
    /// ----------
    /// time : float or str
    ///     beta [s], not below zero.
    ///
    /// Returns
    /// -------
    /// Damping
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Damping.stiffness_proportional("0.1 ms").ratios([54.0, 108.0]).round(6)
    /// array([0.016965, 0.033929])
    #[staticmethod]
    fn stiffness_proportional(time: Quantity) -> PyResult<Self> {
        let time = time.si("time", Dimension::Time)?;
        Self::checked(Damping::StiffnessProportional { time })
    }

    /// Stiffness k (1 + i eta), which has a meaning over frequency only (`TwoPort`).
    ///
    /// Parameters
    /// ----------
    /// loss_factor : float or str
    ///     eta [1], not below zero.
    ///
    /// Returns
    /// -------
    /// Damping
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Damping.hysteretic("1 %")
    /// Damping.hysteretic(loss_factor=0.01)
    #[staticmethod]
    fn hysteretic(loss_factor: Quantity) -> PyResult<Self> {
        let loss_factor = loss_factor.si("loss_factor", Dimension::Share)?;
        Self::checked(Damping::Hysteretic { loss_factor })
    }

    /// Damping ratios of modes.
    ///
    /// Parameters
    /// ----------
    /// frequencies : float, str or array_like of float
    ///     f_j [Hz].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the frequencies
    ///     zeta_j [1].
    ///
    /// Raises
    /// ------
    /// Error
    ///     Where damping for each mode is given for another number of modes, and for a loss factor.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> round(coilsense.Damping.stiffness_proportional(1e-4).ratios("54 Hz"), 6)
    /// 0.016965
    fn ratios<'py>(&self, py: Python<'py>, frequencies: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        let hertz = frequencies.si("frequencies", Dimension::Frequency)?;
        let omega: Vec<f64> = hertz.iter().copied().map(angular).collect();
        frequencies.shaped(py, self.0.ratios(&omega).python()?)
    }
}
