//! A log that the user drops: its columns, what `coilsense identify` says of it, and a calibration where it holds inductances.
//!
//! Next door: how logs are read (`coilsense_lab::recording`), identified (`coilsense::identify`) and calibrated (`coilsense_lab::calibration`).

use coilsense::identify::{Part, Settings, Welch};
use coilsense::modes::ChainModes;
use coilsense_lab::calibration::{Measured, Method, Outcome, Plan};
use coilsense_lab::identification::Identified;
use coilsense_lab::quantity::Dimension;
use coilsense_lab::recording::{Format, Mapping, Points, Recording, Repairs, columns_of_text};
use coilsense_lab::report::{calibration_json, identification_json};
use coilsense_lab::spec::SpringSpec;
use serde_json::{Value, json};

use crate::answer::Answer;

/// Most points of a curve that is drawn.
const MOST: usize = 4000;

/// What the user says of a log; the names are those of the command's options.
#[derive(Debug, Clone, Default)]
pub struct Asked {
    value: Value,
}

impl Asked {
    /// From `{"column": ["F_o=#3 [N]"], "sample-rate": "2.5 kHz", "spec": "[spring] …", "drop-incomplete": true, …}`.
    ///
    /// # Errors
    /// One line for what is no JSON.
    pub fn parse(text: &str) -> Result<Self, String> {
        serde_json::from_str(text).map(|value| Self { value }).map_err(|error| error.to_string())
    }

    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        self.value.get(name).and_then(Value::as_str).map(str::trim).filter(|text| !text.is_empty())
    }

    fn holds(&self, name: &str) -> bool {
        self.value.get(name).and_then(Value::as_bool).unwrap_or(false)
    }

    pub(crate) fn quantity(&self, name: &str, dimension: Dimension) -> Result<Option<f64>, String> {
        let Some(text) = self.text(name) else { return Ok(None) };
        let value = dimension.parse(text).filter(|value| value.is_finite());
        value.map(Some).ok_or_else(|| format!("{name}: must be {}, got {text:?}", dimension.expectation()))
    }

    fn above_zero(&self, name: &str, dimension: Dimension) -> Result<Option<f64>, String> {
        let value = self.quantity(name, dimension)?;
        match value.filter(|value| *value <= 0.0) {
            Some(_) => Err(format!("{name}: must be above zero, got {:?}", self.text(name).unwrap_or_default())),
            None => Ok(value),
        }
    }

    pub(crate) fn mapping(&self) -> Result<Mapping, String> {
        let mut mapping = Mapping::default();
        mapping.format.sample_rate = self.above_zero("sample-rate", Dimension::Frequency)?;
        for column in self.value.get("column").and_then(Value::as_array).into_iter().flatten() {
            mapping.set(column.as_str().unwrap_or_default()).map_err(|error| error.to_string())?;
        }
        Ok(mapping)
    }

    fn repairs(&self) -> Result<Repairs, String> {
        Ok(Repairs {
            drop_incomplete: self.holds("drop-incomplete"),
            sort: self.holds("sort"),
            merge_repeated: self.holds("merge-repeated"),
            fill_gaps: self.above_zero("fill-gaps", Dimension::Time)?,
            resample: self.above_zero("resample", Dimension::Frequency)?,
            from: self.quantity("from", Dimension::Time)?,
            to: self.quantity("to", Dimension::Time)?,
        })
    }

    fn spring(&self) -> Result<Option<SpringSpec>, String> {
        let spec = self.text("spec").map(|text| SpringSpec::parse("spec", text));
        spec.transpose().map_err(|error| error.to_string())
    }

    fn settings(&self, spec: Option<&SpringSpec>) -> Result<Settings, String> {
        let spring = spec.map(|spec| &spec.spring);
        let first = spring.and_then(|spring| ChainModes::of(spring).frequencies().first().copied());
        Ok(Settings {
            windings: spring.map(|spring| spring.chain_masses() as f64),
            mass: self.above_zero("mass", Dimension::Mass)?.filter(|_| spring.is_none()),
            predicted: first.map(|angular| angular / std::f64::consts::TAU),
            ..Settings::default()
        })
    }
}

