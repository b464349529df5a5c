//! `coilsense.Estimate`: a value with its interval.
//!
//! Next door: what is estimated (`identification`).

use coilsense::identify::Estimate;
use pyo3::exceptions::{PyTypeError, PyZeroDivisionError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyFloat;

use crate::quantity::Quantity;
use crate::value::{getters, named_value};

/// What was found, and how far to trust it; ``float()`` of it is its value.
///
/// ``str()`` and ``format()`` show the value and half the width of its 95 % interval: by itself to two digits of that half width, and by a format of floats (``f"{found:.2f}"``) both in that format. A number may be added, subtracted and multiplied, and divide it: that moves or stretches the interval
/// exactly. Two estimates are not put together: those of one record share its errors, so that how far a sum or a ratio can be off does not follow from two widths; squares of the two
/// would even make a doubt of ``e - e``, which is zero. Where they are known to be independent, `to_ufloat` hands them to the package uncertainties, which goes on with them to first order.
/// An estimate is neither less nor more than a number: ask its `value`, `low` and `high`.
///
/// Parameters
/// ----------
/// value : float
///     In SI units.
/// standard : float
///     Standard uncertainty, in the same unit.
/// expanded : float
///     Half the width of the interval that holds the true value with a probability of 95 %.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> stiffness = coilsense.Estimate(760.0, 0.5, 1.0)
/// >>> stiffness.low, stiffness.high, 760.8 in stiffness
/// (759.0, 761.0, True)
/// >>> str(stiffness), f"{stiffness:.2f}", str(stiffness / 1000)
/// ('760.0 ± 1.0', '760.00 ± 1.00', '0.7600 ± 0.0010')
#[pyclass(name = "Estimate", module = "coilsense", frozen, eq)]
pub struct PyEstimate {
    estimate: Estimate,
    /// The same to the package uncertainties, where it was asked for: one estimate is one variable.
    variable: PyOnceLock<Py<PyAny>>,
}

impl PartialEq for PyEstimate {
    fn eq(&self, other: &Self) -> bool {
        self.estimate == other.estimate
    }
}

impl From<Estimate> for PyEstimate {
    fn from(estimate: Estimate) -> Self {
        Self { estimate, variable: PyOnceLock::new() }
    }
}

impl PyEstimate {
    /// The same moved and stretched by numbers.
    fn moved(&self, factor: f64, by: f64) -> Self {
        let Estimate { value, standard, expanded } = self.estimate;
        let size = factor.abs();
        Estimate { value: factor * value + by, standard: size * standard, expanded: size * expanded }.into()
    }
}

/// The number beside an estimate; `None` for what is no number.
fn number(other: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
    if other.is_instance_of::<PyEstimate>() {
        let text = "two estimates may share their errors, so that how far off both together are is not known; compute with their values, \
                    or with to_ufloat() where they are independent";
        return Err(PyTypeError::new_err(text));
    }
    Ok(other.extract().ok())
}

/// What an operator gives where it is asked with a number.
fn with_number(other: &Bound<'_, PyAny>, of: impl FnOnce(f64) -> PyEstimate) -> PyResult<Py<PyAny>> {
    let py = other.py();
    match number(other)? {
        Some(number) => Ok(Py::new(py, of(number))?.into_any()),
        None => Ok(py.NotImplemented()),
    }
}

/// How many digits behind the point the half width of an interval has a say in: two of its own.
fn places(half_width: f64) -> i32 {
    let rounded = format!("{half_width:.1e}");
    1 - rounded.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok()).unwrap_or(0)
}

/// Value and half width with the digits that mean something; with a power of ten as Python's floats have it.
fn rounded(value: f64, half_width: f64) -> String {
    if !(value.is_finite() && half_width.is_finite() && half_width > 0.0) {
        return format!("{value} ± {half_width}");
    }
    let power = value.abs().max(half_width).log10().floor() as i32;
    if (-4..16).contains(&power) {
        let places = places(half_width);
        let (step, behind) = (10_f64.powi(-places), usize::try_from(places).unwrap_or(0));
        let whole = |number: f64| if places < 0 { (number / step).round() * step } else { number };
        return format!("{:.behind$} ± {:.behind$}", whole(value), whole(half_width));
    }
    let scale = 10_f64.powi(power);
    let behind = usize::try_from(places(half_width) + power).unwrap_or(0);
    format!("({:.behind$} ± {:.behind$})e{power:+03}", value / scale, half_width / scale)
}

