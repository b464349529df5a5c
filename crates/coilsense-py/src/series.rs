//! Series of numbers in and out: NumPy arrays of `float64` are borrowed, anything else that is like an array is converted by NumPy.
//!
//! Next door: the signals made of them (`signals`).

use std::borrow::Cow;

use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArray,
    PyUntypedArrayMethods,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyString};

/// Real numbers from Python, or what is said of them by their argument's name.
type Taken<'py> = Result<PyReadonlyArrayDyn<'py, f64>, String>;

/// A series of real numbers from Python.
pub struct Series<'py>(Taken<'py>);

/// Rows of real numbers from Python, all of one length.
pub struct Table<'py>(Taken<'py>);

impl<'a, 'py> FromPyObject<'a, 'py> for Series<'py> {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        Ok(Self(taken(&object, 1, "a series of real numbers")))
    }
}

impl<'a, 'py> FromPyObject<'a, 'py> for Table<'py> {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        Ok(Self(taken(&object, 2, "rows of real numbers, all of one length")))
    }
}

impl Series<'_> {
    /// Its numbers, copied only where they do not lie one behind the other.
    ///
    /// # Errors
    /// `TypeError` for what is no series, by the argument's name.
    pub fn values(&self, name: &str) -> PyResult<Cow<'_, [f64]>> {
        let array = named(&self.0, name)?;
        Ok(array.as_slice().map_or_else(|_| array.as_array().iter().copied().collect(), Cow::Borrowed))
    }

    /// Its numbers, copied.
    pub fn to_vec(&self, name: &str) -> PyResult<Vec<f64>> {
        self.values(name).map(Cow::into_owned)
    }
}

impl Table<'_> {
    /// Its numbers, copied row by row, and how many a row holds.
    pub fn to_vec(&self, name: &str) -> PyResult<(Vec<f64>, usize)> {
        let array = named(&self.0, name)?;
        Ok((array.as_array().iter().copied().collect(), array.shape()[1]))
    }
}

fn named<'a, 'py>(taken: &'a Taken<'py>, name: &str) -> PyResult<&'a PyReadonlyArrayDyn<'py, f64>> {
    taken.as_ref().map_err(|why| PyTypeError::new_err(format!("{name} {why}")))
}

/// An object as an array of so many dimensions.
fn taken<'py>(object: &Borrowed<'_, 'py, PyAny>, dimensions: usize, wanted: &str) -> Taken<'py> {
    if let Some(wrong) = in_a_unit(object) {
        return Err(wrong);
    }
    match real(object) {
        Some(array) if array.as_array().ndim() == dimensions => Ok(array),
        _ => Err(format!("must be {wanted}, got {}", described(object))),
    }
}

/// What is said of an array that knows its unit, as pint's and astropy's do: NumPy would take its numbers as they are, in whatever unit.
pub fn in_a_unit(object: &Borrowed<'_, '_, PyAny>) -> Option<String> {
    if object.is_exact_instance_of::<PyUntypedArray>() {
        return None;
    }
    let found = [("units", "to"), ("unit", "to_value")].into_iter().find_map(|(unit, means)| {
        let unit = object.getattr(unit).ok()?;
        object.hasattr(means).unwrap_or(false).then_some(unit)
    });
    found.map(|unit| {
        format!("must be plain numbers in SI, got an array in {unit}: convert it first, as by .to(...).magnitude")
    })
}

/// An object as an array of real numbers of any shape; what NumPy would make of a complex one, a text, a truth value or of nothing is none.
pub fn real<'py>(object: &Borrowed<'_, 'py, PyAny>) -> Option<PyReadonlyArrayDyn<'py, f64>> {
    if let Ok(array) = object.cast::<PyArrayDyn<f64>>() {
        return array.try_readonly().ok();
    }
    if object.is_none() || object.is_instance_of::<PyString>() || object.is_instance_of::<PyBytes>() {
        return None;
    }
    let array = object.py().import("numpy").and_then(|numpy| numpy.call_method1("asarray", (object,))).ok()?;
    let kind: String =
        array.getattr("dtype").and_then(|kind| kind.getattr("kind")).and_then(|kind| kind.extract()).ok()?;
    let numbers = match kind.as_str() {
        "f" | "i" | "u" => true,
        // Fractions and decimals, but not the None that NumPy would take for a nan.
        "O" => array
            .getattr("flat")
            .and_then(|all| all.try_iter())
            .ok()?
            .all(|item| item.is_ok_and(|item| is_number(&item))),
        _ => false,
    };
    let array = numbers.then(|| array.call_method1("astype", ("float64",)).ok()).flatten()?;
    array.cast::<PyArrayDyn<f64>>().ok()?.try_readonly().ok()
}

fn is_number(object: &Bound<'_, PyAny>) -> bool {
    !object.is_instance_of::<PyString>() && object.extract::<f64>().is_ok()
}

/// An object as an error calls it.
pub fn described(object: &Borrowed<'_, '_, PyAny>) -> String {
    let class = object.get_type().name().map_or_else(|_| "an object".to_owned(), |name| name.to_string());
    match (object.getattr("dtype"), object.getattr("shape")) {
        (Ok(kind), Ok(shape)) => format!("{class} of dtype {kind} and shape {shape}"),
        _ => class,
    }
}

/// A series moved into a NumPy array that cannot be written to: a value's own.
pub fn frozen(py: Python<'_>, values: Vec<f64>) -> Py<PyArray1<f64>> {
    let array = values.into_pyarray(py);
    array.readwrite().make_nonwriteable();
    array.unbind()
}

/// Rows moved into a NumPy array of shape `rows × columns`.
pub fn rows<'py>(py: Python<'py>, values: Vec<f64>, columns: usize) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let count = values.len().checked_div(columns).unwrap_or(0);
    values.into_pyarray(py).reshape([count, columns])
}

/// The same where it cannot be written to.
pub fn frozen_rows(py: Python<'_>, values: Vec<f64>, columns: usize) -> PyResult<Py<PyArray2<f64>>> {
    let array = rows(py, values, columns)?;
    array.readwrite().make_nonwriteable();
    Ok(array.unbind())
}

/// The numbers of an array that this module made itself, one behind the other.
pub fn numbers<'py, D: numpy::ndarray::Dimension>(array: &Bound<'py, numpy::PyArray<f64, D>>) -> Vec<f64> {
    debug_assert!(array.is_contiguous());
    array.readonly().as_array().iter().copied().collect()
}
