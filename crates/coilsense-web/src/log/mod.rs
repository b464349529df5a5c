//! A log that the user drops: its columns, what `coilsense identify` says of it, and a calibration where it holds inductances.
//!
//! | file | holds |
//! |---|---|
//! | `asked` | what the user says of it |
//! | `identified` | what it says, and the spec of what was identified |
//! | `recorded` | its channels over time |
//! | `calibrated` | inductance over length, beside the theories |
//! | `trial` | a simulated one, for those who have none at hand |
//!
//! Next door: how logs are read (`coilsense_lab::recording`), identified (`coilsense::identify`) and calibrated (`coilsense_lab::calibration`).

mod asked;
mod calibrated;
mod identified;
mod recorded;
mod trial;

pub use asked::Request;
pub use calibrated::calibrate;
pub use identified::identify;
pub use trial::trial;

use coilsense_lab::recording::columns_of_text;
use serde_json::json;

use crate::answer::Answer;

/// The text of a log, under its name.
pub type Named = (String, Vec<u8>);

/// Most points of a curve that is drawn.
const MOST: usize = 4000;

/// How a log is written, and its columns.
///
/// # Errors
/// One line, with the log's or an option's name.
pub fn columns(name: &str, text: Vec<u8>, asked: &Request) -> Result<Answer, String> {
    let format = asked.mapping()?.format;
    let (description, titles) = columns_of_text(name, text, &format).map_err(|error| asked.told(error))?;
    let titles = titles.iter().map(|title| json!({ "text": title.text, "name": title.name, "unit": title.unit }));
    Ok(Answer::new(&json!({ "description": description, "columns": titles.collect::<Vec<_>>() }), Vec::new()))
}

fn thinned(values: &[f64]) -> Vec<f64> {
    values.iter().step_by(values.len().div_ceil(MOST).max(1)).copied().collect()
}
