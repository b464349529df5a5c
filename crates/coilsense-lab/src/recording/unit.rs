//! Units as logs have them: those of `crate::quantity`, the same spelled out, and those of a sensor's own signal (volts, counts), which a gain takes to
//! a force or a length.
//!
//! Next door: columns' titles (`title`), which column is which (`selection`).

use super::quantity::LOGGED;
use crate::quantity::{Dimension, Scale};

/// Units as instruments and programs spell them out, in lower case, and their symbol.
const SPELLED: [(&[&str], &str); 17] = [
    (&["sec", "secs", "second", "seconds"], "s"),
    (&["msec", "millisecond", "milliseconds"], "ms"),
    (&["usec", "µsec", "microsecond", "microseconds"], "us"),
    (&["nsec", "nanosecond", "nanoseconds"], "ns"),
    (&["minute", "minutes", "mins"], "min"),
    (&["hour", "hours", "hr", "hrs"], "h"),
    (&["day", "days"], "d"),
    (&["newton", "newtons"], "N"),
    (&["kilonewton", "kilonewtons"], "kN"),
    (&["lbs", "pounds", "pound-force"], "lbf"),
    (&["kg-f", "kgf."], "kgf"),
    (&["g-f", "grams-force"], "gf"),
    (&["meter", "meters", "metre", "metres"], "m"),
    (&["millimeter", "millimeters", "millimetre", "millimetres"], "mm"),
    (&["micrometer", "micrometers", "micrometre", "micrometres", "micron", "microns"], "um"),
    (&["inches"], "inch"),
    (&["ohm", "ohms"], "Ohm"),
];

/// Units of sensors' own signals, in lower case but for what prefixes and symbols need, and of which they are how many times.
const SIGNALS: [(&str, Signal, f64); 16] = [
    ("V", Signal::Voltage, 1.0),
    ("volt", Signal::Voltage, 1.0),
    ("volts", Signal::Voltage, 1.0),
    ("mV", Signal::Voltage, 1e-3),
    ("uV", Signal::Voltage, 1e-6),
    ("µV", Signal::Voltage, 1e-6),
    ("A", Signal::Current, 1.0),
    ("ampere", Signal::Current, 1.0),
    ("mA", Signal::Current, 1e-3),
    ("mV/V", Signal::Ratio, 1e-3),
    ("V/V", Signal::Ratio, 1.0),
    ("counts", Signal::Counts, 1.0),
    ("count", Signal::Counts, 1.0),
    ("digits", Signal::Counts, 1.0),
    ("LSB", Signal::Counts, 1.0),
    ("raw", Signal::Counts, 1.0),
];

/// What a sensor's own signal is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Signal {
    Voltage,
    Current,
    Ratio,
    Counts,
}

/// What takes numbers of a unit to SI, by its symbol or spelled out; `None` where the unit is not of this dimension.
pub(super) fn scale(dimension: Dimension, unit: &str) -> Option<Scale> {
    dimension.scale(unit).or_else(|| {
        let lower = unit.to_lowercase();
        let (_, symbol) = SPELLED.iter().find(|(words, _)| words.contains(&lower.as_str()))?;
        dimension.scale(symbol)
    })
}

/// What a column may be of by its unit; `None` of a sensor's own signal, and of what is no unit.
pub(super) fn dimension(unit: &str) -> Option<Dimension> {
    LOGGED.into_iter().find(|dimension| scale(*dimension, unit).is_some())
}

/// Whether a text is a unit of a log.
pub(super) fn is_known(unit: &str) -> bool {
    dimension(unit).is_some() || is_signal(unit)
}

/// Whether a unit is spelled out, so that it may stand for a title.
pub(super) fn is_spelled(unit: &str) -> bool {
    let lower = unit.to_lowercase();
    SPELLED.iter().any(|(words, _)| words.contains(&lower.as_str())) || lower == "volt" || lower == "volts"
}

/// Whether a unit is that of a sensor's own signal.
pub(super) fn is_signal(unit: &str) -> bool {
    signal(unit).is_some()
}

