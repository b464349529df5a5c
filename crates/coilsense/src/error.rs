//! What can be wrong with what a user sends: one error type for the whole science.
//!
//! Next door: `coilsense-lab` adds the file, the line and the key.

use std::borrow::Cow;

/// An input that the science cannot take. Each text names the quantity, the value, the unit and what is allowed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A value outside of what its quantity allows.
    #[error("{quantity} must be {allowed}, got {}", number(*.value, .unit))]
    Value {
        /// The parameter as the public struct or function calls it (`coil_radius`); `None` of what is no parameter.
        field: Option<&'static str>,
        /// The quantity in words, an index in brackets where it is one of a series.
        quantity: Cow<'static, str>,
        /// The value that was sent.
        value: f64,
        /// Its SI unit, empty for a pure number.
        unit: &'static str,
        /// What is allowed, in words.
        allowed: Cow<'static, str>,
    },
    /// A series of the wrong length.
    #[error("{quantity} must hold {allowed} values, got {found}")]
    Count {
        /// The parameter as the public struct or function calls it; `None` of what is no parameter.
        field: Option<&'static str>,
        /// The quantity in words.
        quantity: Cow<'static, str>,
        /// How many values it holds.
        found: usize,
        /// How many are allowed, in words.
        allowed: Cow<'static, str>,
    },
    /// Vector instructions that are unknown or not here.
    #[error("COILSENSE_SIMD must be one of {allowed} on this processor, got {wanted}")]
    Simd {
        /// What the variable says.
        wanted: String,
        /// What it may say here.
        allowed: String,
    },
    /// A signal that is not there.
    #[error("signal {0} is missing")]
    MissingSignal(&'static str),
}

impl Error {
    /// The parameter that it is about, as the public struct or function calls it; `None` where it is about no single one.
    pub fn field(&self) -> Option<&'static str> {
        match self {
            Self::Value { field, .. } | Self::Count { field, .. } => *field,
            Self::Simd { .. } | Self::MissingSignal(_) => None,
        }
    }
}

/// What an error is about: a parameter's name, whose words are its own (`coil_radius`); words with a blank in them, where it is no
/// parameter; or both, see [`called`].
#[derive(Debug, Clone)]
pub(crate) struct Subject {
    field: Option<&'static str>,
    words: Cow<'static, str>,
}

impl From<&'static str> for Subject {
    fn from(name: &'static str) -> Self {
        let words = if name.contains('_') { name.replace('_', " ").into() } else { name.into() };
        Self { field: (!name.contains(' ')).then_some(name), words }
    }
}

impl From<String> for Subject {
    fn from(words: String) -> Self {
        Self { field: None, words: words.into() }
    }
}

/// One of a series, by its index from zero.
pub(crate) fn entry(quantity: impl Into<Subject>, index: usize) -> Subject {
    let Subject { field, words } = quantity.into();
    Subject { field, words: format!("{words}[{index}]").into() }
}

/// A parameter that people call otherwise.
pub(crate) fn called(field: &'static str, words: &'static str) -> Subject {
    Subject { field: Some(field), words: words.into() }
}

/// Above this a number is written with an exponent.
const LONGEST: f64 = 1e15;

/// `value unit`, without a trailing blank where there is no unit.
fn number(value: f64, unit: &str) -> String {
    let value = if value.is_finite() && value.abs() > LONGEST { format!("{value:e}") } else { format!("{value}") };
    if unit.is_empty() { value } else { format!("{value} {unit}") }
}

/// What a spring, a drive or a time can be in SI units: far beyond every spring, and far from where squares overflow.
const LARGEST: f64 = 1e9;

/// Lets through a value above zero, of a size that springs have.
pub(crate) fn above_zero(quantity: impl Into<Subject> + Clone, value: f64, unit: &'static str) -> Result<f64, Error> {
    check(value.is_finite() && value > 0.0, quantity.clone(), value, unit, "above zero and finite")?;
    // The text is made only where it is needed: this is asked at every step of a stream.
    if (1.0 / LARGEST..=LARGEST).contains(&value) {
        return Ok(value);
    }
    check(false, quantity, value, unit, format!("from {:e} to {LARGEST:e} {unit}", 1.0 / LARGEST).trim_end().to_owned())
}

