//! What the user says of a log, option by option; an error begins with the option's name.
//!
//! Next door: what comes of it (`identified`, `calibrated`).

use coilsense::identify::Settings;
use coilsense::modes::ChainModes;
use coilsense::{FarEnd, Spring};
use coilsense_lab::identification::Coil;
use coilsense_lab::message::{Door, Message};
use coilsense_lab::quantity::Dimension;
use coilsense_lab::recording::{Clock, Mapping, Repairs};
use coilsense_lab::spec::SpringSpec;
use serde_json::Value;

/// What the user says of a log; the names are those of the command's options.
#[derive(Debug, Clone, Default)]
pub struct Asked {
    value: Value,
}

impl Asked {
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

    /// An error in the page's words: what it calls the options stands under `labels`.
    pub(crate) fn said(&self, error: impl Into<Message>) -> String {
        let label = |name: &str| self.value.get("labels")?.get(name)?.as_str().map(str::to_owned);
        error.into().told(Door::Page(&label))
    }

    fn holds(&self, name: &str) -> bool {
        self.value.get(name).and_then(Value::as_bool).unwrap_or(false)
    }

    pub(crate) fn quantity(&self, name: &str, dimension: Dimension) -> Result<Option<f64>, String> {
        let Some(text) = self.text(name) else { return Ok(None) };
        let value = dimension.parse(text).filter(|value| value.is_finite());
        value.map(Some).ok_or_else(|| format!("{name}: must be {}, got {text:?}", dimension.expectation()))
    }

    pub(super) fn above_zero(&self, name: &str, dimension: Dimension) -> Result<Option<f64>, String> {
        let value = self.quantity(name, dimension)?;
        self.within(name, value, "above zero", |value| value > 0.0)
    }

    fn within(
        &self,
        name: &str,
        value: Option<f64>,
        allowed: &str,
        fits: impl Fn(f64) -> bool,
    ) -> Result<Option<f64>, String> {
        match value.filter(|value| !fits(*value)) {
            Some(_) => Err(format!("{name}: must be {allowed}, got {:?}", self.text(name).unwrap_or_default())),
            None => Ok(value),
        }
    }

    fn share(&self, name: &str) -> Result<Option<f64>, String> {
        let value = self.quantity(name, Dimension::Share)?;
        self.within(name, value, "from 0 % to below 100 %", |share| (0.0..1.0).contains(&share))
    }

    fn open_share(&self, name: &str) -> Result<Option<f64>, String> {
        let value = self.quantity(name, Dimension::Share)?;
        self.within(name, value, "above 0 % and below 100 %", |share| share > 0.0 && share < 1.0)
    }

    fn rate(&self, name: &str) -> Result<Option<f64>, String> {
        let value = self.quantity(name, Dimension::Frequency)?;
        self.within(name, value, "from 1e-9 to 1e9 Hz", |rate| (1e-9..=1e9).contains(&rate))
    }

    /// One of some words.
    pub(super) fn word<T: Copy>(&self, name: &str, words: &[(&str, T)]) -> Result<Option<T>, String> {
        let Some(text) = self.text(name) else { return Ok(None) };
        let found = words.iter().find(|(word, _)| *word == text).map(|(_, value)| *value);
        let allowed = || words.iter().map(|(word, _)| *word).collect::<Vec<_>>().join(", ");
        found.map(Some).ok_or_else(|| format!("{name}: must be one of {}, got {text:?}", allowed()))
    }

    /// Whether the log has the layout of the measured runs.
    pub(super) fn is_lab_data(&self) -> bool {
        self.text("preset") == Some("lab-data")
    }

    /// Which column is which, and how the text is written.
    pub(crate) fn mapping(&self) -> Result<Mapping, String> {
        let mut mapping = match (self.text("preset"), self.text("mapping")) {
            (Some(_), Some(_)) => return Err("mapping: cannot be given beside a preset".to_owned()),
            (Some(name), None) => Mapping::preset(name).map_err(|error| format!("preset: {}", self.said(error)))?,
            (None, Some(text)) => Mapping::parse("mapping", text).map_err(|error| self.said(error))?,
            (None, None) => Mapping::default(),
        };
        let delimiters = [(",", ','), (";", ';'), ("|", '|'), ("tab", '\t'), ("space", ' ')];
        let format = &mut mapping.format;
        format.delimiter = self.word("delimiter", &delimiters)?.or(format.delimiter);
        format.decimal_comma = self.word("decimal", &[(".", false), (",", true)])?.or(format.decimal_comma);
        if (format.delimiter, format.decimal_comma) == (Some(','), Some(true)) {
            return Err("decimal: must be \".\" where columns are separated by commas, got \",\"".to_owned());
        }
        format.sample_rate = self.rate("sample-rate")?.or(format.sample_rate);
        self.columns("column", mapping)
    }