/// How a log is written, and its columns.
///
/// # Errors
/// One line, with the log's name.
pub fn columns(name: &str, text: Vec<u8>) -> Result<Answer, String> {
    let (description, titles) = columns_of_text(name, text, &Format::default()).map_err(|error| error.to_string())?;
    let titles = titles.iter().map(|title| json!({ "text": title.text, "name": title.name, "unit": title.unit }));
    Ok(Answer::new(&json!({ "description": description, "columns": titles.collect::<Vec<_>>() }), Vec::new()))
}

/// What the log says, as `coilsense identify --json` prints it, and the curves that show it.
///
/// # Errors
/// One line, with the log's name and where it can be said line and column.
pub fn identify(name: &str, text: Vec<u8>, asked: &Asked) -> Result<Answer, String> {
    let spring = asked.spring()?;
    let settings = asked.settings(spring.as_ref())?;
    let recording = Recording::of_text(name, text, &asked.mapping()?, &asked.repairs()?);
    let identified = Identified::of(recording.map_err(|error| error.to_string())?, &settings);
    let identified = identified.map_err(|error| error.to_string())?;
    let told = identification_json(&identified, None).map_err(|error| error.to_string())?;
    let found = &identified.found;
    let mut series = Vec::new();
    let mut spectra = Vec::new();
    for (number, (part, welch)) in found.spectra.iter().enumerate() {
        let (frequency, density) = amplitudes(welch);
        spectra.push(part_label(*part));
        series.push((format!("spectrum {number} frequency"), frequency));
        series.push((format!("spectrum {number}"), density));
    }
    if let Some(ring_down) = &found.ring_down {
        let some = |values: &[f64]| thinned(values);
        series.push(("ring time".to_owned(), some(&ring_down.time)));
        series.push(("ring measured".to_owned(), some(&ring_down.measured)));
        series.push(("ring fitted".to_owned(), some(&ring_down.fitted)));
    }
    if let Ok(line) = &found.stiffness {
        series.push(("length".to_owned(), thinned(&line.lengths)));
        series.push(("force".to_owned(), thinned(&line.forces)));
    }
    Ok(Answer::new(&json!({ "json": told, "spectra": spectra }), series))
}

/// The curve of inductance over length, as `coilsense calibrate --json` prints it, by least squares over all points.
///
/// # Errors
/// One line, with the log's name.
pub fn calibrate(name: &str, text: Vec<u8>, asked: &Asked) -> Result<Answer, String> {
    let zero_length = asked.above_zero("length-at-zero", Dimension::Length)?;
    let points =
        Points::of_text(name, text, &asked.mapping()?, &asked.repairs()?).map_err(|error| error.to_string())?;
    let measured = Measured::of_log(&points, zero_length).map_err(|error| error.to_string())?;
    let inversion = coilsense::calibrate::Inversion::Exact;
    let plan = Plan { method: Method::All, preload: None, inversion, coil: None, force: None };
    let outcome = Outcome::new(measured, plan).map_err(|error| error.to_string())?;
    let told = calibration_json(&outcome, None).map_err(|error| error.to_string())?;
    let pairs = &outcome.measured.points;
    let series =
        vec![("length".to_owned(), thinned(pairs.lengths())), ("inductance".to_owned(), thinned(pairs.inductances()))];
    Ok(Answer::new(&json!({ "json": told }), series))
}

fn part_label(part: Part) -> String {
    match part {
        Part::Difference => "½(F_o − F_i)".into(),
        Part::Sum => "½(F_o + F_i)".into(),
        Part::Single(channel) => channel.name().into(),
    }
}

/// Frequencies \[Hz\] and square root of the density \[N/√Hz\], the first line left out; where there are many, the largest of each group.
fn amplitudes(welch: &Welch) -> (Vec<f64>, Vec<f64>) {
    let shown = welch.density.get(1..).unwrap_or(&[]);
    let group = shown.len().div_ceil(MOST).max(1);
    let each = shown.chunks(group).enumerate().map(|(index, chunk)| {
        let largest = chunk.iter().copied().fold(0.0, f64::max);
        ((1.0 + (index * group) as f64) * welch.spacing, largest.sqrt())
    });
    each.unzip()
}

fn thinned(values: &[f64]) -> Vec<f64> {
    values.iter().step_by(values.len().div_ceil(MOST).max(1)).copied().collect()
}
