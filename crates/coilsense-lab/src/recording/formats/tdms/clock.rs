//! When a channel's values were taken: an even clock of the channel's own, or another channel's values.
//!
//! Next door: which channels there are (`columns`), properties (`properties`).

use super::super::super::error::shortened;
use super::kind::SECOND;
use super::properties::Properties;

/// An even clock, as LabVIEW's waveforms have it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wave {
    pub increment: f64,
    pub offset: f64,
    /// When its zero is, in fractions of 2^-64 s since 1904.
    pub start: Option<i128>,
}

impl Wave {
    /// The clock that a channel's properties tell; `Err` of a channel over something else than time.
    pub fn of(properties: &Properties) -> Result<Option<Self>, String> {
        let Some(increment) = properties.number("wf_increment").filter(|step| *step > 0.0 && step.is_finite()) else {
            return Ok(None);
        };
        let over = properties.text("wf_xunit_string").map_or("", str::trim);
        if !matches!(over.to_lowercase().as_str(), "" | "s" | "sec" | "second" | "seconds") {
            return Err(format!("over {}, not over time", shortened(over)));
        }
        let offset = properties.number("wf_start_offset").filter(|offset| offset.is_finite()).unwrap_or(0.0);
        // Zero is 1904, which LabVIEW writes where it was not told.
        let start = properties.stamp("wf_start_time").filter(|start| *start != 0);
        Ok(Some(Self { increment, offset, start }))
    }

    /// Its times \[s\]: by a whole rate where the increment is one's reciprocal, so that clocks of 2500 and 250 Hz meet to the last bit.
    pub fn times(&self, count: usize) -> Vec<f64> {
        let rate = (1.0 / self.increment).round();
        let whole = rate >= 1.0 && (rate * self.increment - 1.0).abs() < 1e-12;
        let after = |row: f64| if whole { row / rate } else { row * self.increment };
        (0..count).map(|row| self.offset + after(row as f64)).collect()
    }
}

/// Seconds from one instant to a later one.
pub(super) fn seconds(from: i128, to: i128) -> f64 {
    to.wrapping_sub(from) as f64 / SECOND
}
