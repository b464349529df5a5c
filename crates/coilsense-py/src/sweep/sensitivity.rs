//! `coilsense.sensitivity` and `Sensitivity`: what the numbers of a sweep hang on.
//!
//! Next door: its best designs (`pareto`), the folder (`dataset`).

use std::path::PathBuf;
use std::sync::Arc;

use coilsense_lab::report::{add_sensitivity, sensitivity_json, sensitivity_text};
use coilsense_lab::sensitivity::{Estimate, Index, Resampling, Study, answer};
use coilsense_lab::sweep::Dataset;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::Folder;
use crate::count::Count;
use crate::errors::IntoPython;
use crate::long_work::interruptible;
use crate::names::{Names, listed};
use crate::results::study_result;
use crate::value::getters;

/// Sobol's indices of a sweep's columns; made by `sensitivity`. ``str()`` of it is what ``coilsense sensitivity`` prints.
#[pyclass(name = "Sensitivity", module = "coilsense", frozen, eq)]
pub struct PySensitivity {
    study: Arc<Study>,
    folder: PathBuf,
}

impl PartialEq for PySensitivity {
    fn eq(&self, other: &Self) -> bool {
        self.study == other.study
    }
}

impl PySensitivity {
    /// Estimates with their intervals by column and key; columns without indices are left out.
    fn by_column<'py>(&self, py: Python<'py>, of: fn(&Index) -> &Estimate) -> PyResult<Bound<'py, PyDict>> {
        let columns = PyDict::new(py);
        for column in &self.study.columns {
            let Ok(found) = &column.found else { continue };
            let keys = PyDict::new(py);
            for (key, index) in self.study.variables.iter().zip(&found.variables) {
                let Estimate { value, lower, upper } = *of(index);
                keys.set_item(key, (value, lower, upper))?;
            }
            columns.set_item(&column.title, keys)?;
        }
        Ok(columns)
    }
}

getters! {
    PySensitivity, self;
    /// The answer, a sentence each.
    answer: Vec<String> = answer(&self.study);
    /// Keys of what is varied.
    variables: Vec<String> = self.study.variables.clone();
    /// S_1 of each column by key, with its interval: (value, lower, upper). What would go of the column's variance were the key alone known.
    first_order<'py>(py): PyResult<Bound<'py, PyDict>> = self.by_column(py, |index| &index.first);
    /// S_T of each column by key, with its interval: (value, lower, upper). What would stay of the column's variance were all others known.
    total<'py>(py): PyResult<Bound<'py, PyDict>> = self.by_column(py, |index| &index.total);
}

study_result! {
    PySensitivity, self;
    /// Everything, under the names of results.json.
    to_dict = sensitivity_json(&self.study);
    /// A row for each column and key as a data frame of pandas; ``pip install coilsense[pandas]``.
    to_pandas = "indices_frame";
    /// Draws total indices with their intervals with matplotlib; ``pip install coilsense[plot]``.
    plot = "sensitivity_plot";
    str = sensitivity_text(&self.study);
    html = "sensitivity_html";
    /// Writes what ``coilsense sensitivity --out`` writes: report.html and results.json; all of it or nothing.
    save(date, output; dataset = Dataset::open(&self.folder).python()?) = add_sensitivity(&self.study, &dataset, date, output);
}

#[pymethods]
impl PySensitivity {
    /// Why there are no indices of a column, by its title.
    #[getter]
    fn without<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for column in &self.study.columns {
            if let Err(error) = &column.found {
                dict.set_item(&column.title, error.to_string())?;
            }
        }
        Ok(dict)
    }

    fn __repr__(&self) -> String {
        let (columns, variables) = (self.study.columns.len(), self.study.variables.len());
        format!("<Sensitivity of {}: {columns} columns to {variables} keys>", self.folder.display())
    }
}

/// First-order and total sensitivity indices of a sweep's columns with respect to what was varied.
///
/// Parameters
/// ----------
/// sweep : SweepDataset, str or os.PathLike
///     A folder that `sweep` made with ``sampling="saltelli"``.
/// of : str or sequence of str, optional
///     Columns, with or without their units; without any all that hold numbers.
/// resamples : int
///     How often base rows are drawn anew for the intervals of 95 %, at least 20.
/// seed : int
///     Of those draws.
///
/// Returns
/// -------
/// Sensitivity
///
/// Raises
/// ------
/// SweepError
///     Where the sweep was laid out otherwise, a column is not there, or there are no indices of a column that was asked for.
///
/// Notes
/// -----
/// Source: [Saltelli2010]; checked against SALib. An index is about the ranges and distributions of the sweep.
#[pyfunction]
#[pyo3(signature = (sweep, of=None, *, resamples=Count::Number(1000), seed=Count::Number(0)),
       text_signature = "(sweep, of=None, *, resamples=1000, seed=0)")]
pub fn sensitivity(
    py: Python<'_>,
    sweep: Folder<'_>,
    of: Option<Names>,
    resamples: Count,
    seed: Count,
) -> PyResult<PySensitivity> {
    let (folder, of) = (sweep.path()?, listed(of, "of")?);
    let (resamples, seed) = (resamples.size("resamples")?, seed.number("seed")?);
    let from = folder.clone();
    let resampling = Resampling { resamples, seed, ..Resampling::default() };
    let study = interruptible(py, move || Study::of(&Dataset::open(&from)?, &of, resampling))?;
    Ok(PySensitivity { study: Arc::new(study.python()?), folder })
}
