//! The tables `[[sensor]]`: the instruments that watch the spring.
//!
//! Next door: classes of instruments (`catalogue`), what they make of a signal (`coilsense::sensors`).

use coilsense::inductance::OverLength;
use coilsense::sensors::{Instrument, Kind, Limits, Quantity, Readout, ReadoutParameters, Site};
use coilsense::{Channel, Error, Spring};

use super::catalogue;
use super::document::Document;
use super::measurand::{KINDS, dimension, measurand};
use super::on_coil::on_coil;
use super::section::Section;
use super::spring::SpringSpec;
use super::{Files, SpecError, plain};
use crate::quantity::Dimension;
use crate::series;

/// An instrument.
#[derive(Debug, Clone, PartialEq)]
pub struct SensorSpec {
    /// Its name.
    pub name: String,
    /// What it measures.
    pub quantity: Quantity,
    /// What it makes of it over time; noise and resolution in the native unit.
    pub readout: ReadoutParameters,
    /// Full scale, in the native unit.
    pub range: f64,
    /// Whether the spec says its full scale, or what the spring does in use stands for it.
    pub range_is_given: bool,
    /// Limits of error as a share of the range \[1\].
    pub accuracy_full_scale: f64,
    /// Limits of error as a share of the reading \[1\].
    pub accuracy_reading: f64,
    /// Standard uncertainty of the gain by calibration, as a share of the reading \[1\].
    pub calibration_uncertainty: f64,
    /// Of the gain \[1/K\].
    pub temperature_coefficient: f64,
    /// At what a meter of inductance works \[Hz\].
    pub frequency: Option<f64>,
}

/// Most sensors: each reads every case.
const MOST_SENSORS: usize = 256;

impl SensorSpec {
    pub(super) fn parse_all(
        document: &Document<'_>,
        spring: &SpringSpec,
        files: &Files<'_>,
    ) -> Result<Vec<Self>, SpecError> {
        let sections = document.sections("sensor")?;
        if sections.is_empty() {
            return Ok(Vec::new());
        }
        if let Some(beyond) = sections.get(MOST_SENSORS) {
            return Err(beyond.refuse("kind", format!("at most {MOST_SENSORS} sensors are taken")));
        }
        let mut sensors: Vec<Self> = Vec::new();
        for section in sections {
            let sensor = Self::parse(&section, spring, files)?;
            let key = series::key_of(&sensor.name);
            let text = if let Some(other) = sensors.iter().find(|other| series::key_of(&other.name) == key) {
                format!(
                    "{:?} makes the same column as the sensor {:?}; give each its own name",
                    sensor.name, other.name
                )
            } else if Channel::ALL.iter().any(|channel| series::key_of(channel.name()) == key) {
                format!("{:?} makes the same column as a signal of the simulation; give it another name", sensor.name)
            } else {
                sensors.push(sensor);
                continue;
            };
            return Err(section.refuse("name", text));
        }
        Ok(sensors)
    }

    fn parse(section: &Section<'_>, spec: &SpringSpec, files: &Files<'_>) -> Result<Self, SpecError> {
        let spring = &spec.spring;
        let class = section.optional_text("class")?;
        // A class says its kind; a kind that is given must be that one.
        let word = match section.has("kind") {
            false => class.as_deref().and_then(catalogue::kind_of),
            true => None,
        };
        let word = word.map_or_else(|| section.word("kind", &KINDS), Ok)?;
        section.only_of(word, &format!("kind \"{word}\""))?;
        let kind = Kind::named(word).ok_or_else(|| section.refuse("kind", "is no kind of sensor".to_owned()))?;
        let quantity = measurand(section, kind, || on_coil(section, spec, files))?;
        // Magnetic turns are solved for those who watch them only.
        let coil: Box<dyn OverLength> = match kind.watches(Channel::Inductance) {
            true => spec.inductance_at_rest().map_err(|error| section.refuse("kind", error))?,
            false => Box::new(spec.inductance_in_air()),
        };
        let natural = kind.natural_range(spring, &*coil);
        if kind.watches(Channel::Inductance) && natural == 0.0 {
            return Err(section.refuse("kind", single_winding(section, spring)?));
        }
        let range = section.above_zero("range", dimension(kind))?.unwrap_or(natural);
        let base = match class {
            Some(class) => {
                Self::of_class(&class, quantity, range).map_err(|message| section.refuse("class", message))?
            }
            None => Self::perfect(word, quantity, range),
        };
        base.with_keys(section)
    }

