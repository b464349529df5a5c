//! `coilsense.SweepPlan` and `coilsense.SweepDataset`: what decides the rows of a sweep, and the folder that they go into; and what is asked of one
//! afterwards, `coilsense.pareto` and `coilsense.sensitivity`.
//!
//! Next door: `coilsense.sweep`, which runs a plan here or on a Dask cluster (`python/coilsense/_sweep.py`).

pub mod dataset;
pub mod pareto;
pub mod plan;
pub mod sensitivity;

use std::path::PathBuf;

use coilsense_lab::sweep::Data;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::quantity::{Anything, neither};

/// A sweep's folder: as it was opened, or where it is.
#[derive(FromPyObject)]
pub enum Folder<'py> {
    Opened(PyRef<'py, dataset::PySweepDataset>),
    Path(PathBuf),
    Other(Anything),
}

impl Folder<'_> {
    fn path(self) -> PyResult<PathBuf> {
        match self {
            Self::Opened(dataset) => Ok(dataset.folder.clone()),
            Self::Path(path) => Ok(path),
            Self::Other(object) => Err(neither("sweep", "a SweepDataset or its folder", &object)),
        }
    }
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
