//! The tables `[[sensor]]`: the instruments that watch the spring.
//!
//! Next door: classes of instruments (`catalogue`), what they make of a signal (`coilsense::sensors`).

use coilsense::inductance::MaxwellSum;
use coilsense::sensors::ReadoutParameters;
use coilsense::{End, Spring};

use super::SpecError;
use super::catalogue;
use super::section::{Document, Section};
use super::spring::SpringSpec;
use crate::quantity::Dimension;

/// Every kind of sensor, by its word in a spec.
pub const KINDS: [&str; 4] = ["load-cell", "deflection", "two-encoder", "inductance"];

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
    /// Limits of error as a share of the range \[1\].
    pub accuracy_full_scale: f64,
    /// Limits of error as a share of the reading \[1\].
    pub accuracy_reading: f64,
    /// Standard uncertainty of the gain by calibration, as a share of the reading \[1\].
    pub calibration_uncertainty: f64,
    /// Of the gain \[1/K\].
    pub temperature_coefficient: f64,
}

/// What a sensor measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// The force at an end \[N\].
    Force(End),
    /// u2 − u1 \[m\].
    Deflection,
    /// The elongation between a motor-side encoder and end 2 \[m\].
    TwoEncoder {
        /// Of the drive train \[m/N\].
        compliance: f64,
        /// Its whole play \[m\].
        backlash: f64,
    },
    /// The spring's inductance \[H\].
    Inductance {
        /// Whether eq. (13) is not fitted to the spring but to Maxwell's sum.
        uncalibrated: bool,
        /// Standard deviation of the departure from eq. (13)'s form, as a share of the travel \[1\].
        form: f64,
    },
}

/// Departure of measured springs from eq. (13)'s form, share of the travel: findings of measured runs, 0.3–2 %; and of a Maxwell sum
/// without calibration, 1–14 %.
const FITTED_FORM: f64 = 0.013;
const THEORY_FORM: f64 = 0.14;

impl Quantity {
    /// Its word in a spec.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Force(_) => KINDS[0],
            Self::Deflection => KINDS[1],
            Self::TwoEncoder { .. } => KINDS[2],
            Self::Inductance { .. } => KINDS[3],
        }
    }

    /// Its dimension.
    fn dimension(self) -> Dimension {
        match self {
            Self::Force(_) => Dimension::Force,
            Self::Deflection | Self::TwoEncoder { .. } => Dimension::Length,
            Self::Inductance { .. } => Dimension::Inductance,
        }
    }

    /// The SI unit of its readings.
    pub fn unit(self) -> &'static str {
        match self.dimension() {
            Dimension::Force => "N",
            Dimension::Length => "m",
            _ => "H",
        }
    }

    /// Full scale where a spec says nothing: the spring's.
    fn natural_range(self, spring: &Spring, coil: &MaxwellSum) -> f64 {
        let (shortest, longest) = spring.operating_range();
        match self {
            Self::Force(_) => spring.nominal_force(),
            Self::Deflection | Self::TwoEncoder { .. } => longest - shortest,
            Self::Inductance { .. } => (coil.at_length(shortest) - coil.at_length(longest)).abs(),
        }
    }
}

impl SensorSpec {
    pub(super) fn parse_all(document: &Document<'_>, spring: &SpringSpec) -> Result<Vec<Self>, SpecError> {
        let sections = document.sections("sensor")?;
        if sections.is_empty() {
            return Ok(Vec::new());
        }
        let coil = MaxwellSum::new(&spring.spring, spring.self_distance);
        let mut sensors: Vec<Self> = Vec::new();
        for section in sections {
            let sensor = Self::parse(&section, &spring.spring, &coil)?;
            if sensors.iter().any(|other| other.name == sensor.name) {
                let name = &sensor.name;
                return Err(
                    section.refuse("name", format!("{name:?} is the name of another sensor too; give each its own"))
                );
            }
            sensors.push(sensor);
        }
        Ok(sensors)
    }

