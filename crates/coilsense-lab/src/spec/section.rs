//! One table of a spec, read key by key: what is missing, mistyped or unknown is said with its line.
//!
//! Next door: which keys there are (`keys`), what they mean for the science (one file per table).

use std::ops::Range;

use coilsense::Error;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::keys::{TABLES, Table};
use super::{SpecError, located};
use crate::quantity::Dimension;

/// A table `[name]`, or one of several `[[name]]`, of a spec file.
pub(super) struct Section<'a> {
    file: &'a str,
    text: &'a str,
    documented: &'static Table,
    /// As messages call it: `[spring]`, `[[condition]] 2`.
    label: String,
    table: &'a DeTable<'a>,
    span: Range<usize>,
}

/// A spec file, parsed as TOML, whose tables are all known.
pub(super) struct Document<'a> {
    file: &'a str,
    text: &'a str,
    table: Spanned<DeTable<'a>>,
    /// Whether keys that a spec does not know may stand here.
    lenient: bool,
}

impl<'a> Document<'a> {
    pub(super) fn parse(file: &'a str, text: &'a str) -> Result<Self, SpecError> {
        let document = Self { lenient: false, ..Self::catalogue(file, text)? };
        let names: Vec<&str> = TABLES.iter().map(|table| table.name).collect();
        reject_unknown(file, text, document.table.get_ref(), &names, "")?;
        Ok(document)
    }

    /// A catalogue, whose tables hold notes and sources beside the keys of a spec.
    pub(super) fn catalogue(file: &'a str, text: &'a str) -> Result<Self, SpecError> {
        let table = DeTable::parse(text).map_err(|error| {
            let offset = error.span().map_or(0, |span| span.start);
            located(file, text, offset, format!("not TOML: {}", error.message()))
        })?;
        Ok(Self { file, text, table, lenient: true })
    }

