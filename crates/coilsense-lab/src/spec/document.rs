//! A spec file as TOML: its tables, which must all be known.
//!
//! Next door: which tables there are (`keys`), one table read key by key (`section`).

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::keys::{EXPERIMENT_TABLES, TABLES, Table, springs};
use super::section::{Section, clipped};
use super::{SpecError, former, located, synonyms};
use crate::likeness::nearest;
use crate::quantity::with_point;

/// The version of a spec's form that is read here: rises where a key changes its meaning.
pub const SPEC_VERSION: u64 = 1;
/// The table that may stand alone, `[spring]`, or several times.
const SPRING: &str = "spring";
/// The key at the top of a spec that may state it.
const VERSION_KEY: &str = "spec_version";

/// A spec file, parsed as TOML, whose tables are all known.
#[derive(Clone)]
pub(super) struct Document<'a> {
    file: &'a str,
    text: &'a str,
    table: Spanned<DeTable<'a>>,
    /// The tables that it may have.
    tables: &'static [&'static Table],
    /// Whether keys that a spec does not know may stand here.
    lenient: bool,
    /// What is called otherwise now, a sentence each.
    notes: Vec<String>,
}

impl<'a> Document<'a> {
    pub(super) fn parse(file: &'a str, text: &'a str) -> Result<Self, SpecError> {
        let document = Self { lenient: false, ..Self::catalogue(file, text)? };
        let names: Vec<&str> =
            TABLES.iter().filter(|table| !table.is_inner()).map(|table| table.name).chain([VERSION_KEY]).collect();
        reject_unknown(file, text, document.table.get_ref(), &names, "", |name| like_one_of(&names, name))?;
        document.check_version()?;
        Ok(document)
    }

    /// Whether the version that the file states, if it does, is one that is read here.
    fn check_version(&self) -> Result<(), SpecError> {
        let Some(value) = self.table.get_ref().get(VERSION_KEY) else { return Ok(()) };
        let stated = self.text.get(value.span()).unwrap_or_default();
        if stated == SPEC_VERSION.to_string() {
            return Ok(());
        }
        let message =
            format!("{VERSION_KEY} = {}: must be {SPEC_VERSION}, the only one that is read here", clipped(stated));
        Err(located(self.file, self.text, value.span().start, message))
    }

    /// A catalogue, whose tables hold notes and sources beside the keys of a spec.
    pub(super) fn catalogue(file: &'a str, text: &'a str) -> Result<Self, SpecError> {
        let mut table = DeTable::parse(text).map_err(|error| {
            let offset = error.span().map_or(0, |span| span.start);
            let point =
                decimal_comma(text, offset).map_or_else(String::new, |number| format!("; write {number} with a point"));
            located(file, text, offset, format!("not TOML: {}{point}", error.message().replace('\n', ", ")))
        })?;
        let notes = former::renamed(table.get_mut());
        Ok(Self { file, text, table, tables: &TABLES, lenient: true, notes })
    }

    /// An `experiment.toml`, which holds keys at its top, too.
    pub(super) fn experiment(file: &'a str, text: &'a str) -> Result<Self, SpecError> {
        let document = Self { lenient: false, tables: &EXPERIMENT_TABLES, ..Self::catalogue(file, text)? };
        let [root, tables @ ..] = EXPERIMENT_TABLES;
        let names: Vec<&str> = root.names(None).into_iter().chain(tables.map(|table| table.name)).collect();
        reject_unknown(file, text, document.table.get_ref(), &names, "", |name| like_one_of(&names, name))?;
        Ok(document)
    }

