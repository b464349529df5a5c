//! Which column of a log is which channel, as Python says it.
//!
//! Next door: what is read (`recording`), what may be cleaned there.

use std::path::PathBuf;

use coilsense_lab::recording::Mapping;
use coilsense_lab::recording::request::{COLUMN, CONSTANT, DECIMAL, DELIMITER, GAIN, NEGATE, OFFSET, SAMPLE_RATE};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{Error, IntoPython};
use crate::quantity::{Anything, Quantity, Said, given, neither};
use crate::series::described;

/// Arguments of everything that reads a log.
#[derive(Default)]
pub struct LogOptions<'py> {
    /// Titles or numbers by channel.
    pub columns: Option<Bound<'py, PyDict>>,
    /// Units by channel.
    pub units: Option<Bound<'py, PyDict>>,
    /// What a sensor's own signal means, by channel.
    pub gain: Option<Bound<'py, PyDict>>,
    /// What is added, by channel.
    pub offset: Option<Bound<'py, PyDict>>,
    /// Channels whose sign is turned.
    pub negate: Option<Vec<String>>,
    /// Channels that stand still, and where.
    pub constant: Option<Bound<'py, PyDict>>,
    /// A TOML file.
    pub mapping: Option<PathBuf>,
    /// A known layout.
    pub preset: Option<String>,
    /// What parts the columns.
    pub delimiter: Option<String>,
    /// The decimal sign.
    pub decimal: Option<String>,
    /// For a log without a time column.
    pub sample_rate: Option<Quantity>,
}

/// A column by its title, or by its number from 1.
#[derive(FromPyObject)]
enum Column {
    Number(u32),
    Title(String),
    Other(Anything),
}

impl LogOptions<'_> {
    /// The mapping they make.
    pub fn mapping(self) -> PyResult<Mapping> {
        let mapping = match (&self.preset, &self.mapping) {
            (Some(_), Some(_)) => {
                return Err(Error::new_err("preset and mapping say the same thing; give one of them"));
            }
            (Some(name), None) => Mapping::preset(name).python()?,
            (None, Some(file)) => Mapping::read(file).python()?,
            (None, None) => Mapping::default(),
        };
        let mut titles: Vec<(String, String)> = Vec::new();
        for (name, column) in self.columns.iter().flatten() {
            let title = match column.extract()? {
                Column::Number(number) => format!("#{number}"),
                Column::Title(title) => title,
                Column::Other(object) => {
                    return Err(neither("columns", "titles, or numbers from 1, by channel", &object));
                }
            };
            titles.push((text("columns", &name)?, title));
        }
        for (name, unit) in self.units.iter().flatten() {
            let (name, unit) = (text("units", &name)?, text("units", &unit)?);
            match titles.iter_mut().find(|(other, _)| *other == name) {
                Some((_, title)) => title.push_str(&format!(" [{unit}]")),
                None => titles.push((name.clone(), format!("{name} [{unit}]"))),
            }
        }
        let columns = titles.iter().map(|(name, title)| format!("{name}={title}")).collect();
        let given = given([
            (&COLUMN, Said::Texts(columns)),
            (&CONSTANT, Said::Texts(by_channel("constant", self.constant.as_ref())?)),
            (&GAIN, Said::Texts(by_channel("gain", self.gain.as_ref())?)),
            (&OFFSET, Said::Texts(by_channel("offset", self.offset.as_ref())?)),
            (&NEGATE, Said::Texts(self.negate.unwrap_or_default())),
            (&DELIMITER, self.delimiter.into()),
            (&DECIMAL, self.decimal.into()),
            (&SAMPLE_RATE, self.sample_rate.into()),
        ])?;
        mapping.told(&given).python()
    }
}

/// `NAME=VALUE` of each item.
fn by_channel(argument: &str, items: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<String>> {
    let each = items.into_iter().flatten();
    each.map(|(name, value)| Ok(format!("{}={}", text(argument, &name)?, text(argument, &value)?))).collect()
}

/// A text of an argument that is a dict of them.
fn text(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<String> {
    let wrong =
        |_| PyTypeError::new_err(format!("{argument} must hold texts, got {}", described(&object.as_borrowed())));
    object.extract().map_err(wrong)
}
