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
mod file;
mod identified;
mod recorded;
mod trial;

pub use asked::Request;
pub use calibrated::calibrate;
pub use file::LogFile;
pub use identified::identify;
pub use trial::trial;

use coilsense_lab::recording::{FirstLook, Meant};
use serde_json::json;

use crate::answer::Answer;

/// Most points of a curve that is drawn.
const MOST: usize = 4000;

/// How a log is written, its columns and what each of them is, and what stands above its rows.
///
/// # Errors
/// One line, with the log's or an option's name.
pub fn columns(log: LogFile, asked: &Request) -> Result<Answer, String> {
    let format = asked.mapping()?.format;
    let look = FirstLook::of(log.handed(), &format).map_err(|error| asked.told(error))?;
    let columns = look.titles.iter().zip(&look.meant).map(|(title, meant)| {
        let channel = meant.map(|meant| meant.quantity.name());
        let guessed = matches!(meant, Some(Meant { guessed: true, .. }));
        json!({ "text": title.text, "name": title.name, "unit": title.unit, "channel": channel, "guessed": guessed })
    });
    let facts = json!({
        "description": look.description,
        "columns": columns.collect::<Vec<_>>(),
        "preset": look.preset,
        "remarks": look.remarks,
    });
    Ok(Answer::new(&facts, Vec::new()))
}

fn thinned(values: &[f64]) -> Vec<f64> {
    values.iter().step_by(values.len().div_ceil(MOST).max(1)).copied().collect()
}
