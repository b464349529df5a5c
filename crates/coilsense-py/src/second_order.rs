//! `coilsense.SecondOrder`: the inductance near uniform windings, with a bound; and that of two rings.
//!
//! Next door: the exact sum (`maxwell_sum`).

use coilsense::inductance::{SecondOrder, mutual_inductances};
use coilsense_lab::quantity::Dimension::Length;
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::maxwell_sum::PyMaxwellSum;
use crate::noun::Noun;
use crate::quantity::Quantity;
use crate::samples::Samples;
use crate::series::Series;
use crate::value::getters;

/// The inductance of a coil to second order in the displacements of its turns from uniform ones, with a bound on what is left out.
///
/// Parameters
/// ----------
/// coil : MaxwellSum
///     The exact sum.
/// length : float or str
///     About which length [m].
///
/// Raises
/// ------
/// Error
///     For a length that is not finite or not above zero.
///
/// Examples
/// --------
/// >>> import numpy, coilsense
/// >>> coil = coilsense.MaxwellSum(coilsense.Spring.of_paper("S_T"))
/// >>> L, bound = coilsense.SecondOrder(coil, 0.23).at_displacements(numpy.zeros(52))
/// >>> bool(abs(L / coil.at_lengths([0.23])[0] - 1) < 1e-14), bound <= 1e-14 * L
/// (True, True)
#[pyclass(name = "SecondOrder", module = "coilsense", frozen)]
pub struct PySecondOrder(SecondOrder);

getters! {
    PySecondOrder, self;
    /// dL/dx of uniform turns [H/m], shape (turns,).
    gradient<'py>(py): Bound<'py, PyArray1<f64>> = self.0.gradient().into_pyarray(py);
    /// M'' for turns 1 to turns - 1 apart [H/m^2]: the Hessian is H_ts = -2 M''(|t - s| p), and each of its rows sums to zero.
    curvatures<'py>(py): Bound<'py, PyArray1<f64>> = self.0.curvatures().into_pyarray(py);
}

#[pymethods]
impl PySecondOrder {
    #[new]
    fn new(py: Python<'_>, coil: Noun<'_, PyMaxwellSum>, length: Quantity) -> PyResult<Self> {
        let coil = coil.named("coil")?;
        let length = length.si("length", Length)?;
        py.detach(|| SecondOrder::about(&coil.sum, length)).python().map(Self)
    }

    /// L and its bound.
    ///
    /// Parameters
    /// ----------
    /// displacements : array_like of float, shape (turns,)
    ///     Of the turns from uniform [m].
    ///
    /// Returns
    /// -------
    /// inductance, bound : float
    ///     L [H], and how far it may be off [H].
    ///
    /// Raises
    /// ------
    /// Error
    ///     For another number of turns, or the first displacement that is not finite.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, numpy
    /// >>> coil = coilsense.MaxwellSum(coilsense.Spring.of_paper("S_T"))
    /// >>> L, bound = coilsense.SecondOrder(coil, 0.23).at_displacements(numpy.full(52, 1e-6))
    /// >>> bool(bound < 1e-6 * L)
    /// True
    fn at_displacements(&self, displacements: Series<'_>) -> PyResult<(f64, f64)> {
        let near = self.0.at_displacements(&displacements.values("displacements")?).python()?;
        Ok((near.inductance, near.bound))
    }
}

/// Mutual inductance of two coaxial rings of equal radius.
///
/// Parameters
/// ----------
/// radius : float or str
///     r [m], above zero.
/// distances : float, str or array_like of float
///     h [m], of either sign.
///
/// Returns
/// -------
/// float or numpy.ndarray, of the shape of the distances
///     M [H]; infinite where the rings coincide.
///
/// Raises
/// ------
/// Error
///     For a radius that is not above zero and finite.
///
/// Notes
/// -----
/// Source: [Weijde2017] eqs. 8-9, [Maxwell1873] art. 701. Accurate to 2e-15 relative over h/r = 1e-5 to 1e4, against 40 digits.
///
/// Examples
/// --------
/// >>> import math, coilsense
/// >>> M = coilsense.mutual_inductances(0.008, [0.008])[0]
/// >>> round(M / (4e-7 * math.pi * 0.008), 6)
/// np.float64(0.393175)
#[pyfunction(name = "mutual_inductances")]
pub fn py_mutual_inductances<'py>(
    py: Python<'py>,
    radius: Quantity,
    distances: Samples<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    let (radius, apart) = (radius.si("radius", Length)?, distances.si("distances", Length)?);
    let mut inductances = vec![0.0; apart.len()];
    py.detach(|| mutual_inductances(radius, &apart, &mut inductances)).python()?;
    distances.shaped(py, inductances)
}
