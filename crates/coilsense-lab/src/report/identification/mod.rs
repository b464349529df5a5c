//! An identification as people and machines read it: terminal text, HTML, JSON, figures.
//!
//! Next door: what is computed (`crate::identification`).

mod figures;
mod html;
mod json;
mod text;

pub use json::{IdentificationOutcome, identification_json};
pub use text::identification_text;

use super::{Drawn, ReportError, draw};
use crate::identification::Identified;
use crate::output::Output;

/// Adds all files of an identification to `output`: `report.html`, `results.json`, `figures/*`.
///
/// # Errors
/// [`ReportError`] for the first part that fails.
pub fn add_identification(identified: &Identified, date: &str, output: &mut Output) -> Result<(), ReportError> {
    let drawn: Vec<Drawn> = figures::all(identified)
        .into_iter()
        .map(|(name, caption, figure)| draw(name, caption, &figure))
        .collect::<Result<_, _>>()?;
    for figure in &drawn {
        output.add(&format!("figures/{}.svg", figure.name), figure.light.as_bytes())?;
        output.add(&format!("figures/{}.png", figure.name), &figure.png)?;
    }
    output.add("report.html", html::page(identified, date, &drawn)?.as_bytes())?;
    output.add("results.json", identification_json(identified, Some(date))?.as_bytes())?;
    Ok(())
}