getters! {
    PyEstimate, self;
    /// The value, in SI units.
    value: f64 = self.estimate.value;
    /// Standard uncertainty, in the same unit.
    standard: f64 = self.estimate.standard;
    /// Half the width of the 95 % interval, in the same unit.
    expanded: f64 = self.estimate.expanded;
    /// Lower end of the 95 % interval.
    low: f64 = self.estimate.value - self.estimate.expanded;
    /// Upper end of the 95 % interval.
    high: f64 = self.estimate.value + self.estimate.expanded;
}

named_value! {
    /// Value, standard uncertainty and half width by name.
    PyEstimate, self;
    value, standard, expanded,
}

#[pymethods]
impl PyEstimate {
    #[new]
    fn new(value: Quantity, standard: Quantity, expanded: Quantity) -> PyResult<Self> {
        let (value, standard) = (value.plain("value")?, standard.plain("standard")?);
        Ok(Estimate { value, standard, expanded: expanded.plain("expanded")? }.into())
    }

    /// The same as a variable of the package uncertainties, which carries its standard uncertainty through formulas; ``pip install coilsense[uncertainties]``.
    ///
    /// To that package variables are independent of each other. Those of one object are the same variable, so that a difference with itself is zero; those of two, such as k and m
    /// of one record, count as independent even where they are not.
    ///
    /// Returns
    /// -------
    /// uncertainties.UFloat
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> stiffness = coilsense.Estimate(760.0, 0.5, 1.0).to_ufloat()
    /// >>> print(stiffness - stiffness, 1e3 / stiffness)
    /// 0.0+/-0 1.3158+/-0.0009
    fn to_ufloat<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let make = || {
            let library =
                py.import("coilsense._frames")?.call_method1("imported", ("uncertainties", "uncertainties"))?;
            Ok::<_, PyErr>(library.call_method1("ufloat", (self.estimate.value, self.estimate.standard))?.unbind())
        };
        Ok(self.variable.get_or_try_init(py, make)?.bind(py).clone())
    }

    fn __str__(&self) -> String {
        rounded(self.estimate.value, self.estimate.expanded)
    }

    fn __format__(&self, py: Python<'_>, format: &str) -> PyResult<String> {
        if format.is_empty() {
            return Ok(self.__str__());
        }
        let shown = |number: f64| PyFloat::new(py, number).call_method1("__format__", (format,))?.extract::<String>();
        Ok(format!("{} ± {}", shown(self.estimate.value)?, shown(self.estimate.expanded)?))
    }

    fn __add__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        with_number(other, |number| self.moved(1.0, number))
    }

    fn __radd__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        self.__add__(other)
    }

    fn __sub__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        with_number(other, |number| self.moved(1.0, -number))
    }

    fn __rsub__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        with_number(other, |number| self.moved(-1.0, number))
    }

    fn __mul__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        with_number(other, |number| self.moved(number, 0.0))
    }

    fn __rmul__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        self.__mul__(other)
    }

    fn __truediv__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        if number(other)? == Some(0.0) {
            return Err(PyZeroDivisionError::new_err("an estimate cannot be divided by zero"));
        }
        with_number(other, |number| self.moved(1.0 / number, 0.0))
    }

    fn __rtruediv__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        number(other)?;
        let text = "the interval of a number over an estimate is not even about its value; take it of low and high, \
                    or to first order with to_ufloat()";
        Err(PyTypeError::new_err(text))
    }

    fn __neg__(&self) -> Self {
        self.moved(-1.0, 0.0)
    }

    fn __pos__(&self) -> Self {
        self.moved(1.0, 0.0)
    }

    fn __abs__(&self) -> PyResult<Self> {
        if self.estimate.holds(0.0) {
            let text = format!(
                "the size of an estimate whose interval holds zero has another interval, got {}",
                self.__str__()
            );
            return Err(crate::errors::Error::new_err(text));
        }
        Ok(self.moved(self.estimate.value.signum(), 0.0))
    }

    fn __float__(&self) -> f64 {
        self.estimate.value
    }

    fn __contains__(&self, value: f64) -> bool {
        self.estimate.holds(value)
    }
}
