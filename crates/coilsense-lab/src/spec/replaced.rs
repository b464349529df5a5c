//! A spec's text with some of its values replaced, and everything else as its author wrote it.
//!
//! Next door: the same without a text, a million times (`draft`).

use toml_edit::{DocumentMut, Item, Table, TableLike, Value};

use super::SpecError;
use super::document::inner;
use super::draft::Place;
use super::keys::Domain;

/// Puts values, as a spec has them but for quotes, in their places; a key that is not there is added to its table.
pub(crate) fn replaced(file: &str, text: &str, values: &[(&Place, &str)]) -> Result<String, SpecError> {
    let mut document: DocumentMut =
        text.parse().map_err(|error: toml_edit::TomlError| SpecError(format!("{file}: {}", error.message())))?;
    for (place, value) in values {
        let Some(table) = table(&mut document, place) else {
            return Err(SpecError(format!("{file}: has no table [{}] for {}", place.table, place.key)));
        };
        let mut new = written(value, &place.domain);
        match table.get_mut(place.key) {
            Some(Item::Value(old)) => {
                // What stands round it, such as a comment behind it, stays.
                *new.decor_mut() = old.decor().clone();
                *old = new;
            }
            _ => drop(table.insert(place.key, Item::Value(new))),
        }
    }
    Ok(document.to_string())
}

fn table<'d>(document: &'d mut DocumentMut, place: &Place) -> Option<&'d mut dyn TableLike> {
    let (root, name): (&mut dyn TableLike, _) = match inner(place.table) {
        Some((outer, name)) => (one(document.get_mut(outer)?, place.spring)?, name),
        None => (document.as_table_mut(), place.table),
    };
    match place.index {
        None => root.entry(name).or_insert_with(|| Item::Table(Table::new())).as_table_like_mut(),
        index => one(root.get_mut(name)?, index),
    }
}

/// A table, or of several the one at `index`.
fn one(item: &mut Item, index: Option<usize>) -> Option<&mut dyn TableLike> {
    match (item, index) {
        (Item::ArrayOfTables(tables), Some(index)) => tables.get_mut(index).map(|table| table as &mut dyn TableLike),
        (Item::Value(Value::Array(tables)), Some(index)) => {
            tables.get_mut(index)?.as_inline_table_mut().map(|table| table as &mut dyn TableLike)
        }
        (item, None) => item.as_table_like_mut(),
        _ => None,
    }
}

/// A number where the key takes one without a unit, else a text.
fn written(value: &str, domain: &Domain) -> Value {
    let number = value.trim().parse::<Value>().ok().filter(|number| number.is_integer() || number.is_float());
    match (domain, number) {
        (Domain::Number, Some(number)) => number,
        _ => Value::from(value),
    }
}
