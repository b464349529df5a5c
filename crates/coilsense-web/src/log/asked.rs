//! What the user says of a log, option by option; an error begins with the option's name.
//!
//! Next door: what comes of it (`identified`, `calibrated`).

use coilsense::Spring;
use coilsense::identify::Settings;
use coilsense_lab::identification::request::{OPTIONS, coil, settings};
use coilsense_lab::identification::{Coil, Expected};
use coilsense_lab::message::{Door, Message};
use coilsense_lab::recording::request::{CLEANING, LAYOUT, SECOND, WINDOW};
use coilsense_lab::recording::{Cleaning, Clock, Mapping};
use coilsense_lab::request::{Given, Row};
use coilsense_lab::spec::SpringSpec;
use serde_json::Value;

/// What the user says of a log; the names are those of the command's options.
#[derive(Debug, Clone, Default)]
pub struct Request {
    value: Value,
}

impl Request {
    /// From `{"column": ["F_o=#3 [N]"], "sample-rate": "2.5 kHz", "spec": "[spring] …", "drop-incomplete": true, …}`, and
    /// `"labels"`, which says what the page calls each option.
    ///
    /// # Errors
    /// One line for what is no JSON.
    pub fn parse(text: &str) -> Result<Self, String> {
        serde_json::from_str(text).map(|value| Self { value }).map_err(|error| error.to_string())
    }

    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        self.value.get(name).and_then(Value::as_str).map(str::trim).filter(|text| !text.is_empty())
    }

    /// What is said of these options.
    ///
    /// # Errors
    /// One line, which begins with the option's name and a colon.
    pub(crate) fn given<'a>(&self, rows: impl IntoIterator<Item = &'a Row>) -> Result<Given, String> {
        Given::of(rows, |row| self.texts(row)).map_err(|wrong| wrong.to_string())
    }

    /// An error in the page's words: what it calls the options stands under `labels`.
    pub(crate) fn told(&self, error: impl Into<Message>) -> String {
        let label = |name: &str| self.value.get("labels")?.get(name)?.as_str().map(str::to_owned);
        error.into().told(Door::Page(&label))
    }

    fn texts(&self, row: &Row) -> Option<Vec<String>> {
        match self.value.get(row.flag())? {
            Value::Bool(said) => said.then(Vec::new),
            Value::Array(texts) => Some(texts.iter().filter_map(Value::as_str).map(str::to_owned).collect()),
            _ => self.text(&row.flag()).map(|text| vec![text.to_owned()]),
        }
    }

    /// Which column is which, and how the text is written.
    pub(crate) fn mapping(&self) -> Result<Mapping, String> {
        let mapping = match (self.text("preset"), self.text("mapping")) {
            (Some(_), Some(_)) => return Err("mapping: cannot be given beside a preset".to_owned()),
            (Some(name), None) => Mapping::preset(name).map_err(|error| format!("preset: {}", self.told(error)))?,
            (None, Some(text)) => Mapping::parse("mapping", text).map_err(|error| self.told(error))?,
            (None, None) => Mapping::default(),
        };
        mapping.told(&self.given(&LAYOUT)?).map_err(|error| self.told(error))
    }

    /// The same of the second device.
    pub(super) fn second_mapping(&self) -> Result<Mapping, String> {
        self.columns("with-column", Mapping::default())
    }

    fn columns(&self, name: &str, mut mapping: Mapping) -> Result<Mapping, String> {
        for column in self.value.get(name).and_then(Value::as_array).into_iter().flatten() {
            mapping.set(column.as_str().unwrap_or_default()).map_err(|error| self.told(error))?;
        }
        Ok(mapping)
    }

    /// What is known of the second device's clock.
    pub(super) fn clock(&self) -> Result<Clock, String> {
        Ok(Clock::of(&self.given(&SECOND)?))
    }

    pub(super) fn cleaning(&self) -> Result<Cleaning, String> {
        Ok(Cleaning::of(&self.given(CLEANING.iter().chain(&WINDOW))?))
    }

    /// The page's spring, where the user says that it is the one.
    pub(super) fn spring(&self) -> Result<Option<SpringSpec>, String> {
        let spec = self.text("spec").map(|text| SpringSpec::parse("spec", text));
        spec.transpose().map_err(|error| error.to_string())
    }

    pub(super) fn settings(&self, spec: Option<&SpringSpec>) -> Result<Settings, String> {
        settings(&self.given(&OPTIONS)?, spec.map(Expected::of_spec)).map_err(|wrong| wrong.to_string())
    }

    /// What no log tells of the coil, from the page's spring or told by hand: none where a part of it is missing.
    pub(super) fn coil(&self, spring: Option<&Spring>) -> Result<Option<Coil>, String> {
        Ok(coil(&self.given(&OPTIONS)?, spring))
    }
}
