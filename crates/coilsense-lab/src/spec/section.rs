//! One table of a spec: which keys it has, and errors that stand at the line of a key.
//!
//! Next door: reading values by their type (`value`), which keys there are (`keys`), what they mean (one file per table).

use std::ops::Range;

use coilsense::Error;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::keys::Table;
use super::{SpecError, located};
use crate::quantity::pointed;

/// Most characters of a value that a message repeats.
const MOST_SHOWN: usize = 80;

/// A table `[name]`, or one of several `[[name]]`, of a spec file.
pub(super) struct Section<'a> {
    pub(super) file: &'a str,
    pub(super) text: &'a str,
    pub(super) documented: &'static Table,
    /// As messages call it: `[spring]`, `[[condition]] 2`.
    pub(super) label: String,
    pub(super) table: &'a DeTable<'a>,
    pub(super) span: Range<usize>,
    /// A kind that it is of besides the one that its keys tell: it may hold the keys of both.
    pub(super) also: Option<&'static str>,
}

impl Section<'_> {
    /// Whether a key is there.
    pub(super) fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    /// Whether its value is a list.
    pub(super) fn is_list(&self, key: &str) -> bool {
        self.table.get(key).is_some_and(|value| value.get_ref().is_array())
    }

    /// How many tables `[[name.key]]` there are.
    pub(super) fn number_of(&self, key: &str) -> usize {
        self.table.get(key).and_then(|value| value.get_ref().as_array()).map_or(0, |each| each.len())
    }

    /// The tables of an array of them within this one, in order.
    pub(super) fn tables(&self, key: &'static str) -> Result<Vec<Section<'_>>, SpecError> {
        let Some(value) = self.table.get(key) else { return Ok(Vec::new()) };
        let heading = format!("[[{}.{key}]]", self.documented.name);
        let fault = || self.at(value, format!("{key} in {} must be tables {heading}", self.label));
        let documented = self.documented.child(key).ok_or_else(fault)?;
        let each = value.get_ref().as_array().ok_or_else(fault)?;
        let table = |(index, item): (usize, &'_ Spanned<DeValue<'_>>)| match item.get_ref().as_table() {
            Some(_) => Ok((index, item.span())),
            None => Err(fault()),
        };
        let places: Vec<(usize, Range<usize>)> = each.iter().enumerate().map(table).collect::<Result<_, _>>()?;
        let tables = each.iter().filter_map(|item| item.get_ref().as_table());
        let read = |((index, span), table)| {
            let section = Section {
                file: self.file,
                text: self.text,
                documented,
                label: format!("{heading} {}", index + 1),
                table,
                span,
                also: None,
            };
            section.only_of("", "a section of a spring")?;
            Ok(section)
        };
        places.into_iter().zip(tables).map(read).collect()
    }

    /// The first of the keys that is there.
    pub(super) fn first_of<'k>(&self, keys: &[&'k str]) -> Option<&'k str> {
        keys.iter().copied().find(|key| self.has(key))
    }

    /// Rejects keys that do not apply to a kind; `whose` says in words what does not have them.
    pub(super) fn only_of(&self, kind: &str, whose: &str) -> Result<(), SpecError> {
        let mut known = self.documented.names_with_tables(Some(kind));
        if let Some(also) = self.also.filter(|_| cfg!(feature = "several-springs")) {
            let own = self.documented.names(Some(also)).into_iter().filter(|name| !known.contains(name));
            known.extend(own.collect::<Vec<_>>());
        }
        let stranger =
            self.table.keys().filter(|key| !known.contains(&key.get_ref().as_ref())).min_by_key(|key| key.span().start);
        let Some(stranger) = stranger else {
            return Ok(());
        };
        let (name, label) = (stranger.get_ref().as_ref(), &self.label);
        let message = format!("{name} in {label} is no key of {whose}; allowed: {}", known.join(", "));
        Err(located(self.file, self.text, stranger.span().start, message))
    }

    /// An error about the value of `key`.
    pub(super) fn refuse(&self, key: &str, error: impl std::fmt::Display) -> SpecError {
        match self.table.get(key) {
            Some(value) => self.at(value, format!("{key} = {}: {error}", self.source(value))),
            None => located(self.file, self.text, self.span.start, format!("{} {key}: {error}", self.label)),
        }
    }

    /// An error about this table as one of several springs.
    pub(super) fn together(&self, why: &str) -> SpecError {
        located(self.file, self.text, self.span.start, format!("{}: several springs {why}", self.label))
    }

    /// An error of the science: at the key of its parameter's name, or at the one that `keys` (parameter, key) says sets it; at the table
    /// where it is about no parameter, or about one that follows from several keys.
    pub(super) fn refuse_science(&self, error: &Error, keys: &[(&str, &str)]) -> SpecError {
        let key = error.field().map(|field| keys.iter().find(|(name, _)| *name == field).map_or(field, |(_, key)| key));
        match key.filter(|key| self.has(key)) {
            Some(key) => self.refuse(key, error),
            None => located(self.file, self.text, self.span.start, format!("{}: {error}", self.label)),
        }
    }

    /// The value of `key`, where it is there and `parse` takes it.
    pub(super) fn read<T>(
        &self,
        key: &str,
        parse: impl Fn(&DeValue) -> Option<T>,
        expectation: impl Fn() -> String,
    ) -> Result<Option<T>, SpecError> {
        let Some(value) = self.table.get(key) else {
            return Ok(None);
        };
        // What was put in the place of a value is a text, also where it is a number.
        let number = || DeValue::parse(value.get_ref().as_str()?).ok().and_then(|number| parse(number.get_ref()));
        let parsed = parse(value.get_ref()).or_else(|| if value.span().is_empty() { number() } else { None });
        let is_taken = |text: &str| parse(&DeValue::String(text.to_owned().into())).is_some();
        let point = || value.get_ref().as_str().map_or_else(String::new, |text| pointed(text, is_taken));
        let message = || format!("{key} = {}: must be {}{}", self.source(value), expectation(), point());
        parsed.map(Some).ok_or_else(|| self.at(value, message()))
    }

    /// The value as the file writes it, clipped; one that was put in its place, as a file would.
    fn source(&self, value: &Spanned<DeValue<'_>>) -> String {
        if !value.span().is_empty() {
            return clipped(self.text.get(value.span()).unwrap_or_default());
        }
        match value.get_ref().as_str().unwrap_or_default() {
            number if number.parse::<f64>().is_ok() => clipped(number),
            text => clipped(&format!("{text:?}")),
        }
    }

    /// An error about a key that is not there.
    pub(super) fn missing(&self, key: &str, expectation: &str) -> SpecError {
        let message = format!("{} lacks the key \"{key}\": {expectation}", self.label);
        located(self.file, self.text, self.span.start, message)
    }

    fn at(&self, value: &Spanned<DeValue<'_>>, message: impl std::fmt::Display) -> SpecError {
        located(self.file, self.text, value.span().start, message)
    }
}

/// The first line of what a file writes, as far as a message repeats it, without characters that move a terminal's cursor.
pub(super) fn clipped(source: &str) -> String {
    let first = source.lines().next().unwrap_or_default().trim_end();
    let shown: String = first.chars().take(MOST_SHOWN).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if shown.len() < source.len() { format!("{shown} …") } else { shown }
}