    /// The same of the second device.
    pub(super) fn second_mapping(&self) -> Result<Mapping, String> {
        self.columns("with-column", Mapping::default())
    }

    fn columns(&self, name: &str, mut mapping: Mapping) -> Result<Mapping, String> {
        for column in self.value.get(name).and_then(Value::as_array).into_iter().flatten() {
            mapping.set(column.as_str().unwrap_or_default()).map_err(|error| self.said(error))?;
        }
        Ok(mapping)
    }

    /// What is known of the second device's clock.
    pub(super) fn clock(&self) -> Result<Clock, String> {
        let text = self.text("clock").unwrap_or("auto");
        Clock::parse(text).map_err(|allowed| format!("clock: {allowed}, got {text:?}"))
    }

    pub(super) fn repairs(&self) -> Result<Repairs, String> {
        Ok(Repairs {
            drop_incomplete: self.holds("drop-incomplete"),
            sort: self.holds("sort"),
            merge_repeated: self.holds("merge-repeated"),
            fill_gaps: self.above_zero("fill-gaps", Dimension::Time)?,
            resample: self.rate("resample")?,
            from: self.quantity("from", Dimension::Time)?,
            to: self.quantity("to", Dimension::Time)?,
        })
    }

    /// The page's spring, where the user says that it is the one.
    pub(super) fn spring(&self) -> Result<Option<SpringSpec>, String> {
        let spec = self.text("spec").map(|text| SpringSpec::parse("spec", text));
        spec.transpose().map_err(|error| error.to_string())
    }

    fn windings(&self) -> Result<Option<f64>, String> {
        let Some(text) = self.text("windings") else { return Ok(None) };
        let value = text.parse::<f64>().ok().filter(|count| (1.0..=1e6).contains(count));
        value.map(Some).ok_or_else(|| format!("windings: must be a number from 1 to 1000000, got {text:?}"))
    }

    pub(super) fn settings(&self, spring: Option<&Spring>) -> Result<Settings, String> {
        let first = spring.and_then(|spring| ChainModes::of(spring).frequencies().first().copied());
        let usual = Settings::default();
        Ok(Settings {
            windings: spring.map_or(self.windings()?, |spring| Some(spring.whole_windings() as f64)),
            mass: self.above_zero("mass", Dimension::Mass)?.filter(|_| spring.is_none()),
            predicted: first.map(|angular| angular / std::f64::consts::TAU),
            prediction_tolerance: self.open_share("prediction-tolerance")?.unwrap_or(usual.prediction_tolerance),
            far_end: self.far_end()?,
            tolerance: self.open_share("tolerance")?.unwrap_or(usual.tolerance),
            accuracy_force: self.share("accuracy-force")?.unwrap_or(usual.accuracy_force),
            accuracy_position: self.share("accuracy-position")?.unwrap_or(usual.accuracy_position),
        })
    }

    fn far_end(&self) -> Result<Option<FarEnd>, String> {
        let mass = self.above_zero("end-mass", Dimension::Mass)?;
        let told =
            self.word("end2", &[("held", Some(FarEnd::Position)), ("free", Some(FarEnd::Force)), ("mass", None)])?;
        match (told, mass) {
            (Some(Some(_)), Some(_)) => Err("end-mass: goes with a mass at end 2 only".to_owned()),
            (told, mass) => Ok(told.flatten().or(mass.map(FarEnd::Mass))),
        }
    }

    /// What no log tells of the coil, from the page's spring or told by hand: none where a part of it is missing.
    pub(super) fn coil(&self, spring: Option<&Spring>) -> Result<Option<Coil>, String> {
        if let Some(spring) = spring {
            let (coil_radius, wire_radius) = (spring.coil_radius(), spring.wire_radius());
            return Ok(Some(Coil { windings: spring.windings(), coil_radius, wire_radius }));
        }
        let (radius, wire) =
            (self.above_zero("radius", Dimension::Length)?, self.above_zero("wire", Dimension::Length)?);
        Ok(match (self.windings()?, radius, wire) {
            (Some(windings), Some(coil_radius), Some(wire)) => {
                Some(Coil { windings, coil_radius, wire_radius: 0.5 * wire })
            }
            _ => None,
        })
    }
}
