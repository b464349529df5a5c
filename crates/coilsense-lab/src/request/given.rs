//! What was given for the options of a verb: checked, in SI units, by name; whichever door it came through.
//!
//! Next door: the options (the parent), what a verb makes of them (`recording`, `identification`, `calibration`, `mitigation`).

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::{Row, Wrong};

/// A value of an option.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// In the option's SI unit.
    Number(f64),
    /// A whole number.
    Count(u64),
    /// A word or any other text.
    Text(String),
    /// A path.
    File(PathBuf),
}

/// What was given, by the options' names.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Given {
    values: BTreeMap<&'static str, Vec<Value>>,
}

impl Given {
    /// Sets an option to values that its row let through; to none where it takes nothing but is said.
    pub fn set(&mut self, row: &Row, values: Vec<Value>) {
        self.values.insert(row.name, values);
    }

    /// From texts, such as those of a form; `said` is nothing for an option that nobody set.
    ///
    /// # Errors
    /// [`Wrong`] for the first option that cannot be.
    pub fn of<'a>(
        rows: impl IntoIterator<Item = &'a Row>,
        said: impl Fn(&Row) -> Option<Vec<String>>,
    ) -> Result<Self, Wrong> {
        let mut given = Self::default();
        for row in rows {
            if let Some(texts) = said(row) {
                given.set(row, texts.iter().map(|text| row.value(text)).collect::<Result<_, _>>()?);
            }
        }
        Ok(given)
    }

    /// Whether an option was said.
    pub fn holds(&self, row: &Row) -> bool {
        self.values.contains_key(row.name)
    }

    fn all(&self, row: &Row) -> impl Iterator<Item = &Value> {
        self.values.get(row.name).into_iter().flatten()
    }

    fn one<T>(&self, row: &Row, read: impl Fn(&Value) -> Option<T>) -> Option<T> {
        match self.all(row).next() {
            Some(value) => read(value),
            None => row.default_value().as_ref().and_then(read),
        }
    }

    /// A quantity in SI units, or a plain number; else what holds without it.
    pub fn number(&self, row: &Row) -> Option<f64> {
        self.one(row, |value| match value {
            Value::Number(number) => Some(*number),
            Value::Count(count) => Some(*count as f64),
            Value::Text(_) | Value::File(_) => None,
        })
    }

    /// A whole number; else what holds without it.
    pub fn count(&self, row: &Row) -> Option<u64> {
        self.one(row, |value| if let Value::Count(count) = value { Some(*count) } else { None })
    }

    /// A word or a text; else what holds without it.
    pub fn text(&self, row: &Row) -> Option<String> {
        self.one(row, |value| if let Value::Text(text) = value { Some(text.clone()) } else { None })
    }

    /// All texts of an option that may be given several times.
    pub fn texts(&self, row: &Row) -> Vec<String> {
        self.all(row)
            .filter_map(|value| if let Value::Text(text) = value { Some(text.clone()) } else { None })
            .collect()
    }

    /// The path of an option that has to be given.
    ///
    /// # Errors
    /// [`Wrong`] where it is not.
    pub fn needed(&self, row: &Row) -> Result<&Path, Wrong> {
        self.file(row).ok_or_else(|| row.wrong("must be given"))
    }

    /// A path.
    pub fn file(&self, row: &Row) -> Option<&Path> {
        self.all(row).find_map(|value| if let Value::File(path) = value { Some(path.as_path()) } else { None })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{IfAbsent, Takes};
    use super::*;

    const SEEDS: Row = Row { name: "seeds", takes: Takes::Count, if_absent: IfAbsent::Value("5"), ..Row::PLAIN };
    const SORT: Row = Row { name: "sort", ..Row::PLAIN };
    const OVER: Row = Row { name: "over", takes: Takes::Text("KEY=VALUES"), repeated: true, ..Row::PLAIN };

    #[test]
    fn what_is_not_said_is_what_holds_without_it() {
        let rows = [SEEDS, SORT, OVER];
        let nothing = Given::of(&rows, |_| None).unwrap();
        assert_eq!((nothing.count(&SEEDS), nothing.holds(&SORT), nothing.texts(&OVER).len()), (Some(5), false, 0));
        let said = |row: &Row| match row.name {
            "seeds" => Some(vec!["18446744073709551615".to_owned()]),
            "sort" => Some(Vec::new()),
            _ => Some(vec!["a=1".to_owned(), "b=2".to_owned()]),
        };
        let given = Given::of(&rows, said).unwrap();
        assert_eq!((given.count(&SEEDS), given.holds(&SORT)), (Some(u64::MAX), true));
        assert_eq!(given.texts(&OVER), ["a=1", "b=2"]);
        let wrong = Given::of(&rows, |_| Some(vec!["-1".to_owned()])).unwrap_err();
        assert_eq!(wrong.to_string(), "seeds: must be a whole number, got \"-1\"");
    }
}
