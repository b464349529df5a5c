//! A mapping as a TOML file, and the table of its keys.
//!
//! Next door: the mapping itself (`mapping`).

use std::path::Path;

use toml::{Table, Value};

use super::error::RecordingError;
use super::mapping::{Columns, Mapping};
use super::quantity::Quantity;
use super::title::Title;
use super::unit::{self, Gain};
use crate::quantity::Dimension;
use crate::spec::Key;

/// Keys of `[log]`: how the text is written.
pub const LOG_KEYS: [Key; 7] = [
    key(
        "delimiter",
        "\";\"",
        "what parts the columns: one character, or `\"space\"` for any number of spaces and tabs",
        "found out",
    ),
    key("decimal", "\",\"", "the decimal sign, `\".\"` or `\",\"`", "found out"),
    key("header", "false", "whether titles stand above the columns", "found out"),
    key("comment", "\"!\"", "what comment lines begin with", "`#`, `%` and `//`"),
    key("skip", "1", "so many rows of numbers are left out at the beginning", "0"),
    key("sample_rate", "\"2.5 kHz\"", "of a log without a time column: row 0 is at 0 s", "none"),
    key("sheet", "\"Run 2\"", "which sheet of a workbook is the log", "the first with numbers"),
];

/// Keys of an entry of `[columns]` that is a table of its own.
pub const COLUMN_KEYS: [Key; 7] = [
    key("column", "\"LC [N]\"", "title of the column with its unit, or `#3` for the third", "needed"),
    key("columns", "[\"#6\", \"#8\"]", "several columns, of which the mean counts", "`column`"),
    key("unit", "\"mN\"", "unit of the numbers", "the one in the title"),
    key(
        "gain",
        "\"12.5 N/V\"",
        "what a sensor's own signal means; `12.5 N` alone is for one of the column's numbers, whatever its unit",
        "the unit",
    ),
    key("factor", "-1", "a number by which all is multiplied; -1 turns the sign", "1"),
    key("offset", "\"0.2 N\"", "is added in the end", "none"),
    key(
        "constant",
        "\"0.2 N\"",
        "the same value in every row, in place of a column, such as the place of a held end",
        "none",
    ),
];

const fn key(name: &'static str, example: &'static str, meaning: &'static str, default: &'static str) -> Key {
    Key { name, example, meaning, default: Some(default), kinds: &[] }
}

/// The keys as Markdown, for `book/src/guide/logs.md`.
pub fn keys_markdown() -> String {
    let table = |keys: &[Key]| -> String {
        let row = |key: &Key| {
            let default = key.default.unwrap_or("needed");
            format!("| `{}` | `{}` | {} | {default} |\n", key.name, key.example, key.meaning)
        };
        format!(
            "| key | example | meaning | default |\n|---|---|---|---|\n{}",
            keys.iter().map(row).collect::<String>()
        )
    };
    format!("`[log]`:\n\n{}\nA table in `[columns]`:\n\n{}", table(&LOG_KEYS), table(&COLUMN_KEYS))
}

/// Most bytes of a mapping, which a person writes.
const MOST_WRITTEN: u64 = 1 << 20;

impl Mapping {
    /// Reads a TOML file with the tables `[log]` and `[columns]`; `book/src/guide/logs.md` lists their keys.
    ///
    /// # Errors
    /// [`RecordingError`] where it cannot be read, is no TOML, or has a key or value that it may not have.
    pub fn read(path: &Path) -> Result<Self, RecordingError> {
        let text = crate::spec::bounded(path, MOST_WRITTEN)
            .map_err(|error| RecordingError::of_file(path, format!("cannot be read: {error}")))?;
        Self::parse(&path.display().to_string(), &text)
    }

