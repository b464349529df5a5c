//! `coilsense.simulate` and `analyze`: a spec processed.
//!
//! Next door: the spec (`spec`), progress and Ctrl-C (`progress`).

mod case;
mod contact;
mod together;

use std::path::PathBuf;
use std::sync::OnceLock;

use coilsense_lab::analysis::{Analysis, Check, answer, simulate};
use coilsense_lab::output::Output;
use coilsense_lab::report::{ReportError, add_analysis, analysis_json, analysis_text, analysis_warnings};
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::json;
use crate::long_work::watched;
use crate::results::table_and_figure;
use crate::spec_argument::SpecArgument;
use crate::threads::spread;
use crate::value::getters;
pub use case::PyCase;
pub use together::{PyTogether, py_simulate_together};

/// Simulates every condition of a spec under every damping, on all cores.
///
/// Parameters
/// ----------
/// spec : Spec, str or os.PathLike
///     What to simulate: a spec, its file, or its text where that holds a line break.
/// progress : callable, optional
///     Called as ``progress(done, of)`` now and then; an exception of it stops the work.
///
/// Returns
/// -------
/// list of Case
///     Condition by condition.
///
/// Raises
/// ------
/// AnalysisError
///     For a spec without conditions or of several springs (`simulate_together` takes those), or the first case that the science refuses.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> cases = coilsense.simulate(coilsense.Spec.parse(coilsense.Spec.template("S_T")))
/// >>> cases[0].condition, cases[0].signals["F_o"].shape == cases[0].readings["laser"].shape
/// ('heel strike', True)
#[pyfunction(name = "simulate")]
#[pyo3(signature = (spec, progress=None))]
pub fn py_simulate(
    py: Python<'_>,
    spec: SpecArgument<'_>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Vec<PyCase>> {
    let spec = &spec.spec(py)?;
    let cases = watched(py, progress.as_ref(), |progress| simulate(spec, progress))?.python()?;
    cases.into_iter().map(|case| PyCase::of(py, spec, &spec.sensors, case)).collect()
}

/// Works a spec off: which sensor meets the goal, what breaks it, what would fix it.
///
/// Parameters
/// ----------
/// spec : Spec, str or os.PathLike
///     What to analyze: a spec, its file, or its text where that holds a line break.
/// progress : callable, optional
///     Called as ``progress(done, of)`` now and then; an exception of it stops the work.
///
/// Returns
/// -------
/// Analysis
///
/// Raises
/// ------
/// AnalysisError
///     As `simulate`.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> analysis = coilsense.analyze(coilsense.Spec.parse(coilsense.Spec.template("S_T")))
/// >>> analysis.answer[0].startswith("Choose")
/// True
#[pyfunction(name = "analyze")]
#[pyo3(signature = (spec, progress=None))]
pub fn py_analyze(py: Python<'_>, spec: SpecArgument<'_>, progress: Option<Bound<'_, PyAny>>) -> PyResult<PyAnalysis> {
    let spec = spec.spec(py)?;
    let analysis = watched(py, progress.as_ref(), |progress| Analysis::run(spec, progress))?.python()?;
    Ok(PyAnalysis { analysis, cases: OnceLock::new() })
}

/// A spec, processed; made by `analyze`.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
/// >>> analysis = coilsense.analyze(spec)
/// >>> analysis.ranking[0]
/// 'load cell, load side'
/// >>> round(analysis.uncertainties[analysis.ranking[0]], 3)
/// 0.073
#[pyclass(name = "Analysis", module = "coilsense", frozen)]
pub struct PyAnalysis {
    analysis: Analysis,
    cases: OnceLock<Vec<Py<PyCase>>>,
}

getters! {
    PyAnalysis, self;
    /// The answer in sentences, the most important first, as a list of str.
    answer: Vec<String> = answer(&self.analysis);
    /// Whether it settles what the spec asks for: ``"met"``, ``"missed"`` or ``"undecided"``, as ``coilsense analyze --check`` has it.
    check: &str = match Check::of(&self.analysis) {
        Check::Met(_) => "met",
        Check::Missed(_) => "missed",
        Check::Undecided(_) => "undecided",
    };
    /// What the command prints.
    text: String = anstream::adapter::strip_str(&analysis_text(&self.analysis)).to_string()
        + &analysis_warnings(&self.analysis).iter().map(|line| format!("Warning: {line}\n")).collect::<String>();
    /// What a reader must know before using the numbers, as a list of str.
    warnings: Vec<&str> = self.analysis.warnings.iter().map(|warning| warning.text.as_str()).collect();
}

