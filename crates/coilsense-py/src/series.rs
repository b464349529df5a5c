//! Series of numbers in and out: NumPy arrays of `float64` are borrowed, anything else that is like an array is converted by NumPy.
//!
//! Next door: the signals made of them (`signals`).

use std::borrow::Cow;

use numpy::{
    AllowTypeChange, IntoPyArray, PyArray1, PyArray2, PyArrayLike1, PyArrayLike2, PyArrayMethods, PyUntypedArray,
    PyUntypedArrayMethods,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

/// A series of real numbers from Python.
pub struct Series<'py>(PyArrayLike1<'py, f64, AllowTypeChange>);

/// Rows of real numbers from Python, all of one length.
pub struct Table<'py>(PyArrayLike2<'py, f64, AllowTypeChange>);

impl<'a, 'py> FromPyObject<'a, 'py> for Series<'py> {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        bare(&object)?;
        match object.extract() {
            Ok(array) if is_real(&object)? => Ok(Self(array)),
            _ => Err(refused("a series of real numbers", &object)),
        }
    }
}

impl<'a, 'py> FromPyObject<'a, 'py> for Table<'py> {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        bare(&object)?;
        match object.extract() {
            Ok(array) if is_real(&object)? => Ok(Self(array)),
            _ => Err(refused("rows of real numbers, all of one length", &object)),
        }
    }
}

impl Series<'_> {
    /// Its numbers, copied only where they do not lie one behind the other.
    pub fn values(&self) -> Cow<'_, [f64]> {
        self.0.as_slice().map_or_else(|_| Cow::Owned(self.0.as_array().to_vec()), Cow::Borrowed)
    }

    /// Its numbers, copied.
    pub fn to_vec(&self) -> Vec<f64> {
        self.values().into_owned()
    }
}

impl Table<'_> {
    /// How many numbers a row holds.
    pub fn columns(&self) -> usize {
        self.0.shape()[1]
    }

    /// Its numbers, copied row by row.
    pub fn to_vec(&self) -> Vec<f64> {
        self.0.as_array().iter().copied().collect()
    }
}

/// Refuses an array that knows its unit, as pint's and astropy's do: NumPy would take its numbers as they are, in whatever unit.
fn bare(object: &Borrowed<'_, '_, PyAny>) -> PyResult<()> {
    if object.is_exact_instance_of::<PyUntypedArray>() {
        return Ok(());
    }
    for (unit, means) in [("units", "to"), ("unit", "to_value")] {
        if let (Ok(unit), true) = (object.getattr(unit), object.hasattr(means)?) {
            let text = format!(
                "must be plain numbers in SI, got an array in {unit}: convert it first, as by .to(...).magnitude"
            );
            return Err(PyTypeError::new_err(text));
        }
    }
    Ok(())
}

fn refused(wanted: &str, object: &Borrowed<'_, '_, PyAny>) -> PyErr {
    PyTypeError::new_err(format!("must be {wanted}, got {}", described(object)))
}

/// Whether an array, where the object is one, holds real numbers: NumPy would convert a complex one, or a text, in silence.
fn is_real(object: &Borrowed<'_, '_, PyAny>) -> PyResult<bool> {
    match object.getattr("dtype").and_then(|kind| kind.getattr("kind")) {
        Ok(kind) => Ok("fiu".contains(&kind.extract::<String>()?)),
        Err(_) => Ok(!object.is_instance_of::<pyo3::types::PyString>()),
    }
}

/// An object as an error calls it.
fn described(object: &Borrowed<'_, '_, PyAny>) -> String {
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
