//! A quantity from Python: a number in SI, or a text with its unit as a spec has it.
//!
//! Next door: series of numbers (`series`).

use coilsense_lab::quantity::Dimension;
use pyo3::prelude::*;

use crate::errors::Error;

/// A number in SI, or a text such as "2.5 kHz".
#[derive(FromPyObject)]
pub enum Quantity {
    /// In SI.
    Number(f64),
    /// With its unit.
    Text(String),
}

impl Quantity {
    /// Its value in SI, any finite one; `name` is the argument's.
    pub fn finite(&self, name: &str, dimension: Dimension) -> PyResult<f64> {
        let wrong =
            |what: &str, got: &dyn std::fmt::Display| Error::new_err(format!("{name} must be {what}, got {got}"));
        let value = match self {
            Self::Number(value) => *value,
            Self::Text(text) => dimension.parse(text).ok_or_else(|| {
                wrong(
                    &format!("a number in {} or {}", dimension.si_unit(), dimension.expectation()),
                    &format!("{text:?}"),
                )
            })?,
        };
        if value.is_finite() { Ok(value) } else { Err(wrong("finite", &value)) }
    }

    /// Its value in SI, above zero.
    pub fn positive(&self, name: &str, dimension: Dimension) -> PyResult<f64> {
        let value = self.finite(name, dimension)?;
        let unit = dimension.si_unit();
        if value > 0.0 {
            Ok(value)
        } else {
            Err(Error::new_err(format!("{name} must be above zero, got {value} {unit}")))
        }
    }
}

/// The value of an argument that may be left out, above zero.
pub fn positive(argument: Option<&Quantity>, name: &str, dimension: Dimension) -> PyResult<Option<f64>> {
    argument.map(|quantity| quantity.positive(name, dimension)).transpose()
}

/// The value of an argument that may be left out.
pub fn finite(argument: Option<&Quantity>, name: &str, dimension: Dimension) -> PyResult<Option<f64>> {
    argument.map(|quantity| quantity.finite(name, dimension)).transpose()
}

/// A rate that instruments have \[Hz\], where it is given.
pub fn rate(argument: Option<&Quantity>, name: &str) -> PyResult<Option<f64>> {
    let rate = finite(argument, name, Dimension::Frequency)?;
    match rate.filter(|rate| !(1e-9..=1e9).contains(rate)) {
        Some(rate) => Err(Error::new_err(format!("{name} must be from 1e-9 to 1e9 Hz, got {rate} Hz"))),
        None => Ok(rate),
    }
}

/// A share, from zero to below 1.
pub fn share(value: f64, name: &str) -> PyResult<f64> {
    if (0.0..1.0).contains(&value) {
        return Ok(value);
    }
    Err(Error::new_err(format!("{name} must be from 0 to below 1, got {value}")))
}

/// A share above zero and below 1.
pub fn open_share(value: f64, name: &str) -> PyResult<f64> {
    if value > 0.0 && value < 1.0 {
        Ok(value)
    } else {
        Err(Error::new_err(format!("{name} must be above 0 and below 1, got {value}")))
    }
}