fn signal(unit: &str) -> Option<(Signal, f64)> {
    // A prefix is not to be mistaken: mV is no MV.
    let found = SIGNALS.iter().find(|(symbol, ..)| *symbol == unit);
    let found =
        found.or_else(|| SIGNALS.iter().find(|(symbol, ..)| symbol.len() > 3 && symbol.eq_ignore_ascii_case(unit)));
    found.map(|(_, signal, factor)| (*signal, *factor))
}

/// What a sensor's signal means: so many SI units for one of its units, or for one of the column's numbers.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Gain {
    /// As it was written.
    pub text: String,
    si: f64,
    per: Option<String>,
}

impl Gain {
    /// Reads `12.5 N/V`, or `12.5 N` for one of the column's numbers.
    pub fn parse(dimension: Dimension, text: &str) -> Option<Self> {
        let own = |text: &str| dimension.parse(text).filter(|value| value.is_finite() && *value != 0.0);
        let plain = own(text).map(|si| Self { text: text.to_owned(), si, per: None });
        plain.or_else(|| {
            let (value, per) = text.match_indices('/').find_map(|(place, _)| {
                let (value, per) = (&text[..place], text[place + 1..].trim());
                signal(per).is_some().then_some((value, per))
            })?;
            Some(Self { text: text.to_owned(), si: own(value.trim())?, per: Some(per.to_owned()) })
        })
    }

    /// SI units for one of the numbers of a column of this unit, where it has one.
    ///
    /// # Errors
    /// What is wrong where the gain is for another kind of signal.
    pub fn of_unit(&self, unit: Option<&str>) -> Result<f64, String> {
        let Some(per) = &self.per else { return Ok(self.si) };
        let Some(unit) = unit else { return Ok(self.si) };
        match (signal(unit), signal(per)) {
            (Some((one, factor)), Some((other, per))) if one == other => Ok(self.si * (factor / per)),
            _ => Err(format!("its unit is {unit}, the gain is for one {per}")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Gain, dimension, is_known, scale};
    use crate::quantity::{Dimension, Scale};

    #[test]
    fn units_are_known_by_symbol_and_spelled_out() {
        assert_eq!(scale(Dimension::Time, "Second"), Some(Scale::Times(1.0)));
        assert_eq!(scale(Dimension::Time, "msec"), scale(Dimension::Time, "ms"));
        assert_eq!(scale(Dimension::Force, "Newtons"), Some(Scale::Times(1.0)));
        assert_eq!(scale(Dimension::Time, "days"), Some(Scale::Times(86_400.0)));
        for (unit, found) in
            [("kgf", Some(Dimension::Force)), ("mil", Some(Dimension::Length)), ("V", None), ("g", None), ("", None)]
        {
            assert_eq!(dimension(unit), found, "{unit}");
        }
        // A gram is no force, and a megavolt no millivolt.
        assert!(is_known("mV") && is_known("Volts") && !is_known("MV") && !is_known("g") && !is_known("left"));
    }

    #[test]
    fn a_gain_is_for_a_unit_of_its_kind() {
        let gain = |text: &str| Gain::parse(Dimension::Force, text);
        assert_eq!(gain("12.5 N/V").unwrap().of_unit(Some("mV")), Ok(12.5 * 1e-3));
        assert_eq!(gain("2 mN/mV").unwrap().of_unit(Some("V")), Ok(2e-3 * (1.0 / 1e-3)));
        assert_eq!(gain("12.5 N").unwrap().of_unit(Some("mV")), Ok(12.5));
        assert_eq!(gain("0.1 N/count").unwrap().of_unit(None), Ok(0.1));
        assert_eq!(gain("500 N/mV/V").unwrap().of_unit(Some("mV/V")), Ok(500.0));
        assert!(gain("12.5 N/V").unwrap().of_unit(Some("counts")).unwrap_err().contains("for one V"));
        assert!(gain("12.5 N/V").unwrap().of_unit(Some("N")).is_err());
        for text in ["12.5", "12.5 mm/V", "0 N/V", "12.5 N/", "12.5 N/s", "N/V", "nan N/V"] {
            assert_eq!(gain(text), None, "{text}");
        }
    }
}