    /// Reads it from its text; `file` names it in errors.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn parse(file: &str, text: &str) -> Result<Self, RecordingError> {
        let refused = |message: String| RecordingError::of_words(format!("{file}: {message}"));
        let document: Table = text.parse().map_err(|error: toml::de::Error| {
            let line =
                1 + text.get(..error.span().map_or(0, |span| span.start)).map_or(0, |head| head.matches('\n').count());
            RecordingError::of_words(format!("{file}:{line}: not TOML: {}", error.message().replace('\n', ", ")))
        })?;
        let mut mapping = Self::default();
        for (name, value) in &document {
            let table = value.as_table().ok_or_else(|| refused(format!("{name} must be a table [{name}]")))?;
            match name.as_str() {
                "log" => mapping.read_log(table).map_err(|message| refused(format!("[log] {message}")))?,
                "columns" => mapping.read_columns(table).map_err(|message| refused(format!("[columns] {message}")))?,
                _ => return Err(refused(format!("unknown table [{name}]; allowed: [log], [columns]"))),
            }
        }
        Ok(mapping)
    }

    fn read_log(&mut self, table: &Table) -> Result<(), String> {
        known(table, &LOG_KEYS)?;
        let format = &mut self.format;
        format.delimiter = take(table, "delimiter", "one character, or \"space\"", |value| match value.as_str()? {
            "space" => Some(' '),
            "tab" => Some('\t'),
            text => {
                text.chars().next().filter(|c| text.len() == 1 && !c.is_alphanumeric() && !"\"+-.\n\r".contains(*c))
            }
        })?;
        format.decimal_comma = take(table, "decimal", "\".\" or \",\"", |value| match value.as_str()? {
            "." => Some(false),
            "," => Some(true),
            _ => None,
        })?;
        format.header = take(table, "header", "true or false", Value::as_bool)?;
        format.comment = take(table, "comment", "a text of 1 to 8 characters", |value| {
            value.as_str().filter(|text| (1..=8).contains(&text.len())).map(str::to_owned)
        })?;
        let skip = take(table, "skip", "a whole number from 0 up", |value| u64::try_from(value.as_integer()?).ok())?;
        format.skip = skip.unwrap_or(0);
        let frequency =
            |value: &Value| Dimension::Frequency.parse(value.as_str()?).filter(|rate| (1e-9..=1e9).contains(rate));
        format.sample_rate = take(table, "sample_rate", &Dimension::Frequency.expectation(), frequency)?;
        let name = |value: &Value| value.as_str().filter(|name| !name.trim().is_empty()).map(str::to_owned);
        format.sheet = take(table, "sheet", "the name of a sheet", name)?;
        Ok(())
    }

    fn read_columns(&mut self, table: &Table) -> Result<(), String> {
        for (name, value) in table {
            let quantity = Quantity::named(name).map_err(|allowed| format!("{name}: {allowed}"))?;
            let columns = match value {
                Value::String(title) if !title.trim().is_empty() => Columns::titled(title),
                Value::Table(keys) => of_table(keys, quantity).map_err(|message| format!("{name}: {message}"))?,
                _ => return Err(format!("{name}: must be a title in quotes or a table {{ column = …, … }}")),
            };
            self.put(quantity, columns);
        }
        Ok(())
    }
}

fn of_table(table: &Table, quantity: Quantity) -> Result<Columns, String> {
    known(table, &COLUMN_KEYS)?;
    let text = |value: &Value| value.as_str().filter(|text| !text.trim().is_empty()).map(str::to_owned);
    let texts = |value: &Value| -> Option<Vec<String>> {
        let each = value.as_array().filter(|each| !each.is_empty())?;
        each.iter().map(text).collect()
    };
    let one = take(table, "column", "a title in quotes", text)?;
    let several = take(table, "columns", "a list of titles in quotes", texts)?;
    let dimension = quantity.dimension();
    let quantity_of = |value: &Value| dimension.parse(value.as_str()?).filter(|value| value.is_finite());
    let constant = take(table, "constant", &dimension.expectation(), quantity_of)?;
    if let Some(constant) = constant {
        if table.len() > 1 || quantity == Quantity::Time {
            return Err("constant stands alone, and not for time".to_owned());
        }
        return Ok(Columns { constant: Some(constant), ..Columns::BY_NAME });
    }
    let titles = match (one, several) {
        (Some(one), None) => vec![one],
        (None, Some(several)) => several,
        _ => return Err("needs one of column, columns and constant".to_owned()),
    };
    let titles: Vec<Title> = titles.iter().map(|title| Title::parse(title)).collect();
    let unit = take(table, "unit", &dimension.expectation(), |value| {
        value.as_str().filter(|unit| unit::scale(dimension, unit).is_some()).map(str::to_owned)
    })?;
    let allowed = format!("{}, for one V, mV, A, mV/V or count", dimension.expectation());
    let gain = take(table, "gain", &allowed, |value| Gain::parse(dimension, value.as_str()?))?;
    if gain.is_some() && unit.is_some() {
        return Err("unit and gain say the same thing; give one of them".to_owned());
    }
    let number = |value: &Value| {
        let number = value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))?;
        (number.is_finite() && number != 0.0).then_some(number)
    };
    Ok(Columns {
        unit: unit.or_else(|| titles.iter().find_map(|title| title.unit.clone())),
        titles: titles.into_iter().map(|title| title.name).collect(),
        gain,
        factor: take(table, "factor", "a number that is not zero", number)?.unwrap_or(1.0),
        offset: take(table, "offset", &dimension.expectation(), quantity_of)?.unwrap_or(0.0),
        constant: None,
    })
}

/// The value of a key, where it is there.
fn take<T>(
    table: &Table,
    key: &str,
    allowed: &str,
    read: impl FnOnce(&Value) -> Option<T>,
) -> Result<Option<T>, String> {
    let Some(value) = table.get(key) else { return Ok(None) };
    match read(value) {
        Some(read) => Ok(Some(read)),
        None => Err(format!("{key} = {}: must be {allowed}", super::error::shortened(&value.to_string()))),
    }
}

fn known(table: &Table, keys: &[Key]) -> Result<(), String> {
    let names = || keys.iter().map(|key| key.name).collect::<Vec<_>>().join(", ");
    match table.keys().find(|name| keys.iter().all(|key| key.name != *name)) {
        Some(stranger) => Err(format!("unknown key {}; allowed: {}", super::error::clipped(stranger), names())),
        None => Ok(()),
    }
}
