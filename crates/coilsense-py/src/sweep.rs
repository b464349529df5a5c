//! `coilsense.SweepPlan` and `coilsense.SweepDataset`: what decides the rows of a sweep, and the folder that they go into.
//!
//! Next door: `coilsense.sweep`, which runs a plan here or on a Dask cluster (`python/coilsense/_sweep.py`).

mod dataset;
mod plan;

use coilsense_lab::sweep::Data;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// Adds the classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<plan::PySweepPlan>()?;
    module.add_class::<dataset::PySweepDataset>()
}

/// Columns by title: arrays of numbers, lists of texts and of truths.
fn by_title<'py, 't>(
    py: Python<'py>,
    columns: impl IntoIterator<Item = (&'t str, Data)>,
) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for (title, data) in columns {
        match data {
            Data::Whole(values) => dict.set_item(title, values.into_pyarray(py))?,
            Data::Numbers(values) => dict.set_item(title, values.into_pyarray(py))?,
            Data::Texts(values) => dict.set_item(title, PyList::new(py, values)?)?,
            Data::Flags(values) => dict.set_item(title, PyList::new(py, values)?)?,
        }
    }
    Ok(dict)
}