    /// The keys at the top of such a file.
    pub(super) fn root(&self) -> Section<'_> {
        Section {
            file: self.file,
            text: self.text,
            documented: EXPERIMENT_TABLES[0],
            label: EXPERIMENT_TABLES[0].heading(),
            table: self.table.get_ref(),
            span: 0..0,
            also: None,
        }
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
        Ok(Some(self.reading(name, format!("[{name}]"), inner, (value.span(), None))?))
    }

    /// The springs, `[spring]` or tables `[[spring]]`, in order; there is at least one.
    pub(super) fn springs(&self) -> Result<Vec<Section<'_>>, SpecError> {
        if !self.has_several_springs() {
            return Ok(vec![self.section(SPRING)?]);
        }
        let each = self.sections(SPRING)?;
        if let Some(second) = each.get(1).filter(|_| !cfg!(feature = "several-springs")) {
            return Err(
                second.together("are for `coilsense simulate` and `coilsense sweep`; this build takes one [spring]")
            );
        }
        if each.is_empty() { Err(SpecError(format!("{}: the table [spring] is missing", self.file))) } else { Ok(each) }
    }

    /// The only spring.
    ///
    /// # Errors
    /// [`SpecError`] where there are several.
    pub(super) fn only_spring(&self) -> Result<Section<'_>, SpecError> {
        let mut springs = self.springs()?;
        if let Some(second) = springs.get(1) {
            return Err(located(self.file, self.text, second.span.start, "[[spring]] 2: here one spring is taken"));
        }
        Ok(springs.swap_remove(0))
    }

    /// Whether springs are tables `[[spring]]`, be it a single one.
    pub(super) fn has_several_springs(&self) -> bool {
        self.table.get_ref().get(SPRING).is_some_and(|value| value.get_ref().is_array())
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
            .map(|((index, span), table)| {
                let also = (name == SPRING && index > 0).then_some(springs::BESIDE);
                self.reading(name, format!("[[{name}]] {}", index + 1), table, (span, also))
            })
            .collect()
    }

    /// Every table and key has been looked at once: what is read from now on differs in values only.
    pub(super) fn known(self) -> Self {
        Self { lenient: true, ..self }
    }

    /// The file's name, as messages call it.
    pub(super) fn file(&self) -> &'a str {
        self.file
    }

    /// What it calls as it was called before, a sentence each.
    pub(super) fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Its text.
    pub(super) fn text(&self) -> &'a str {
        self.text
    }

    /// Puts a value in place of a key's, or adds the key; of several tables of one name that at `index`, and of several around them that at
    /// `outer`. Messages show it where the old one stood, or at the head of its table.
    pub(super) fn set(
        &mut self,
        table: &'static str,
        [outer, index]: [Option<usize>; 2],
        key: &'static str,
        value: DeValue<'a>,
    ) {
        let span = self.table.span().start;
        let mut root = self.table.get_mut();
        let mut table = table;
        if let Some((around, name)) = inner(table) {
            let around = match (root.get_mut(around).map(Spanned::get_mut), outer) {
                (Some(DeValue::Array(each)), Some(number)) => each.get_mut(number).map(Spanned::get_mut),
                (found, _) => found,
            };
            let Some(DeValue::Table(within)) = around else { return };
            (root, table) = (within, name);
        }
        if !root.contains_key(table) && index.is_none() {
            root.insert(
                Spanned::new(span..span, table.into()),
                Spanned::new(span..span, DeValue::Table(DeTable::new())),
            );
        }
        let Some(found) = root.get_mut(table) else { return };
        let outer = match (index, found) {
            (None, found) => Some(found),
            (Some(index), found) => match found.get_mut() {
                DeValue::Array(each) => each.get_mut(index),
                _ => None,
            },
        };
        let Some(outer) = outer else { return };
        let head = outer.span().start;
        if let DeValue::Table(inner) = outer.get_mut() {
            // A span without a character in it: that of no value that a file holds.
            match inner.get_mut(key) {
                Some(old) => *old = Spanned::new(old.span().start..old.span().start, value),
                None => drop(inner.insert(Spanned::new(head..head, key.into()), Spanned::new(head..head, value))),
            }
        }
    }

    fn reading<'s>(
        &'s self,
        name: &str,
        label: String,
        table: &'s DeTable<'s>,
        (span, also): (Range<usize>, Option<&'static str>),
    ) -> Result<Section<'s>, SpecError> {
        let documented = self.tables.iter().copied().find(|table| table.name == name);
        let documented = documented.ok_or_else(|| SpecError(format!("{}: no table [{name}] is known", self.file)))?;
        let section = Section { file: self.file, text: self.text, documented, label, table, span, also };
        if !self.lenient {
            let (names, place) = (documented.names_of_any(also), format!(" in {}", section.label));
            let meant = |name: &str| synonyms::meant(documented, kind_of(documented, table), name);
            reject_unknown(self.file, self.text, table, &names, &place, meant)?;
        }
        Ok(section)
    }
}

/// The first key of `table` that is not known is an error that says what was probably `meant`, and what is allowed.
fn reject_unknown(
    file: &str,
    text: &str,
    table: &DeTable<'_>,
    known: &[&str],
    place: &str,
    meant: impl Fn(&str) -> String,
) -> Result<(), SpecError> {
    let stranger =
        table.keys().filter(|key| !known.contains(&key.get_ref().as_ref())).min_by_key(|key| key.span().start);
    let Some(stranger) = stranger else {
        return Ok(());
    };
    let name = clipped(stranger.get_ref());
    let inner = table.get(stranger.get_ref().as_ref()).map(Spanned::get_ref);
    let is_table = place.is_empty() && inner.is_some_and(|value| value.is_table() || value.is_array());
    let what = if is_table { "table" } else { "key" };
    let meant = meant(&name);
    let then = if meant.is_empty() { "; allowed" } else { " Allowed" };
    let message = format!("unknown {what} {name:?}{place}{meant}{then}: {}", known.join(", "));
    Err(located(file, text, stranger.span().start, message))
}

/// The number with a point that the line at an offset writes with a comma.
fn decimal_comma(text: &str, offset: usize) -> Option<String> {
    let before = text.get(..offset)?;
    let line = text[before.rfind('\n').map_or(0, |end| end + 1)..].lines().next()?;
    let value = line.split_once('=')?.1.split('#').next()?.trim();
    let number = with_point(value).filter(|number| number.parse::<f64>().is_ok())?;
    Some(number)
}

/// What is said of an unknown name at the top of a file.
fn like_one_of(known: &[&str], name: &str) -> String {
    nearest(name, known.iter().copied()).map_or_else(String::new, |known| format!("; did you mean \"{known}\"?"))
}

/// The kind that a table says it is of, by the key that tells it.
fn kind_of<'t>(documented: &Table, table: &'t DeTable<'_>) -> Option<&'t str> {
    let word = |key: &str| table.get(key).and_then(|value| value.get_ref().as_str());
    match documented.name {
        "spring" => Some(springs::way(|key| table.contains_key(key))),
        "mount" => Some(word("end2").unwrap_or("held")),
        "control" => word("drive"),
        _ => word("kind"),
    }
}

/// `spring` and `section` of `spring.section`, a table within another.
pub(super) fn inner(table: &'static str) -> Option<(&'static str, &'static str)> {
    table.split_once('.')
}
