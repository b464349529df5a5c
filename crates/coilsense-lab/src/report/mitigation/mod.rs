//! What to do about ringing as people and machines read it: a page, text, JSON, the trade-off drawn, settings to paste.
//!
//! Next door: what is computed (`crate::mitigation`).

mod figures;
mod html;
mod json;
mod shaping;
mod text;

pub use json::{MitigationOutcome, mitigation_json};
pub use text::mitigation_text;

use super::{ReportError, draw};
use crate::mitigation::export::{Export, Precision};
use crate::mitigation::{Ranking, Truth};
use crate::output::Output;
use crate::spec::Spec;

/// What is exported: for which force, and under which name.
const EXPORTS: [(Truth, &str); 2] = [(Truth::Static, "force_filter"), (Truth::Output, "force_estimator")];

/// Adds `report.html`, `results.json`, the trade-off as a figure, and the best filter's and estimator's settings as JSON, C and Rust.
///
/// # Errors
/// [`ReportError`] for the first part that fails.
pub fn add_mitigation(
    answer: &Ranking,
    spec: &Spec,
    date: &str,
    precision: Precision,
    output: &mut Output,
) -> Result<(), ReportError> {
    let drawn = draw("trade-off".to_owned(), String::new(), &figures::trade_off(answer))?;
    output.add("report.html", html::page(answer, spec, date, &drawn)?.as_bytes())?;
    output.add("results.json", mitigation_json(answer)?.as_bytes())?;
    output.add("trade-off.svg", drawn.light.as_bytes())?;
    output.add("trade-off.png", &drawn.png)?;
    for (truth, name) in EXPORTS {
        let Some(settings) = answer.best(truth).and_then(|(candidate, _)| candidate.settings()) else { continue };
        let export = Export::new(name, answer.study.rate, precision, settings)?;
        output.add(&format!("{name}.json"), (serde_json::to_string_pretty(&export.json())? + "\n").as_bytes())?;
        output.add(&format!("{name}.h"), export.c()?.as_bytes())?;
        output.add(&format!("{name}.rs"), export.rust().as_bytes())?;
    }
    Ok(())
}
