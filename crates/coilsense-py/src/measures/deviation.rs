//! `coilsense.Deviation`: one force series against another.
//!
//! Next door: windings that touch (`clash`).

use coilsense::Deviation;
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::quantity::Quantity;
use crate::series::Series;
use crate::value::{getters, named_value};

/// How a series deviates from its reference; every value has the unit of the series.
///
/// Made by ``Deviation.between``; the constructor takes what is known already.
///
/// Parameters
/// ----------
/// rmsd : float
///     Root of the mean of squares.
/// maximum : float
///     Largest difference, with its sign.
/// maximum_absolute : float
///     Largest difference either way.
/// mean : float
///     Mean difference.
/// standard_error : float
///     sigma / sqrt(n), with sigma over n - 1; zero for one sample.
///
/// Notes
/// -----
/// Source: [Weijde2017] section III-D and eq. 15.
///
/// Examples
/// --------
/// >>> from coilsense import Deviation
/// >>> Deviation.between([1.0, 2.0, 0.0], [1.0, 1.0, 1.0]).maximum
/// 1.0
#[pyclass(name = "Deviation", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyDeviation(pub Deviation);

getters! {
    PyDeviation, self;
    /// Root of the mean of squares.
    rmsd: f64 = self.0.rmsd;
    /// Largest difference, with its sign.
    maximum: f64 = self.0.maximum;
    /// Largest difference either way.
    maximum_absolute: f64 = self.0.maximum_absolute;
    /// Mean difference.
    mean: f64 = self.0.mean;
    /// sigma / sqrt(n), with sigma over n - 1; zero for one sample.
    standard_error: f64 = self.0.standard_error;
}

named_value! {
    /// The values by name.
    PyDeviation, self;
    rmsd, maximum, maximum_absolute, mean, standard_error,
}

#[pymethods]
impl PyDeviation {
    #[new]
    #[pyo3(signature = (*, rmsd, maximum, maximum_absolute, mean, standard_error))]
    fn new(
        rmsd: Quantity,
        maximum: Quantity,
        maximum_absolute: Quantity,
        mean: Quantity,
        standard_error: Quantity,
    ) -> PyResult<Self> {
        Ok(Self(Deviation {
            rmsd: rmsd.plain("rmsd")?,
            maximum: maximum.plain("maximum")?,
            maximum_absolute: maximum_absolute.plain("maximum_absolute")?,
            mean: mean.plain("mean")?,
            standard_error: standard_error.plain("standard_error")?,
        }))
    }

    /// Of a force from its reference.
    ///
    /// Parameters
    /// ----------
    /// force, reference : array_like of float, shape (samples,)
    ///     Of one unit.
    ///
    /// Returns
    /// -------
    /// Deviation
    ///
    /// Raises
    /// ------
    /// Error
    ///     For no samples, series of different lengths, or the first value that is not finite.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> print(f"{coilsense.Deviation.between([1.0, 2.0, 3.0], [1.0, 2.0, 2.0]).rmsd:.4f} N")
    /// 0.5774 N
    #[staticmethod]
    fn between(py: Python<'_>, force: Series<'_>, reference: Series<'_>) -> PyResult<Self> {
        let (force, reference) = (force.values("force")?, reference.values("reference")?);
        py.detach(|| Deviation::between(&force, &reference)).python().map(Self)
    }

    /// The same as a share of a nominal value.
    ///
    /// Parameters
    /// ----------
    /// nominal : float
    ///     Above zero, for example `Spring.nominal_force` [N].
    ///
    /// Returns
    /// -------
    /// Deviation
    ///     Shares [1].
    ///
    /// Raises
    /// ------
    /// Error
    ///     For a nominal value that is not above zero.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> spring = coilsense.Spring.of_paper("S_T")
    /// >>> found = coilsense.Deviation.between([96.0, 95.0], [95.0, 95.0])
    /// >>> print(f"{found.relative_to(spring.nominal_force).maximum:.2%} of F_nom")
    /// 0.82% of F_nom
    fn relative_to(&self, nominal: Quantity) -> PyResult<Self> {
        self.0.relative_to(nominal.plain("nominal")?).python().map(Self)
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        crate::html::shown(slf.as_any(), "deviation")
    }
}
