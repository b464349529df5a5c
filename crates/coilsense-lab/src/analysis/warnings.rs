//! What a reader must know before using the numbers: where the linear model ends, what sampling folds, what the axial model leaves out.
//!
//! Next door: the judgement of sensors (`verdict`).

use coilsense::measures::alias_of;
use coilsense::modes::ChainModes;

use super::case::Case;
use super::instrument::Instrument;
use crate::data_sheet::DataSheet;
use crate::spec::{SensorSpec, Spec};

/// Something that a reader must know.
#[derive(Debug, Clone, PartialEq)]
pub struct Warning {
    /// What it is about.
    pub subject: Subject,
    /// In a sentence or two.
    pub text: String,
}

/// What a warning is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    /// Windings touch.
    Clash,
    /// A length out of range.
    Length,
    /// A surge line above half a sample rate.
    Alias,
    /// A reading above full scale.
    Range,
    /// Torsional or lateral motion.
    Neighbour,
}

impl Subject {
    /// Its name in `results.json`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Clash => "clash",
            Self::Length => "length",
            Self::Alias => "alias",
            Self::Range => "range",
            Self::Neighbour => "neighbour",
        }
    }
}

/// A folded line counts from this share of F_nom on.
const LEAST_LINE: f64 = 1e-4;

/// All warnings, the gravest first.
pub(super) fn of(spec: &Spec, sensors: &[SensorSpec], cases: &[Case], sheet: &DataSheet) -> Vec<Warning> {
    let mut warnings = Vec::new();
    for condition in 0..spec.conditions.len() {
        let of_condition: Vec<&Case> = cases.iter().filter(|case| case.condition == condition).collect();
        warnings.extend(clash(spec, &of_condition));
        warnings.extend(length(spec, &of_condition, sheet));
    }
    for (index, sensor) in sensors.iter().enumerate() {
        warnings.extend(alias(spec, sensor, cases));
        warnings.extend(range(spec, index, sensor, cases));
    }
    warnings.extend(sheet.neighbour_warnings().into_iter().map(|text| Warning { subject: Subject::Neighbour, text }));
    warnings
}

/// Windings that touch, under the damping where they come nearest.
fn clash(spec: &Spec, cases: &[&Case]) -> Option<Warning> {
    let nearest = cases.iter().min_by(|a, b| a.clash.smallest_pitch.total_cmp(&b.clash.smallest_pitch))?;
    let contact = nearest.clash.first_contact?;
    let clear: Vec<&str> = cases
        .iter()
        .filter(|case| !case.clash.happens())
        .map(|case| spec.mount.cases[case.damping].label.as_str())
        .collect();
    let until = if clear.is_empty() { String::new() } else { format!(" They stay clear at {}.", clear.join(", ")) };
    let text = format!(
        "{}, {}: windings touch from t = {contact:.3} s on ({:.2} mm from winding to winding at t = {:.3} s, wire {:.2} mm). The \
         numbers after that lie beyond what this spring can do.{until}",
        spec.conditions[nearest.condition].name,
        spec.mount.cases[nearest.damping].label,
        1e3 * nearest.clash.smallest_pitch,
        nearest.clash.time,
        1e3 * nearest.clash.contact_pitch,
    );
    Some(Warning { subject: Subject::Clash, text })
}

/// Lengths below the solid length, or out of the range in use.
fn length(spec: &Spec, cases: &[&Case], sheet: &DataSheet) -> Option<Warning> {
    let shortest = cases.iter().map(|case| case.lengths.0).fold(f64::INFINITY, f64::min);
    let longest = cases.iter().map(|case| case.lengths.1).fold(f64::NEG_INFINITY, f64::max);
    let name = &spec.conditions[cases.first()?.condition].name;
    let (min, max) = spec.spring.spring.operating_range();
    let solid = sheet.solid_length;
    // A micrometre is rounding of a length as it is written.
    let slack = 1e-6;
    let text = if shortest < solid - slack {
        format!(
            "{name}: the spring is {:.2} mm long at its shortest, below its solid length of {:.2} mm.",
            1e3 * shortest,
            1e3 * solid
        )
    } else if shortest < min - slack || longest > max + slack {
        format!(
            "{name}: lengths from {:.2} to {:.2} mm leave the range in use, {:.2}–{:.2} mm.",
            1e3 * shortest,
            1e3 * longest,
            1e3 * min,
            1e3 * max
        )
    } else {
        return None;
    };
    Some(Warning { subject: Subject::Length, text })
}

/// Surge lines above half of a sensor's sample rate that get through its filter.
fn alias(spec: &Spec, sensor: &SensorSpec, cases: &[Case]) -> Option<Warning> {
    let rate = sensor.readout.sample_rate?;
    let coil = coilsense::inductance::MaxwellSum::new(&spec.spring.spring, spec.spring.self_distance);
    let instrument = Instrument::new(sensor, &spec.spring.spring, &coil, spec.spring.spring.mid_length()).ok()?;
    let modes = ChainModes::mounted(&spec.spring.spring, spec.mount.far_end());
    let least = LEAST_LINE * spec.spring.spring.nominal_force();
    let mut folded = Vec::new();
    for angular in modes.frequencies() {
        let line = angular / std::f64::consts::TAU;
        let passes = instrument.readout().response(line).norm();
        let amplitude = cases.iter().map(|case| passes * case.line_amplitude(sensor, line)).fold(0.0, f64::max);
        if line > 0.5 * rate && amplitude > least {
            folded.push((line, alias_of(line, rate), amplitude));
        }
    }
    let (line, to, amplitude) = folded.iter().copied().max_by(|a, b| a.2.total_cmp(&b.2))?;
    let text = format!(
        "{}: {} surge line{} above half of its sample rate of {rate:.0} Hz get{} through its filter; the largest, {line:.0} Hz with {amplitude:.2} N, \
         shows up at {to:.1} Hz.",
        sensor.name,
        folded.len(),
        if folded.len() == 1 { "" } else { "s" },
        if folded.len() == 1 { "s" } else { "" },
    );
    Some(Warning { subject: Subject::Alias, text })
}

/// A load cell that sees more than its full scale.
fn range(spec: &Spec, index: usize, sensor: &SensorSpec, cases: &[Case]) -> Option<Warning> {
    if sensor.quantity.unit() != "N" {
        return None;
    }
    let peak = |case: &Case| case.readings[index].native.iter().fold(0.0_f64, |peak, value| peak.max(value.abs()));
    let (case, most) = cases.iter().map(|case| (case, peak(case))).max_by(|a, b| a.1.total_cmp(&b.1))?;
    // A held spring rings about F_nom itself: its full scale is meant with a margin.
    if most <= 1.25 * sensor.range {
        return None;
    }
    let text = format!(
        "{}: {:.1} N in {} is {:.0} % of its full scale of {:.1} N.",
        sensor.name,
        most,
        spec.conditions[case.condition].name,
        100.0 * most / sensor.range,
        sensor.range
    );
    Some(Warning { subject: Subject::Range, text })
}