    fn parse(section: &Section<'_>, spring: &Spring, coil: &MaxwellSum) -> Result<Self, SpecError> {
        let kind = section.word("kind", &KINDS)?;
        section.only_of(kind, &format!("kind \"{kind}\""))?;
        let quantity = quantity(section, kind)?;
        let natural = quantity.natural_range(spring, coil);
        let range = section.above_zero("range", quantity.dimension())?.unwrap_or(natural);
        let base = match section.optional_text("class")? {
            Some(class) => {
                catalogue::class(&class, quantity, range).map_err(|message| section.refuse("class", message))?
            }
            None => Self::perfect(kind, quantity, range),
        };
        base.with_keys(section)
    }

    /// An instrument without any limits of its own; `range` is its full scale in the native unit.
    pub fn perfect(name: &str, quantity: Quantity, range: f64) -> Self {
        Self {
            name: name.to_owned(),
            quantity,
            readout: ReadoutParameters { order: 2, ..Default::default() },
            range,
            accuracy_full_scale: 0.0,
            accuracy_reading: 0.0,
            calibration_uncertainty: 0.0,
            temperature_coefficient: 0.0,
        }
    }

    /// The same with what a table says.
    pub(super) fn with_keys(self, section: &Section<'_>) -> Result<Self, SpecError> {
        let (quantity, range, readout) = (self.quantity, self.range, self.readout);
        let order = section.optional_whole("order", 1, 8)?.map_or(readout.order, |order| order as usize);
        let share = |key| section.not_negative(key, Dimension::Share);
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
            accuracy_full_scale: share("accuracy_full_scale")?.unwrap_or(self.accuracy_full_scale),
            accuracy_reading: share("accuracy_reading")?.unwrap_or(self.accuracy_reading),
            calibration_uncertainty: share("calibration_uncertainty")?.unwrap_or(self.calibration_uncertainty),
            temperature_coefficient: section
                .optional_quantity("temperature_coefficient", Dimension::PerKelvin)?
                .unwrap_or(self.temperature_coefficient),
            ..self
        };
        let coefficient = sensor.temperature_coefficient;
        section.check(
            "temperature_coefficient",
            coefficient.abs() <= 1.0,
            coefficient,
            "at most 100 %/K either way",
        )?;
        coilsense::sensors::Readout::new(sensor.readout.clone())
            .map_err(|error| section.refuse_science(&error, &ALIASES))?;
        Ok(sensor)
    }
}

/// Quantities of the science and the keys that set them, where the words differ.
const ALIASES: [(&str, &str); 2] = [("averaging window", "averaging"), ("order of the low-pass", "order")];

/// A value in the native unit, or as a share of the range.
fn native(section: &Section<'_>, key: &str, quantity: Quantity, range: f64) -> Result<Option<f64>, SpecError> {
    let Some((dimension, value)) = section.optional_any_quantity(key, &[quantity.dimension(), Dimension::Share])?
    else {
        return Ok(None);
    };
    section.check(key, value.is_finite() && value >= 0.0, value, "zero or above, and finite")?;
    Ok(Some(if dimension == Dimension::Share { value * range } else { value }))
}

fn quantity(section: &Section<'_>, kind: &str) -> Result<Quantity, SpecError> {
    Ok(match kind {
        "load-cell" => match section.optional_whole("end", 1, 2)? {
            Some(1) => Quantity::Force(End::One),
            _ => Quantity::Force(End::Two),
        },
        "deflection" => Quantity::Deflection,
        "two-encoder" => Quantity::TwoEncoder {
            compliance: section.not_negative("compliance", Dimension::Compliance)?.unwrap_or(0.0),
            backlash: section.not_negative("backlash", Dimension::Length)?.unwrap_or(0.0),
        },
        _ => {
            let uncalibrated = section.optional_word("calibration", &["fitted", "theory"])? == Some("theory");
            let usual = if uncalibrated { THEORY_FORM } else { FITTED_FORM };
            let form = section.not_negative("calibration_form", Dimension::Share)?.unwrap_or(usual);
            Quantity::Inductance { uncalibrated, form }
        }
    })
}
