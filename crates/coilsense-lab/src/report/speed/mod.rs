//! A speed map as people and machines read it: terminal text, HTML, JSON, and a table of all runs.
//!
//! Next door: what is computed (`crate::speed`).

mod figures;
mod html;
mod json;
mod table;
mod text;

pub use json::{SpeedOutcome, speed_json};
pub use table::speed_columns;
pub use text::speed_text;

use super::ReportError;
use crate::output::Output;
use crate::speed::SpeedMap;

/// Adds `report.html`, `results.json`, `speed.csv` and the same as `speed.parquet` to `output`.
///
/// # Errors
/// [`ReportError`] for the first part that fails.
pub fn add_speed(map: &SpeedMap, date: &str, output: &mut Output) -> Result<(), ReportError> {
    output.add("report.html", html::page(map, date)?.as_bytes())?;
    output.add("results.json", speed_json(map)?.as_bytes())?;
    output.add("speed.csv", table::csv(map).as_bytes())?;
    #[cfg(feature = "parquet")]
    output.add("speed.parquet", &table::parquet(map).map_err(|error| ReportError::Table(error.to_string()))?)?;
    Ok(())
}