    /// The table `[name]`, which must be there.
    pub(super) fn section(&self, name: &'static str) -> Result<Section<'_>, SpecError> {
        self.optional_section(name)?.ok_or_else(|| SpecError(format!("{}: the table [{name}] is missing", self.file)))
    }

    /// The table `[name]`, where it is there.
    pub(super) fn optional_section(&self, name: &'static str) -> Result<Option<Section<'_>>, SpecError> {
        let Some(value) = self.table.get_ref().get(name) else {
            return Ok(None);
        };
        let Some(inner) = value.get_ref().as_table() else {
            let message = format!("{name} must be a table [{name}]");
            return Err(located(self.file, self.text, value.span().start, message));
        };
        Ok(Some(self.reading(name, format!("[{name}]"), inner, value.span())?))
    }

    /// All tables `[[name]]`, in order.
    pub(super) fn sections(&self, name: &'static str) -> Result<Vec<Section<'_>>, SpecError> {
        let Some(value) = self.table.get_ref().get(name) else {
            return Ok(Vec::new());
        };
        let message = || format!("{name} must be tables [[{name}]]");
        let fault = |offset: usize| located(self.file, self.text, offset, message());
        let each = value.get_ref().as_array().ok_or_else(|| fault(value.span().start))?;
        let section = |(index, item): (usize, &'_ Spanned<DeValue<'a>>)| match item.get_ref().as_table() {
            Some(_) => Ok((index, item.span())),
            None => Err(fault(item.span().start)),
        };
        let places: Vec<(usize, Range<usize>)> = each.iter().enumerate().map(section).collect::<Result<_, _>>()?;
        let tables = each.iter().filter_map(|item| item.get_ref().as_table());
        places
            .into_iter()
            .zip(tables)
            .map(|((index, span), table)| self.reading(name, format!("[[{name}]] {}", index + 1), table, span))
            .collect()
    }

    fn reading<'s>(
        &'s self,
        name: &str,
        label: String,
        table: &'s DeTable<'s>,
        span: Range<usize>,
    ) -> Result<Section<'s>, SpecError> {
        let documented =
            Table::named(name).ok_or_else(|| SpecError(format!("{}: no table [{name}] is known", self.file)))?;
        let section = Section { file: self.file, text: self.text, documented, label, table, span };
        if !self.lenient {
            reject_unknown(self.file, self.text, table, &documented.names(None), &format!(" in {}", section.label))?;
        }
        Ok(section)
    }
}

impl Section<'_> {
    /// Whether a key is there.
    pub(super) fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    /// The first of the keys that is there.
    pub(super) fn first_of<'k>(&self, keys: &[&'k str]) -> Option<&'k str> {
        keys.iter().copied().find(|key| self.has(key))
    }

    /// Rejects keys that do not apply to a kind; `whose` says in words what does not have them.
    pub(super) fn only_of(&self, kind: &str, whose: &str) -> Result<(), SpecError> {
        let known = self.documented.names(Some(kind));
        let stranger =
            self.table.keys().filter(|key| !known.contains(&key.get_ref().as_ref())).min_by_key(|key| key.span().start);
        let Some(stranger) = stranger else {
            return Ok(());
        };
        let (name, label) = (stranger.get_ref().as_ref(), &self.label);
        let message = format!("{name} in {label} is no key of {whose}; allowed: {}", known.join(", "));
        Err(located(self.file, self.text, stranger.span().start, message))
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

    /// Two quantities in a list.
    pub(super) fn pair(&self, key: &str, allowed: &[Dimension]) -> Result<Option<[(Dimension, f64); 2]>, SpecError> {
        let parse = |value: &DeValue| {
            let mut each = value.as_array()?.iter();
            let (Some(first), Some(second), None) = (each.next(), each.next(), each.next()) else { return None };
            Some([one_of(first.get_ref(), allowed)?, one_of(second.get_ref(), allowed)?])
        };
        self.read(key, parse, || format!("a list of two: [\"…\", \"…\"], each {}", any(allowed)))
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

    /// A text that is not empty.
    pub(super) fn text(&self, key: &str) -> Result<String, SpecError> {
        self.optional_text(key)?.ok_or_else(|| self.missing(key, TEXT))
    }

    /// A text that is not empty, on one line, where it is given.
    pub(super) fn optional_text(&self, key: &str) -> Result<Option<String>, SpecError> {
        let fits = |text: &&str| !text.trim().is_empty() && !text.chars().any(char::is_control);
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

    /// A quantity that is finite and above zero.
    pub(super) fn above_zero(&self, key: &str, dimension: Dimension) -> Result<Option<f64>, SpecError> {
        let Some(value) = self.optional_quantity(key, dimension)? else { return Ok(None) };
        self.check(key, value.is_finite() && value > 0.0, value, "above zero and finite").map(Some)
    }

    /// A quantity that is finite and not below zero.
    pub(super) fn not_negative(&self, key: &str, dimension: Dimension) -> Result<Option<f64>, SpecError> {
        let Some(value) = self.optional_quantity(key, dimension)? else { return Ok(None) };
        self.check(key, value.is_finite() && value >= 0.0, value, "zero or above, and finite").map(Some)
    }

    /// An error about the value of `key`.
    pub(super) fn refuse(&self, key: &str, error: impl std::fmt::Display) -> SpecError {
        match self.table.get(key) {
            Some(value) => self.at(value, format!("{key} = {}: {error}", self.source(value))),
            None => located(self.file, self.text, self.span.start, format!("{} {key}: {error}", self.label)),
        }
    }

    /// An error of the science: at the key that carries the quantity's name, or one that `aliases` (quantity, key) name.
    pub(super) fn refuse_science(&self, error: &Error, aliases: &[(&str, &str)]) -> SpecError {
        let key = match error {
            Error::Value { quantity, .. } => match aliases.iter().find(|(name, _)| name == quantity) {
                Some((_, key)) => (*key).to_owned(),
                None => quantity.replace(' ', "_"),
            },
            _ => String::new(),
        };
        match self.has(&key) {
            true => self.refuse(&key, error),
            false => located(self.file, self.text, self.span.start, format!("{}: {error}", self.label)),
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
        let message = format!("{} lacks the key \"{key}\": {expectation}", self.label);
        located(self.file, self.text, self.span.start, message)
    }

    fn at(&self, value: &Spanned<DeValue<'_>>, message: impl std::fmt::Display) -> SpecError {
        located(self.file, self.text, value.span().start, message)
    }
}

const NUMBER: &str = "a number without a unit";
const TEXT: &str = "a text in quotes";

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

fn list_of(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
    format!("one of {}", quoted.join(", "))
}

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
