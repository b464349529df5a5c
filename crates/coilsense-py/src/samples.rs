//! Numbers of any shape, as NumPy's own functions take and give them: one in, one out; an array in, one of its shape out.
//!
//! Next door: series, whose order means something and which have one dimension (`series`); a quantity alone (`quantity`).

use std::borrow::Cow;

use coilsense_lab::quantity::Dimension;
use num_complex::Complex64;
use numpy::{Element, IntoPyArray, PyArray1, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyComplex, PyFloat, PyInt, PyString};

use crate::errors::Error;
use crate::quantity::Quantity;
use crate::series::{described, in_a_unit, real};

/// What an array holds, and what is Python's own where it is alone.
pub trait Item: Element + Copy {
    /// It alone.
    fn alone(self, py: Python<'_>) -> Bound<'_, PyAny>;
}

impl Item for f64 {
    fn alone(self, py: Python<'_>) -> Bound<'_, PyAny> {
        PyFloat::new(py, self).into_any()
    }
}

impl Item for bool {
    fn alone(self, py: Python<'_>) -> Bound<'_, PyAny> {
        PyBool::new(py, self).to_owned().into_any()
    }
}

impl Item for Complex64 {
    fn alone(self, py: Python<'_>) -> Bound<'_, PyAny> {
        PyComplex::from_doubles(py, self.re, self.im).into_any()
    }
}

/// A number, a text with its unit, a number of a library of units, or an array of any shape in SI.
pub struct Samples<'py>(Given<'py>);

enum Given<'py> {
    One(Quantity),
    Many(PyReadonlyArrayDyn<'py, f64>),
    /// Why it is neither.
    Wrong(String),
}

impl<'a, 'py> FromPyObject<'a, 'py> for Samples<'py> {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        if object.is_instance_of::<PyFloat>() || object.is_instance_of::<PyInt>() {
            return Ok(Self(Given::One(Quantity::Number(object.extract()?))));
        }
        if object.is_instance_of::<PyString>() {
            return Ok(Self(Given::One(object.extract()?)));
        }
        let shaped = object.getattr("shape").and_then(|shape| shape.len()).unwrap_or(0) > 0;
        Ok(Self(match (in_a_unit(&object), real(&object)) {
            (Some(wrong), _) if shaped => Given::Wrong(wrong),
            (Some(_), _) => Given::One(object.extract()?),
            (None, Some(array)) => match array.as_array().ndim() {
                0 => Given::One(Quantity::Number(array.as_array().sum())),
                _ => Given::Many(array),
            },
            (None, None) => Given::Wrong(format!(
                "must be a number, a text with its unit, or an array of real numbers, got {}",
                described(&object)
            )),
        }))
    }
}

impl<'py> Samples<'py> {
    /// Its numbers in SI, row by row; copied only where they do not lie one behind the other.
    pub fn si(&self, name: &str, dimension: Dimension) -> PyResult<Cow<'_, [f64]>> {
        match &self.0 {
            Given::One(quantity) => Ok(Cow::Owned(vec![quantity.si(name, dimension)?])),
            Given::Many(array) => {
                // One behind the other row by row; those of an array that is laid out column by column are, too, but in another order.
                let rows = if array.is_c_contiguous() { array.as_slice().ok() } else { None };
                Ok(rows.map_or_else(|| array.as_array().iter().copied().collect(), Cow::Borrowed))
            }
            Given::Wrong(why) => Err(PyTypeError::new_err(format!("{name} {why}"))),
        }
    }

    /// What came of each number, in the shape in which they came.
    pub fn shaped<T: Item>(&self, py: Python<'py>, values: Vec<T>) -> PyResult<Bound<'py, PyAny>> {
        self.with_axes(py, values, &[])
    }

    /// The same where several values came of each: as further dimensions at the end.
    pub fn with_axes<T: Item>(&self, py: Python<'py>, values: Vec<T>, axes: &[usize]) -> PyResult<Bound<'py, PyAny>> {
        shaped(py, values, &[self.shape(), axes].concat())
    }

    /// What a function gives for each number, in the shape in which they came.
    pub fn each<T: Item>(
        &self,
        py: Python<'py>,
        name: &str,
        dimension: Dimension,
        of: impl Fn(f64) -> T,
    ) -> PyResult<Bound<'py, PyAny>> {
        if let Given::One(quantity) = &self.0 {
            return Ok(of(quantity.si(name, dimension)?).alone(py));
        }
        let values = self.si(name, dimension)?.iter().map(|value| of(*value)).collect();
        self.shaped(py, values)
    }

    /// The same where each gives two.
    pub fn each_pair(
        &self,
        py: Python<'py>,
        name: &str,
        dimension: Dimension,
        of: impl Fn(f64) -> [f64; 2],
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let (first, second) = self.si(name, dimension)?.iter().map(|value| <(f64, f64)>::from(of(*value))).unzip();
        Ok((self.shaped(py, first)?, self.shaped(py, second)?))
    }

    fn shape(&self) -> &[usize] {
        match &self.0 {
            Given::Many(array) => array.shape(),
            _ => &[],
        }
    }
}

