//! An analysis as people and machines read it: terminal text, HTML, JSON, and its series.
//!
//! Next door: what is computed (`analysis`), the writer of series (`series`).

mod contact;
mod figures;
mod frequency;
mod html;
mod json;
mod json_cases;
mod modes_figure;
mod text;
mod viewer_data;

pub use json::{AnalysisOutcome, analysis_json};
pub use text::{analysis_text, analysis_warnings};

use super::ReportError;
use crate::analysis::Analysis;
use crate::output::Output;
use crate::series::{self, Format, Run};

/// Where the series of every case are.
#[cfg(feature = "parquet")]
const SERIES: (&str, Format) = ("signals.parquet", Format::Parquet);
#[cfg(not(feature = "parquet"))]
const SERIES: (&str, Format) = ("signals.csv", Format::Csv);

/// Adds all files of an analysis to `output`: `report.html`, `results.json`, and the series of every case as `signals.parquet`, or, in a
/// build without Parquet, `signals.csv`.
///
/// # Errors
/// [`ReportError`] for the first part that fails.
pub fn add_analysis(analysis: &Analysis, date: &str, output: &mut Output) -> Result<(), ReportError> {
    let runs: Vec<Run<'_>> = analysis.cases.iter().map(|case| case.series(&analysis.spec, &analysis.sensors)).collect();
    let (name, format) = SERIES;
    output.write(name, |file| series::write(&runs, format, file))?;
    output.add("report.html", html::page(analysis, date)?.as_bytes())?;
    output.add("results.json", json::analysis_json(analysis, date)?.as_bytes())?;
    Ok(())
}