table_and_figure! {
    PyAnalysis;
    /// Deviations as a data frame of pandas: one row per case and force; ``pip install coilsense[pandas]``.
    to_pandas = "deviations_frame";
    /// Draws the uncertainty of each sensor in its worst case with matplotlib; ``pip install coilsense[plot]``.
    plot = "analysis_plot";
}

#[pymethods]
impl PyAnalysis {
    /// The sensors' names, best first.
    #[getter]
    fn ranking(&self) -> Vec<&str> {
        let name = |index: usize| self.analysis.sensors[index].name.as_str();
        self.analysis.verdicts.iter().map(|verdict| name(verdict.sensor)).collect()
    }

    /// Combined standard uncertainty of each sensor in its worst case [N], best first, as a dict by the sensor's name.
    #[getter]
    fn uncertainties<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, pyo3::types::PyDict>> {
        let dict = pyo3::types::PyDict::new(py);
        for (name, verdict) in self.ranking().into_iter().zip(&self.analysis.verdicts) {
            dict.set_item(name, verdict.combined())?;
        }
        Ok(dict)
    }

    /// Every condition under every damping, condition by condition, as a list of `Case`.
    #[getter]
    fn cases(&self, py: Python<'_>) -> PyResult<Vec<Py<PyCase>>> {
        if self.cases.get().is_none() {
            let (spec, sensors) = (&self.analysis.spec, &self.analysis.sensors);
            let each = self.analysis.cases.iter().cloned();
            let made = each.map(|case| Py::new(py, PyCase::of(py, spec, sensors, case)?));
            let made = made.collect::<PyResult<Vec<_>>>()?;
            // Another thread may have been faster; its cases are the same.
            let _ = self.cases.set(made);
        }
        Ok(self.cases.get().into_iter().flatten().map(|case| case.clone_ref(py)).collect())
    }

    /// Everything, as ``results.json`` has it; what was not computed is None.
    ///
    /// Parameters
    /// ----------
    /// date : str, optional
    ///     The date that it carries; today without it.
    ///
    /// Returns
    /// -------
    /// dict
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> coilsense.analyze(spec).to_dict(date="2026-11-21")["schema"]
    /// 'coilsense/analysis/1'
    #[pyo3(signature = (date=None))]
    fn to_dict<'py>(&self, py: Python<'py>, date: Option<String>) -> PyResult<Bound<'py, PyAny>> {
        let date = day(py, date)?;
        json::loads(py, spread(py, || analysis_json(&self.analysis, &date))?)
    }

    /// Writes what ``coilsense analyze`` writes: report.html, results.json, signals.parquet; all of it, or nothing.
    ///
    /// Parameters
    /// ----------
    /// folder : str or os.PathLike
    ///     Where; its other files are left alone.
    /// date : str, optional
    ///     The date that the report carries; today without it.
    /// overwrite : bool
    ///     Whether files are replaced, too, that coilsense did not write or that have changed since.
    ///
    /// Returns
    /// -------
    /// int
    ///     How many files.
    ///
    /// Raises
    /// ------
    /// OutputError
    ///     Where the folder cannot be written; it is then as it was.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, tempfile
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> coilsense.analyze(spec).save(tempfile.mkdtemp()) > 2
    /// True
    #[pyo3(signature = (folder, date=None, overwrite=false))]
    fn save(&self, py: Python<'_>, folder: PathBuf, date: Option<String>, overwrite: bool) -> PyResult<usize> {
        let date = day(py, date)?;
        let written = spread(py, || {
            let mut output = Output::begin(&folder)?.overwriting(overwrite);
            add_analysis(&self.analysis, &date, &mut output)?;
            Ok::<usize, ReportError>(output.commit()?)
        })?;
        written.python()
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        crate::html::shown(slf.as_any(), "analysis")
    }

    fn __repr__(&self) -> String {
        format!("<Analysis of {}: {}>", self.analysis.spec.file, self.answer().first().map_or("", String::as_str))
    }
}

/// The date as it is given, or today's.
pub fn day(py: Python<'_>, date: Option<String>) -> PyResult<String> {
    match date {
        Some(date) => Ok(date),
        None => py.import("datetime")?.getattr("date")?.call_method0("today")?.call_method0("isoformat")?.extract(),
    }
}
