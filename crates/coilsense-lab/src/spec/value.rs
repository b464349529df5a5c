//! Values of a table by their type: quantities, numbers, texts, words; what is mistyped is said with its line.
//!
//! Next door: the table and its errors (`section`), units (`crate::quantity`).

use toml::de::DeValue;

use super::SpecError;
use super::section::Section;
use crate::quantity::Dimension;

impl Section<'_> {
    /// A quantity with its unit, in SI.
    pub(super) fn quantity(&self, key: &str, dimension: Dimension) -> Result<f64, SpecError> {
        self.optional_quantity(key, dimension)?.ok_or_else(|| self.missing(key, &dimension.expectation()))
    }

    /// A quantity with its unit, in SI, where it is given.
    pub(super) fn optional_quantity(&self, key: &str, dimension: Dimension) -> Result<Option<f64>, SpecError> {
        let parse = |value: &DeValue| value.as_str().and_then(|text| dimension.parse(text));
        self.read(key, parse, || dimension.expectation())
    }

    /// A quantity of one of several dimensions.
    pub(super) fn any_quantity(&self, key: &str, allowed: &[Dimension]) -> Result<(Dimension, f64), SpecError> {
        self.optional_any_quantity(key, allowed)?.ok_or_else(|| self.missing(key, &any(allowed)))
    }

    /// A quantity of one of several dimensions, where it is given.
    pub(super) fn optional_any_quantity(
        &self,
        key: &str,
        allowed: &[Dimension],
    ) -> Result<Option<(Dimension, f64)>, SpecError> {
        self.read(key, |value| one_of(value, allowed), || any(allowed))
    }

    /// Two quantities in a list, which must be there.
    pub(super) fn pair(&self, key: &str, allowed: &[Dimension]) -> Result<[(Dimension, f64); 2], SpecError> {
        self.optional_pair(key, allowed)?.ok_or_else(|| self.missing(key, &pair_of(allowed)))
    }

    /// Two quantities in a list, where it is given.
    pub(super) fn optional_pair(
        &self,
        key: &str,
        allowed: &[Dimension],
    ) -> Result<Option<[(Dimension, f64); 2]>, SpecError> {
        let parse = |value: &DeValue| {
            let mut each = value.as_array()?.iter();
            let (Some(first), Some(second), None) = (each.next(), each.next(), each.next()) else { return None };
            Some([one_of(first.get_ref(), allowed)?, one_of(second.get_ref(), allowed)?])
        };
        self.read(key, parse, || pair_of(allowed))
    }

    /// A pure number.
    pub(super) fn number(&self, key: &str) -> Result<f64, SpecError> {
        self.optional_number(key)?.ok_or_else(|| self.missing(key, NUMBER))
    }

    /// A pure number, where it is given.
    pub(super) fn optional_number(&self, key: &str) -> Result<Option<f64>, SpecError> {
        self.read(key, number, || NUMBER.to_owned())
    }

    /// A whole number in a range, where it is given.
    pub(super) fn optional_whole(&self, key: &str, from: u64, to: u64) -> Result<Option<u64>, SpecError> {
        let parse = |value: &DeValue| match value {
            DeValue::Integer(integer) => u64::from_str_radix(integer.as_str(), integer.radix()).ok(),
            _ => None,
        };
        let within = |value: &DeValue| parse(value).filter(|number| (from..=to).contains(number));
        self.read(key, within, || format!("a whole number from {from} to {to}"))
    }

    /// One number or a list of them, where it is given.
    pub(super) fn optional_numbers(&self, key: &str) -> Result<Option<Vec<f64>>, SpecError> {
        let parse = |value: &DeValue| match value.as_array() {
            Some(each) if !each.is_empty() => each.iter().map(|item| number(item.get_ref())).collect(),
            Some(_) => None,
            None => number(value).map(|one| vec![one]),
        };
        self.read(key, parse, || "a number without a unit, or a list of them".to_owned())
    }

    /// `true` or `false`, where it is given.
    pub(super) fn optional_flag(&self, key: &str) -> Result<Option<bool>, SpecError> {
        self.read(key, |value| value.as_bool(), || "true or false".to_owned())
    }

    /// A text that is not empty.
    pub(super) fn text(&self, key: &str) -> Result<String, SpecError> {
        self.optional_text(key)?.ok_or_else(|| self.missing(key, TEXT))
    }

    /// A text that is not empty, on one line and of a name's length, where it is given.
    pub(super) fn optional_text(&self, key: &str) -> Result<Option<String>, SpecError> {
        let fits = |text: &&str| {
            let count = text.chars().count();
            !text.trim().is_empty() && count <= MOST_CHARACTERS && !text.chars().any(char::is_control)
        };
        self.read(key, |value| value.as_str().filter(fits).map(str::to_owned), || TEXT.to_owned())
    }

    /// One of a few words, where it is given.
    pub(super) fn optional_word<'w>(&self, key: &str, words: &[&'w str]) -> Result<Option<&'w str>, SpecError> {
        let parse = |value: &DeValue| value.as_str().and_then(|text| words.iter().copied().find(|word| *word == text));
        self.read(key, parse, || list_of(words))
    }

    /// One of a few words.
    pub(super) fn word<'w>(&self, key: &str, words: &[&'w str]) -> Result<&'w str, SpecError> {
        self.optional_word(key, words)?.ok_or_else(|| self.missing(key, &list_of(words)))
    }

    /// Lets `value` through where it `holds`; else says what must be.
    pub(super) fn check(&self, key: &str, holds: bool, value: f64, allowed: &str) -> Result<f64, SpecError> {
        if holds { Ok(value) } else { Err(self.refuse(key, format!("must be {allowed}"))) }
    }

    /// A quantity that must be there, as [`Self::above_zero`] takes it.
    pub(super) fn positive(&self, key: &str, dimension: Dimension) -> Result<f64, SpecError> {
        self.above_zero(key, dimension)?.ok_or_else(|| self.missing(key, &dimension.expectation()))
    }

    /// A quantity above zero, of a size that springs have.
    pub(super) fn above_zero(&self, key: &str, dimension: Dimension) -> Result<Option<f64>, SpecError> {
        let Some(value) = self.optional_quantity(key, dimension)? else { return Ok(None) };
        self.check(key, value.is_finite() && value > 0.0, value, "above zero and finite")?;
        let least = if dimension == Dimension::Inductance { LEAST_INDUCTANCE } else { 1.0 / LARGEST };
        let allowed = format!("from {least:e} to {LARGEST:e} {}", dimension.si_unit());
        self.check(key, (least..=LARGEST).contains(&value), value, &allowed).map(Some)
    }

    /// A share from none to all.
    pub(super) fn share(&self, key: &str) -> Result<Option<f64>, SpecError> {
        let Some(value) = self.optional_quantity(key, Dimension::Share)? else { return Ok(None) };
        self.check(key, (0.0..=1.0).contains(&value), value, "from 0 to 100 %").map(Some)
    }

    /// A quantity not below zero, of a size that springs have.
    pub(super) fn not_negative(&self, key: &str, dimension: Dimension) -> Result<Option<f64>, SpecError> {
        let Some(value) = self.optional_quantity(key, dimension)? else { return Ok(None) };
        let allowed = format!("from 0 to {LARGEST:e} {}", dimension.si_unit());
        self.check(key, (0.0..=LARGEST).contains(&value), value, &allowed).map(Some)
    }
}

