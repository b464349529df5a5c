//! What `coilsense analyze` concludes of a spec: every condition under every damping, every sensor within its tolerances.
//!
//! Next door: the case that is shown (`exact`), how it is concluded (`coilsense_lab::analysis`).

use coilsense_lab::analysis::Analysis;
use coilsense_lab::report::analysis_json;
use coilsense_lab::spec::Spec;
use serde_json::{Value, json};

use crate::answer::Answer;

/// As `coilsense analyze --json` prints it, without a date; `told` hears how many cases are computed, and of how many.
///
/// # Errors
/// One line: what the science says of the spec.
pub fn run(spec: Spec, told: &(dyn Fn(usize, usize) + Sync)) -> Result<Answer, String> {
    let watched = |done, of| {
        told(done, of);
        true
    };
    let analysis = Analysis::run(spec, &watched).map_err(|error| error.to_string())?;
    let text = analysis_json(&analysis, "").map_err(|error| error.to_string())?;
    let told: Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    Ok(Answer::new(&json!({ "json": told }), Vec::new()))
}
