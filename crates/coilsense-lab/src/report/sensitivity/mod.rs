//! What a sweep's columns hang on, as people and machines read it: terminal text, a page, JSON.
//!
//! Next door: what is computed (`crate::sensitivity`).

mod figures;
mod html;
mod json;
mod text;

pub use json::{SensitivityOutcome, sensitivity_json};
pub use text::sensitivity_text;

use super::ReportError;
use crate::output::Output;
use crate::sensitivity::Study;
use crate::sweep::Dataset;

/// Adds `report.html` and `results.json` to `output`.
///
/// # Errors
/// [`ReportError`] for the first part that fails, and for an output within the sweep's folder.
pub fn add_sensitivity(study: &Study, dataset: &Dataset, date: &str, output: &mut Output) -> Result<(), ReportError> {
    output.add("report.html", html::page(study, dataset, date)?.as_bytes())?;
    output.add("results.json", sensitivity_json(study)?.as_bytes())?;
    dataset.check_apart(&output.files())?;
    Ok(())
}