/// Lets through a finite value.
pub(crate) fn finite(quantity: impl Into<Subject> + Clone, value: f64, unit: &'static str) -> Result<f64, Error> {
    check(value.is_finite(), quantity.clone(), value, unit, "finite")?;
    if value.abs() <= LARGEST {
        return Ok(value);
    }
    check(false, quantity, value, unit, format!("at most {LARGEST:e} either way"))
}

/// Lets `value` through where `holds`, else says what is `allowed`.
pub(crate) fn check(
    holds: bool,
    quantity: impl Into<Subject>,
    value: f64,
    unit: &'static str,
    allowed: impl Into<Cow<'static, str>>,
) -> Result<f64, Error> {
    if holds {
        return Ok(value);
    }
    let Subject { field, words } = quantity.into();
    Err(Error::Value { field, quantity: words, value, unit, allowed: allowed.into() })
}

/// Whether all values pass a test, looked at in chunks without leaving early: so the compiler takes several at once.
fn every(values: &[f64], test: impl Fn(f64) -> bool) -> bool {
    values.chunks(256).all(|chunk| chunk.iter().fold(true, |so_far, value| so_far & test(*value)))
}

/// Lets through a series of finite values; the error names the first that is not, by its index from zero.
pub(crate) fn all_finite(quantity: impl Into<Subject>, values: &[f64], unit: &'static str) -> Result<(), Error> {
    if every(values, |value| value.is_finite()) {
        return Ok(());
    }
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => check(false, entry(quantity, index), values[index], unit, "finite").map(|_| ()),
    }
}

/// Lets through a series of values of a size that springs have; the error names the first that is not, by its index from zero.
pub(crate) fn all_bounded(
    quantity: impl Into<Subject> + Clone,
    values: &[f64],
    unit: &'static str,
) -> Result<(), Error> {
    if every(values, |value| value.abs() <= LARGEST) {
        return Ok(());
    }
    all_finite(quantity.clone(), values, unit)?;
    match values.iter().position(|value| value.abs() > LARGEST) {
        None => Ok(()),
        Some(index) => {
            let allowed = format!("at most {LARGEST:e} either way");
            check(false, entry(quantity, index), values[index], unit, allowed).map(|_| ())
        }
    }
}

/// Lets through a finite value that is zero or above.
pub(crate) fn not_negative(quantity: impl Into<Subject>, value: f64, unit: &'static str) -> Result<f64, Error> {
    check(value.is_finite() && value >= 0.0, quantity, value, unit, "finite and not below zero")
}

/// Lets through a value that is zero or above, of a size that springs have.
pub(crate) fn from_zero(quantity: impl Into<Subject> + Clone, value: f64, unit: &'static str) -> Result<f64, Error> {
    finite(quantity.clone(), not_negative(quantity, value, unit)?, unit)
}

/// Lets through a series that is not empty.
pub(crate) fn at_least_one(quantity: impl Into<Subject>, found: usize) -> Result<(), Error> {
    if found > 0 { Ok(()) } else { Err(number_of(quantity, found, "at least 1")) }
}

/// Lets through a series of exactly `expected` values.
pub(crate) fn count(quantity: impl Into<Subject>, found: usize, expected: usize) -> Result<(), Error> {
    if found == expected { Ok(()) } else { Err(number_of(quantity, found, expected.to_string())) }
}

/// That a series holds so many values, and how many are allowed.
pub(crate) fn number_of(quantity: impl Into<Subject>, found: usize, allowed: impl Into<Cow<'static, str>>) -> Error {
    let Subject { field, words } = quantity.into();
    Error::Count { field, quantity: words, found, allowed: allowed.into() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_names_its_parameter_and_says_it_in_words() {
        let refused = |subject: Subject| check(false, subject, 0.0, "", "above zero").unwrap_err();
        for (subject, field, words) in [
            ("coil_radius".into(), Some("coil_radius"), "coil radius"),
            (called("from", "first frequency"), Some("from"), "first frequency"),
            (entry("times", 3), Some("times"), "times[3]"),
            // What follows from several parameters is none of them.
            ("combined uncertainty".into(), None, "combined uncertainty"),
            (format!("damping ratio of mode {}", 2).into(), None, "damping ratio of mode 2"),
        ] {
            let error = refused(subject);
            assert_eq!(error.field(), field);
            assert_eq!(error.to_string(), format!("{words} must be above zero, got 0"));
        }
        assert_eq!(count("end_shapes", 1, 2).unwrap_err().field(), Some("end_shapes"));
        assert_eq!(Error::MissingSignal("u1").field(), None);
    }
}
