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
use crate::errors::IntoPython;
use crate::json;
use crate::long_work::interruptible;
use crate::results::{laid_out, plain, save};

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

#[pymethods]
impl PySensitivity {
    /// The answer, a sentence each.
    #[getter]
    fn answer(&self) -> Vec<String> {
        answer(&self.study)
    }

    /// Keys of what is varied.
    #[getter]
    fn variables(&self) -> Vec<String> {
        self.study.variables.clone()
    }

    /// S_1 of each column by key, with its interval: (value, lower, upper). What would go of the column's variance were the key alone known.
    #[getter]
    fn first_order<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.by_column(py, |index| &index.first)
    }

    /// S_T of each column by key, with its interval: (value, lower, upper). What would stay of the column's variance were all others known.
    #[getter]
    fn total<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.by_column(py, |index| &index.total)
    }

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

    /// Writes what ``coilsense sensitivity --out`` writes: report.html and results.json; all of it or nothing.
    ///
    /// Parameters
    /// ----------
    /// folder : str or os.PathLike
    ///     Its other files are left alone.
    /// date : str, optional
    ///     What the report carries; without it, today's.
    ///
    /// Returns
    /// -------
    /// int
    ///     How many files.
    #[pyo3(signature = (folder, date=None))]
    fn save(&self, py: Python<'_>, folder: PathBuf, date: Option<String>) -> PyResult<usize> {
        let dataset = Dataset::open(&self.folder).python()?;
        save(py, &folder, date, |date, output| add_sensitivity(&self.study, &dataset, date, output))
    }

    /// Everything, under the names of results.json.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        json::loads(py, sensitivity_json(&self.study))
    }

    /// A row for each column and key as a data frame of pandas; ``pip install coilsense[pandas]``.
    ///
    /// Returns
    /// -------
    /// pandas.DataFrame
    fn to_pandas<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        laid_out(slf.py(), "indices_frame", (slf,))
    }

    fn __str__(&self) -> String {
        plain(&sensitivity_text(&self.study))
    }

    fn __repr__(&self) -> String {
        let (columns, variables) = (self.study.columns.len(), self.study.variables.len());
        format!("<Sensitivity of {}: {columns} columns to {variables} keys>", self.folder.display())
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        laid_out(slf.py(), "sensitivity_html", (slf,))
    }
}

/// First-order and total sensitivity indices of a sweep's columns with respect to what was varied.
///
/// Parameters
/// ----------
/// sweep : SweepDataset, str or os.PathLike
///     A folder that `sweep` made with ``sampling="saltelli"``.
/// of : sequence of str
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
#[pyo3(signature = (sweep, of=Vec::new(), *, resamples=1000, seed=0))]
pub fn sensitivity(
    py: Python<'_>,
    sweep: Folder<'_>,
    of: Vec<String>,
    resamples: usize,
    seed: u64,
) -> PyResult<PySensitivity> {
    let folder = sweep.path();
    let from = folder.clone();
    let resampling = Resampling { resamples, seed, ..Resampling::default() };
    let study = interruptible(py, move || Study::of(&Dataset::open(&from)?, &of, resampling))?;
    Ok(PySensitivity { study: Arc::new(study.python()?), folder })
}
