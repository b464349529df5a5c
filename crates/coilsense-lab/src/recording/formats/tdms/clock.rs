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

#[cfg(test)]
mod tests {
    use super::Wave;
    use crate::recording::formats::tdms::properties::{Properties, Value};

    fn wave(more: &[(&str, Value)]) -> Result<Option<Wave>, String> {
        let increment = [("wf_increment", Value::Number(0.0004)), ("wf_start_offset", Value::Number(0.5))];
        Wave::of(&Properties::of(&[&increment[..], more].concat()))
    }

    #[test]
    fn only_what_is_over_time_has_an_even_clock() {
        let times = wave(&[]).unwrap().unwrap().times(3);
        assert_eq!(times, [0.5, 0.5004, 0.5008]);
        let over = |unit: &str| wave(&[("wf_xunit_string", Value::Text(unit.to_owned()))]);
        assert_eq!(over("s").unwrap(), wave(&[]).unwrap());
        assert_eq!(over("Hz").unwrap_err(), "over Hz, not over time");
        for step in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(wave(&[("wf_increment", Value::Number(step))]), Ok(None), "{step}");
        }
        assert_eq!(Wave::of(&Properties::default()), Ok(None));
        // 1904 is what LabVIEW writes where nobody told a start.
        assert_eq!(wave(&[("wf_start_time", Value::Stamp(0))]).unwrap().unwrap().start, None);
    }

    #[test]
    fn clocks_of_whole_rates_meet_to_the_last_bit() {
        let of = |increment: f64| Wave { increment, offset: 0.0, start: None };
        let (fast, slow) = (of(0.0004).times(1001), of(0.004).times(101));
        assert!(slow.iter().zip(fast.iter().step_by(10)).all(|(slow, fast)| slow == fast));
        assert_eq!(of(0.3).times(4)[3], 3.0 * 0.3);
    }
}
