//! One table of a spec, read key by key: what is missing, mistyped or unknown is said with its line.
//!
//! Next door: what the keys mean (`spring`).

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{SpecError, located};
use crate::quantity::Dimension;

/// A table `[name]` of a spec file.
pub(super) struct Section<'a> {
    file: &'a str,
    text: &'a str,
    name: &'static str,
    table: &'a DeTable<'a>,
    span: Range<usize>,
}

/// A spec file, parsed as TOML.
pub(super) struct Document<'a> {
    file: &'a str,
    text: &'a str,
    table: Spanned<DeTable<'a>>,
}

impl<'a> Document<'a> {
    pub(super) fn parse(file: &'a str, text: &'a str) -> Result<Self, SpecError> {
        let table = DeTable::parse(text).map_err(|error| {
            let offset = error.span().map_or(0, |span| span.start);
            located(file, text, offset, format!("not TOML: {}", error.message()))
        })?;
        Ok(Self { file, text, table })
    }

    /// The table `[name]`, which must be there; `known` are all tables that may.
    pub(super) fn section(&self, name: &'static str, known: &[&str]) -> Result<Section<'_>, SpecError> {
        let table = self.table.get_ref();
        reject_unknown(self.file, self.text, table, known, "")?;
        let Some(value) = table.get(name) else {
            return Err(SpecError(format!("{}: the table [{name}] is missing", self.file)));
        };
        let Some(inner) = value.get_ref().as_table() else {
            let message = format!("{name} must be a table [{name}]");
            return Err(located(self.file, self.text, value.span().start, message));
        };
        Ok(Section { file: self.file, text: self.text, name, table: inner, span: value.span() })
    }
}

impl Section<'_> {
    /// Rejects keys that are not among `known`, naming the nearest.
    pub(super) fn allow(&self, known: &[&str]) -> Result<(), SpecError> {
        reject_unknown(self.file, self.text, self.table, known, &format!(" in [{}]", self.name))
    }

    /// A quantity with its unit, in SI.
    pub(super) fn quantity(&self, key: &str, dimension: Dimension) -> Result<f64, SpecError> {
        self.optional_quantity(key, dimension)?.ok_or_else(|| self.missing(key, &dimension.expectation()))
    }

    /// A quantity with its unit, in SI, where it is given.
    pub(super) fn optional_quantity(&self, key: &str, dimension: Dimension) -> Result<Option<f64>, SpecError> {
        let parse = |value: &DeValue| value.as_str().and_then(|text| dimension.parse(text));
        self.read(key, parse, || dimension.expectation())
    }

    /// A pure number.
    pub(super) fn number(&self, key: &str) -> Result<f64, SpecError> {
        self.optional_number(key)?.ok_or_else(|| self.missing(key, NUMBER))
    }

    /// A pure number, where it is given.
    pub(super) fn optional_number(&self, key: &str) -> Result<Option<f64>, SpecError> {
        let parse = |value: &DeValue| match value {
            DeValue::Integer(integer) => {
                i64::from_str_radix(integer.as_str(), integer.radix()).ok().map(|number| number as f64)
            }
            DeValue::Float(float) => float.as_str().parse().ok(),
            _ => None,
        };
        self.read(key, parse, || NUMBER.to_owned())
    }

    /// A text that is not empty.
    pub(super) fn text(&self, key: &str) -> Result<String, SpecError> {
        let parse = |value: &DeValue| value.as_str().filter(|text| !text.trim().is_empty()).map(str::to_owned);
        self.read(key, parse, || TEXT.to_owned())?.ok_or_else(|| self.missing(key, TEXT))
    }

    /// An error of the science about the value of `key`.
    pub(super) fn refuse(&self, key: &str, error: impl std::fmt::Display) -> SpecError {
        match self.table.get(key) {
            Some(value) => self.at(value, format!("{key} = {}: {error}", self.source(value))),
            None => located(self.file, self.text, self.span.start, error),
        }
    }

    fn read<T>(
        &self,
        key: &str,
        parse: impl Fn(&DeValue) -> Option<T>,
        expectation: impl Fn() -> String,
    ) -> Result<Option<T>, SpecError> {
        let Some(value) = self.table.get(key) else {
            return Ok(None);
        };
        let parsed = parse(value.get_ref());
        let message = || format!("{key} = {}: must be {}", self.source(value), expectation());
        parsed.map(Some).ok_or_else(|| self.at(value, message()))
    }

    /// The value as the file writes it, the first line of it.
    fn source(&self, value: &Spanned<DeValue<'_>>) -> String {
        let source = self.text.get(value.span()).unwrap_or_default();
        match source.split_once('\n') {
            Some((first, _)) => format!("{} …", first.trim_end()),
            None => source.to_owned(),
        }
    }

    fn missing(&self, key: &str, expectation: &str) -> SpecError {
        let message = format!("[{}] lacks the key \"{key}\": {expectation}", self.name);
        located(self.file, self.text, self.span.start, message)
    }

    fn at(&self, value: &Spanned<DeValue<'_>>, message: impl std::fmt::Display) -> SpecError {
        located(self.file, self.text, value.span().start, message)
    }
}

const NUMBER: &str = "a number without a unit";
const TEXT: &str = "a text in quotes";

/// The first key of `table` that is not known is an error that names the nearest known one.
fn reject_unknown(file: &str, text: &str, table: &DeTable<'_>, known: &[&str], place: &str) -> Result<(), SpecError> {
    let stranger =
        table.keys().filter(|key| !known.contains(&key.get_ref().as_ref())).min_by_key(|key| key.span().start);
    let Some(stranger) = stranger else {
        return Ok(());
    };
    let name = stranger.get_ref().as_ref();
    let nearest = known
        .iter()
        .max_by(|a, b| strsim::jaro_winkler(name, a).total_cmp(&strsim::jaro_winkler(name, b)))
        .copied()
        .unwrap_or_default();
    let message = format!("unknown key {name:?}{place}; did you mean \"{nearest}\"? Allowed: {}", known.join(", "));
    Err(located(file, text, stranger.span().start, message))
}
