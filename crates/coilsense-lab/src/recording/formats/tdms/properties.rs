//! The properties of a file, a group or a channel, as far as they matter here.
//!
//! Next door: who asks for them (`scaling`, `clock`), types (`kind`).

use std::collections::BTreeMap;

use super::bytes::Bytes;
use super::kind::{self, Kind};

/// A property's value.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    Number(f64),
    Text(String),
    /// Fractions of 2^-64 s since 1904.
    Stamp(i128),
}

/// Values by name.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Properties(BTreeMap<String, Value>);

/// Most properties of one object that are kept; a scale of a table has two for each of its points.
const MOST: usize = 10_000;

impl Properties {
    /// Of these names and values.
    #[cfg(test)]
    pub fn of(pairs: &[(&str, Value)]) -> Self {
        Self(pairs.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect())
    }

    /// Reads a list and keeps what may matter, in place of what was told before.
    pub fn read(&mut self, bytes: &mut Bytes<'_>) -> Result<(), String> {
        for _ in 0..bytes.word()? {
            let name = bytes.text()?;
            let kind = Kind::of(bytes.word()?)?;
            let value = match kind {
                Kind::Text => Value::Text(String::from_utf8_lossy(bytes.text()?).into_owned()),
                _ => {
                    let size = kind.size().ok_or("a property is of no known size")?;
                    let (value, big_endian) = (bytes.take(size)?, bytes.big_endian());
                    let stamp = if kind == Kind::Stamp { kind::stamp(value, big_endian) } else { None };
                    stamp.map_or_else(|| Value::Number(kind.number(value, big_endian)), Value::Stamp)
                }
            };
            let Ok(name) = std::str::from_utf8(name) else { continue };
            if name.starts_with("NI_") || name.starts_with("wf_") || matches!(name, "unit_string" | "description") {
                if self.0.len() >= MOST && !self.0.contains_key(name) {
                    return Err(format!("it has more than {MOST} properties"));
                }
                self.0.insert(name.to_owned(), value);
            }
        }
        Ok(())
    }

    pub fn number(&self, name: &str) -> Option<f64> {
        match self.0.get(name)? {
            Value::Number(number) => Some(*number),
            Value::Text(_) | Value::Stamp(_) => None,
        }
    }

    pub fn text(&self, name: &str) -> Option<&str> {
        match self.0.get(name)? {
            Value::Text(text) => Some(text),
            Value::Number(_) | Value::Stamp(_) => None,
        }
    }

    pub fn stamp(&self, name: &str) -> Option<i128> {
        match self.0.get(name)? {
            Value::Stamp(stamp) => Some(*stamp),
            Value::Number(_) | Value::Text(_) => None,
        }
    }

    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }
}
