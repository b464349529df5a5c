//! A placement as people and machines read it: terminal text, HTML, JSON.
//!
//! Next door: what is computed (`crate::placement`).

mod figures;
mod html;
mod json;
mod text;

pub use json::{PlacementOutcome, placement_json};
pub use text::placement_text;

use super::ReportError;
use crate::output::Output;
use crate::placement::Placement;

/// Adds `report.html` and `results.json` to `output`.
///
/// # Errors
/// [`ReportError`] for the first part that fails.
pub fn add_placement(placement: &Placement, date: &str, output: &mut Output) -> Result<(), ReportError> {
    output.add("report.html", html::page(placement, date)?.as_bytes())?;
    output.add("results.json", placement_json(placement)?.as_bytes())?;
    Ok(())
}

/// A number that may be without bound.
fn bounded(value: f64, text: impl Fn(f64) -> String) -> String {
    if value.is_finite() { text(value) } else { "any".to_owned() }
}

/// Crossovers at which the sensitivity is at most 2: the last alone where it is so in the slowest loop, too.
fn robust([from, to]: [f64; 2], text: impl Fn(f64) -> String) -> String {
    match (from, to) {
        (_, 0.0) => "none".to_owned(),
        (0.0, to) => bounded(to, text),
        (from, to) if to.is_infinite() => format!("from {}", text(from)),
        (from, to) => format!("{} to {}", text(from), text(to)),
    }
}
