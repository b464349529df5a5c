//! An experiment as people and machines read it: terminal text, HTML, JSON, Figs. 5 and 6.
//!
//! Next door: what is computed (`crate::experiment`).

mod figures;
mod html;
mod json;
mod means;
mod style;
mod text;

pub use json::{ExperimentOutcome, experiment_json};
pub use text::experiment_text;

use rayon::prelude::*;

use super::{Drawn, ReportError, draw};
use crate::experiment::{Experiment, Findings};
use crate::output::Output;

/// Adds all files of an experiment to `output`: `report.html`, `results.json`, `figures/*`.
///
/// # Errors
/// [`ReportError`] for the first part that fails.
pub fn add_experiment(
    experiment: &Experiment,
    findings: &Findings,
    date: &str,
    output: &mut Output,
) -> Result<(), ReportError> {
    let drawn: Vec<Drawn> = figures::all(experiment, findings)
        .into_par_iter()
        .map(|(name, caption, figure)| draw(name, caption, &figure))
        .collect::<Result<_, _>>()?;
    for name in figures::NAMES {
        output.remove(&format!("figures/{name}.svg"));
        output.remove(&format!("figures/{name}.png"));
    }
    for figure in &drawn {
        output.add(&format!("figures/{}.svg", figure.name), figure.light.as_bytes())?;
        output.add(&format!("figures/{}.png", figure.name), &figure.png)?;
    }
    output.add("report.html", html::page(experiment, findings, date, &drawn)?.as_bytes())?;
    output.add("results.json", experiment_json(experiment, findings, Some(date))?.as_bytes())?;
    Ok(())
}
