//! What the lab writes as JSON, as Python's own dicts: one writer for the command's files and for Python.

use std::fmt::Display;

use pyo3::prelude::*;

use crate::errors::Error;

/// The objects of a JSON text.
pub fn loads<'py>(py: Python<'py>, text: Result<String, impl Display>) -> PyResult<Bound<'py, PyAny>> {
    let text = text.map_err(|error| Error::new_err(error.to_string()))?;
    py.import("json")?.call_method1("loads", (text,))
}