const NUMBER: &str = "a number without a unit";
const TEXT: &str = "a text in quotes, on one line, of 1 to 200 characters";
/// As [`TEXT`] says.
const MOST_CHARACTERS: usize = 200;

/// What a quantity of a spring can be in SI units, as the science takes it; inductances of small coils lie below its lower bound.
const LARGEST: f64 = 1e9;
const LEAST_INDUCTANCE: f64 = 1e-15;

fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Integer(integer) => {
            i64::from_str_radix(integer.as_str(), integer.radix()).ok().map(|number| number as f64)
        }
        DeValue::Float(float) => float.as_str().parse().ok(),
        _ => None,
    }
}

fn one_of(value: &DeValue<'_>, allowed: &[Dimension]) -> Option<(Dimension, f64)> {
    let text = value.as_str()?;
    allowed.iter().find_map(|&dimension| Some((dimension, dimension.parse(text)?)))
}

fn any(allowed: &[Dimension]) -> String {
    let each: Vec<String> = allowed.iter().map(|dimension| dimension.expectation()).collect();
    each.join(", or ")
}

fn pair_of(allowed: &[Dimension]) -> String {
    format!("a list of two: [\"…\", \"…\"], each {}", any(allowed))
}

fn list_of(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
    format!("one of {}", quoted.join(", "))
}
