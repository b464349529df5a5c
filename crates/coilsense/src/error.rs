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
pub(crate) fn above_zero(quantity: &'static str, value: f64, unit: &'static str) -> Result<f64, Error> {
    check(value.is_finite() && value > 0.0, quantity, value, unit, "above zero and finite")?;
    // The text is made only where it is needed: this is asked at every step of a stream.
    if (1.0 / LARGEST..=LARGEST).contains(&value) {
        return Ok(value);
    }
    check(false, quantity, value, unit, format!("from {:e} to {LARGEST:e} {unit}", 1.0 / LARGEST).trim_end().to_owned())
}

/// Lets through a finite value.
pub(crate) fn finite(quantity: &'static str, value: f64, unit: &'static str) -> Result<f64, Error> {
    check(value.is_finite(), quantity, value, unit, "finite")?;
    if value.abs() <= LARGEST {
        return Ok(value);
    }
    check(false, quantity, value, unit, format!("at most {LARGEST:e} either way"))
}

/// Lets `value` through where `holds`, else says what is `allowed`.
pub(crate) fn check(
    holds: bool,
    quantity: impl Into<Cow<'static, str>>,
    value: f64,
    unit: &'static str,
    allowed: impl Into<Cow<'static, str>>,
) -> Result<f64, Error> {
    if holds {
        return Ok(value);
    }
    Err(Error::Value { quantity: quantity.into(), value, unit, allowed: allowed.into() })
}

/// Whether all values pass a test, looked at in chunks without leaving early: so the compiler takes several at once.
fn every(values: &[f64], test: impl Fn(f64) -> bool) -> bool {
    values.chunks(256).all(|chunk| chunk.iter().fold(true, |so_far, value| so_far & test(*value)))
}

/// Lets through a series of finite values; the error names the first that is not, by its index from zero.
pub(crate) fn all_finite(quantity: &'static str, values: &[f64], unit: &'static str) -> Result<(), Error> {
    if every(values, |value| value.is_finite()) {
        return Ok(());
    }
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => Err(Error::Value {
            quantity: format!("{quantity}[{index}]").into(),
            value: values[index],
            unit,
            allowed: "finite".into(),
        }),
    }
}

/// Lets through a series of values of a size that springs have; the error names the first that is not, by its index from zero.
pub(crate) fn all_bounded(quantity: &'static str, values: &[f64], unit: &'static str) -> Result<(), Error> {
    if every(values, |value| value.abs() <= LARGEST) {
        return Ok(());
    }
    all_finite(quantity, values, unit)?;
    match values.iter().position(|value| value.abs() > LARGEST) {
        None => Ok(()),
        Some(index) => {
            let allowed = format!("at most {LARGEST:e} either way");
            check(false, format!("{quantity}[{index}]"), values[index], unit, allowed).map(|_| ())
        }
    }
}

/// Lets through a finite value that is zero or above.
pub(crate) fn not_negative(quantity: &'static str, value: f64, unit: &'static str) -> Result<f64, Error> {
    check(value.is_finite() && value >= 0.0, quantity, value, unit, "finite and not below zero")
}

/// Lets through a series that is not empty.
pub(crate) fn at_least_one(quantity: &'static str, found: usize) -> Result<(), Error> {
    if found > 0 {
        return Ok(());
    }
    Err(Error::Count { quantity: quantity.into(), found, allowed: "at least 1".into() })
}

/// Lets through a series of exactly `expected` values.
pub(crate) fn count(quantity: &'static str, found: usize, expected: usize) -> Result<(), Error> {
    if found == expected {
        return Ok(());
    }
    Err(Error::Count { quantity: quantity.into(), found, allowed: expected.to_string().into() })
}
