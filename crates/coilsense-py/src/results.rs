//! What results of the lab have in common: the command's text, its files, and how Python lays them out.
//!
//! Next door: JSON as a dict (`json`), the results (`identification`, `calibration`, `experiment`, `mitigation`, `placement`).

use std::path::Path;

use coilsense_lab::output::Output;
use coilsense_lab::report::ReportError;
use pyo3::prelude::*;

use crate::analysis::day;
use crate::errors::IntoPython;

/// The text that the command prints, without colours.
pub fn plain(text: &str) -> String {
    anstream::adapter::strip_str(text).to_string()
}

/// Writes into a folder what the command writes there, all of it or nothing; returns how many files.
pub fn save(
    py: Python<'_>,
    folder: &Path,
    date: Option<String>,
    add: impl FnOnce(&str, &mut Output) -> Result<(), ReportError> + Send,
) -> PyResult<usize> {
    let date = day(py, date)?;
    let written = || -> Result<usize, ReportError> {
        let mut output = Output::begin(folder)?;
        add(&date, &mut output)?;
        Ok(output.commit()?)
    };
    py.detach(written).python()
}

/// A function of the Python code beside this module that lays results out: tables, plots, pages for notebooks.
pub fn laid_out<'py>(
    py: Python<'py>,
    name: &str,
    arguments: impl pyo3::call::PyCallArgs<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    py.import("coilsense._results")?.getattr(name)?.call1(arguments)
}
