//! A calibration as people and machines read it: terminal text, HTML, JSON, figures.
//!
//! Next door: what is computed (`crate::calibration`).

mod figures;
mod html;
mod json;
mod text;

pub use json::{CalibrationOutcome, calibration_json};
pub use text::calibration_text;

use rayon::prelude::*;

use super::{Drawn, ReportError, draw};
use crate::calibration::{Outcome, StoredCalibration};
use crate::output::Output;

/// Adds all files of a calibration to `output`: `report.html`, `results.json`, `figures/*`, and `calibration.toml`, which reads lengths from other logs.
///
/// # Errors
/// [`ReportError`] for the first part that fails.
pub fn add_calibration(outcome: &Outcome, date: &str, output: &mut Output) -> Result<(), ReportError> {
    let drawn: Vec<Drawn> = figures::all(outcome)
        .into_par_iter()
        .map(|(name, caption, figure)| draw(name, caption, &figure))
        .collect::<Result<_, _>>()?;
    for figure in &drawn {
        output.add(&format!("figures/{}.svg", figure.name), figure.light.as_bytes())?;
        output.add(&format!("figures/{}.png", figure.name), &figure.png)?;
    }
    output.add("report.html", html::page(outcome, date, &drawn)?.as_bytes())?;
    if let Ok(stored) = StoredCalibration::of(outcome) {
        output.add("calibration.toml", stored.to_text(date).as_bytes())?;
    }
    output.add("results.json", calibration_json(outcome, Some(date))?.as_bytes())?;
    Ok(())
}