/// Values in a shape; of none a number of Python's own.
fn shaped<'py, T: Item>(py: Python<'py>, values: Vec<T>, shape: &[usize]) -> PyResult<Bound<'py, PyAny>> {
    if let ([], [value]) = (shape, values.as_slice()) {
        return Ok(value.alone(py));
    }
    let array = values.into_pyarray(py);
    match shape.len() {
        1 => Ok(array.into_any()),
        _ => Ok(array.reshape(shape)?.into_any()),
    }
}

/// Several of one shape, or of shapes that NumPy makes one; values of each, and how what comes of them is shaped.
pub struct Together<const N: usize> {
    /// Of each, one behind the other.
    pub values: [Vec<f64>; N],
    shape: Vec<usize>,
}

impl<const N: usize> Together<N> {
    /// Makes their shapes one.
    pub fn of<'py>(py: Python<'py>, all: [(&Samples<'py>, &str, Dimension); N]) -> PyResult<Self> {
        let mut values = [const { Vec::new() }; N];
        for (values, (samples, name, dimension)) in values.iter_mut().zip(&all) {
            *values = samples.si(name, *dimension)?.into_owned();
        }
        let shape = all[0].0.shape();
        if all.iter().all(|(samples, ..)| samples.shape() == shape) {
            return Ok(Self { values, shape: shape.to_vec() });
        }
        let numpy = py.import("numpy")?;
        let shapes = all.each_ref().map(|(samples, ..)| samples.shape());
        let called = |_| {
            let names: Vec<&str> = all.iter().map(|(_, name, _)| *name).collect();
            let got: Vec<String> =
                shapes.iter().map(|shape| format!("{shape:?}").replace('[', "(").replace(']', ")")).collect();
            Error::new_err(format!("{} must have shapes that go together, got {}", names.join(", "), got.join(", ")))
        };
        let tuples = shapes.iter().map(|shape| pyo3::types::PyTuple::new(py, *shape)).collect::<PyResult<Vec<_>>>()?;
        let common = numpy.call_method1("broadcast_shapes", pyo3::types::PyTuple::new(py, tuples)?).map_err(called)?;
        for (values, (samples, ..)) in values.iter_mut().zip(&all) {
            let given = shaped(py, std::mem::take(values), samples.shape())?;
            let wide = numpy.call_method1("broadcast_to", (given, &common))?.call_method0("ravel")?;
            *values = wide.cast::<PyArray1<f64>>()?.readonly().as_array().to_vec();
        }
        Ok(Self { values, shape: common.extract()? })
    }

    /// What came of each place, in their common shape.
    pub fn shaped<'py>(&self, py: Python<'py>, values: Vec<f64>) -> PyResult<Bound<'py, PyAny>> {
        shaped(py, values, &self.shape)
    }
}
