//! Signals as CSV: the one writer of series.
//!
//! Next door: the names and units of channels (`coilsense::Channel`).

use std::fmt::Write;

use coilsense::{Channel, Signals};

/// Time and the paper's four forces, those of them that are there: header `time [s],F_i [N],…`, one row per sample, every number
/// with the digits that bring back the same double.
pub fn signals_csv(signals: &Signals) -> String {
    let columns: Vec<(Channel, &[f64])> =
        signals.channels().filter(|(channel, _)| Channel::FORCES.contains(channel)).collect();
    let mut text = String::with_capacity(signals.time().len() * 20 * (columns.len() + 1));
    text.push_str("time [s]");
    for (channel, _) in &columns {
        // Writing to a String cannot fail.
        let _ = write!(text, ",{} [{}]", channel.name(), channel.unit());
    }
    text.push('\n');
    for (sample, time) in signals.time().iter().enumerate() {
        let _ = write!(text, "{time}");
        for (_, values) in &columns {
            let _ = write!(text, ",{}", values[sample]);
        }
        text.push('\n');
    }
    text
}