    /// A sensor of a class; the error says which there are of its kind.
    pub(super) fn of_class(name: &str, quantity: Quantity, range: f64) -> Result<Self, String> {
        let text = |error: SpecError| error.to_string();
        let all = catalogue::sensor_rows().map_err(text)?;
        let kind = quantity.kind();
        let Some(place) = all.iter().position(|row| row.needed("class") == name && row.needed("kind") == kind) else {
            let names: Vec<String> = all
                .iter()
                .filter(|row| row.needed("kind") == kind)
                .map(|row| format!("{:?}", row.needed("class")))
                .collect();
            return Err(format!("no class of that name for kind \"{kind}\"; there are {}", names.join(", ")));
        };
        let document = Document::catalogue("data/sensors.toml", catalogue::SENSORS).map_err(text)?;
        let sections = document.sections("sensor").map_err(text)?;
        let section = sections.get(place).ok_or("data/sensors.toml of this program is damaged")?;
        Self::perfect(name, quantity, range).with_keys(section).map_err(text)
    }

    /// An instrument without any limits of its own; `range` is its full scale in the native unit.
    pub fn perfect(name: &str, quantity: Quantity, range: f64) -> Self {
        Self {
            name: name.to_owned(),
            quantity,
            readout: ReadoutParameters { order: 2, ..Default::default() },
            range,
            range_is_given: false,
            accuracy_full_scale: 0.0,
            accuracy_reading: 0.0,
            calibration_uncertainty: 0.0,
            temperature_coefficient: 0.0,
            frequency: None,
        }
    }

    /// Set up on a spring.
    ///
    /// # Errors
    /// What the science says of its values.
    pub fn on(&self, site: &Site<'_>) -> Result<Instrument, Error> {
        let sensor = self.quantity.on(site)?;
        Ok(Instrument::new(Readout::new(self.readout.clone())?, sensor))
    }

    /// How far it may be off, in its native unit.
    pub fn limits(&self) -> Limits {
        Limits {
            full_scale: self.accuracy_full_scale * self.range,
            of_reading: self.accuracy_reading,
            calibration: self.calibration_uncertainty,
            temperature_coefficient: self.temperature_coefficient,
        }
    }

    /// The same with what a table says.
    pub(super) fn with_keys(self, section: &Section<'_>) -> Result<Self, SpecError> {
        let (quantity, range, readout) = (self.quantity, self.range, self.readout);
        let order = section.optional_whole("order", 1, 8)?.map_or(readout.order, |order| order as usize);
        let sensor = Self {
            name: section.optional_text("name")?.unwrap_or(self.name),
            readout: ReadoutParameters {
                bandwidth: section.above_zero("bandwidth", Dimension::Frequency)?.or(readout.bandwidth),
                order,
                delay: section.not_negative("delay", Dimension::Time)?.unwrap_or(readout.delay),
                averaging: section.above_zero("averaging", Dimension::Time)?.or(readout.averaging),
                sample_rate: section.above_zero("sample_rate", Dimension::Frequency)?.or(readout.sample_rate),
                noise: native(section, "noise", quantity, range)?.unwrap_or(readout.noise),
                resolution: native(section, "resolution", quantity, range)?
                    .filter(|step| *step > 0.0)
                    .or(readout.resolution),
            },
            accuracy_full_scale: native(section, "accuracy_full_scale", quantity, range)?
                .map_or(self.accuracy_full_scale, |limit| limit / range),
            accuracy_reading: section.share("accuracy_reading")?.unwrap_or(self.accuracy_reading),
            calibration_uncertainty: section.share("calibration_uncertainty")?.unwrap_or(self.calibration_uncertainty),
            temperature_coefficient: section
                .optional_quantity("temperature_coefficient", Dimension::PerKelvin)?
                .unwrap_or(self.temperature_coefficient),
            frequency: section.above_zero("frequency", Dimension::Frequency)?.or(self.frequency),
            range_is_given: section.has("range"),
            ..self
        };
        let coefficient = sensor.temperature_coefficient;
        section.check(
            "temperature_coefficient",
            coefficient.abs() <= 1.0,
            coefficient,
            "at most 100 %/K either way",
        )?;
        Readout::new(sensor.readout.clone()).map_err(|error| section.refuse_science(&error, &[]))?;
        Ok(sensor)
    }
}

/// A value in the native unit, or as a share of the range.
fn native(section: &Section<'_>, key: &str, quantity: Quantity, range: f64) -> Result<Option<f64>, SpecError> {
    let Some((found, value)) =
        section.optional_any_quantity(key, &[dimension(quantity.of_kind()), Dimension::Share])?
    else {
        return Ok(None);
    };
    let native = if found == Dimension::Share { value * range } else { value };
    section.check(
        key,
        (0.0..=range).contains(&native),
        native,
        &format!("from zero to the range of {range} {}", quantity.unit()),
    )?;
    Ok(Some(native))
}

/// Why a spring has no sensor by inductance.
fn single_winding(section: &Section<'_>, spring: &Spring) -> Result<String, SpecError> {
    let name = section.optional_text("name")?.map_or_else(String::new, |name| format!("{name:?}: "));
    let windings = plain(spring.inductance_windings());
    let plural = if windings == "1" { "" } else { "s" };
    Ok(format!(
        "{name}must be another kind: the inductance of {windings} winding{plural} does not change with the length"
    ))
}
