//! What a notebook shows of a noun: a small table, made by `coilsense/_html.py`.

use pyo3::prelude::*;

/// The table of a noun, by the function of that name.
pub fn shown<'py>(noun: &Bound<'py, PyAny>, function: &str) -> PyResult<Bound<'py, PyAny>> {
    noun.py().import("coilsense._html")?.call_method1(function, (noun,))
}
