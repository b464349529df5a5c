//! A front of designs as people and machines read it: terminal text, a page, CSV, Parquet, JSON.
//!
//! Next door: what is computed (`crate::pareto`), a row's spec (`crate::sweep::Plan::spec_of`).

mod figures;
mod html;
mod json;
mod table;
mod text;

pub use json::{ParetoOutcome, pareto_json};
pub use text::pareto_text;

use super::{ReportError, draw};
use crate::output::Output;
use crate::pareto::Study;
use crate::sweep::Dataset;

/// Adds `report.html`, `results.json`, `pareto.csv`, `pareto.parquet`, and the figure as SVG and PNG where there are two objectives or more.
///
/// # Errors
/// [`ReportError`] for the first part that fails, and for an output within the sweep's folder.
pub fn add_pareto(study: &Study, dataset: &Dataset, date: &str, output: &mut Output) -> Result<(), ReportError> {
    let figure = figures::front(study).map(|figure| draw("front".to_owned(), String::new(), &figure)).transpose()?;
    output.add("report.html", html::page(study, dataset, date, figure.as_ref())?.as_bytes())?;
    output.add("results.json", pareto_json(study)?.as_bytes())?;
    output.write("pareto.csv", |file| study.front.write_csv(file))?;
    output.add("pareto.parquet", &study.front.to_parquet().map_err(|error| ReportError::Table(error.to_string()))?)?;
    for name in ["front.svg", "front.png"] {
        output.remove(name);
    }
    if let Some(figure) = &figure {
        output.add("front.svg", figure.light.as_bytes())?;
        output.add("front.png", &figure.png)?;
    }
    dataset.check_apart(&output.files())?;
    Ok(())
}
