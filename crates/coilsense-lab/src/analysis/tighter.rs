//! What would fix a sensor by knowing something better: each line of its budget made as small as the goal needs it.
//!
//! Next door: changes of place and of dynamics, and the trial of all of them (`fix`).

use coilsense::helix::StiffnessAt;
use coilsense::sensors::cause;

use super::change::{Change, written};
use super::verdict::Verdict;
use crate::quantity::Dimension;
use crate::spec::{Model, SensorSpec, Spec};

/// A limit of error that must shrink to less than this share of itself is another instrument.
const LEAST_SHARE: f64 = 0.05;

/// For each line of the worst case's budget that alone stands between the sensor and the goal \[N\], the change that makes it fit.
pub(super) fn all(spec: &Spec, sensor: &SensorSpec, verdict: &Verdict, goal: f64) -> Vec<Change> {
    let lines = verdict.budget.budget.contributions().iter();
    // A helix moves by a curve of its own.
    let is_flat = spec.spring.stiffness_at == StiffnessAt::Flat && spec.spring.model != Model::Helix;
    let is_bent_flat = is_flat && verdict.budget.bend != 0.0;
    let change = |name: &str, contribution: f64| {
        let others = verdict.combined().powi(2) - contribution.powi(2);
        // What the other lines and the mean error leave of the goal.
        let share_beside = |others: f64| {
            let share = (goal * goal - others).max(0.0).sqrt() / contribution;
            Some(share).filter(|share| (LEAST_SHARE..1.0).contains(share))
        };
        if let Some(share) = share_beside(others) {
            return of_sensor(name, sensor, share).or_else(|| of_spring(name, spec, sensor, share));
        }
        // A rate that is measured in use takes the flat coil's bend with it.
        let (bias, bend) = (verdict.budget.budget.bias(), verdict.budget.bend);
        let share = share_beside(others - bias.powi(2) + (bias - bend).powi(2));
        let share = share.filter(|_| is_bent_flat && name == cause::STIFFNESS)?;
        measured_in_use(spec, sensor, Some(share))
    };
    let mut changes: Vec<Change> = lines.filter_map(|line| change(line.name.as_ref(), line.contribution)).collect();
    changes.extend(is_bent_flat.then(|| measured_in_use(spec, sensor, None)).flatten());
    changes
}

/// A better instrument: the limit behind a line of the budget, times `share`.
fn of_sensor(line: &str, sensor: &SensorSpec, share: f64) -> Option<Change> {
    let mut sensor = sensor.clone();
    let readout = &mut sensor.readout;
    let words = match line {
        cause::FULL_SCALE => {
            let text = percent(&mut sensor.accuracy_full_scale, share)?;
            format!("an accuracy of {text} of full scale")
        }
        cause::OF_READING => {
            let text = percent(&mut sensor.accuracy_reading, share)?;
            format!("an accuracy of {text} of the reading")
        }
        cause::CALIBRATION => format!("a gain calibrated to {}", percent(&mut sensor.calibration_uncertainty, share)?),
        cause::NOISE => {
            let text = percent(&mut readout.noise, share / sensor.range)?;
            readout.noise *= sensor.range;
            format!("noise of {text} of full scale")
        }
        cause::RESOLUTION => {
            let step = readout.resolution.as_mut()?;
            let text = percent(step, share / sensor.range)?;
            *step *= sensor.range;
            format!("a resolution of {text} of full scale")
        }
        cause::REMOUNTING => {
            *sensor.quantity.remounting_mut()? = 0.0;
            "a spring that is zeroed at one known length after each mounting".to_owned()
        }
        cause::MEASURED_FORM | cause::MAGNETIC_FORM | cause::STEEL_FORM | cause::STORED_FORM => {
            let text = percent(sensor.quantity.form_mut()?, share)?;
            format!("a calibration that fits within {text} of the travel")
        }
        _ => return None,
    };
    Some(Change { words, sensor, spec: None })
}

/// A spring whose rate and force are known from the middle of its range, in place of the flat coil's; where `share` is given, that much better.
fn measured_in_use(spec: &Spec, sensor: &SensorSpec, share: Option<f64>) -> Option<Change> {
    let mut spec = spec.clone();
    let mut words = "k and F measured in the middle of the range".to_owned();
    if let Some(share) = share {
        let mut tolerance = spec.spring.stiffness_tolerance();
        words = format!("{words}, k within ±{}", percent(&mut tolerance, share)?);
        spec.spring.tolerances.stiffness = Some(tolerance);
    }
    spec.spring.stiffness_at = StiffnessAt::Range;
    Some(Change { words, sensor: sensor.clone(), spec: Some(spec) })
}

/// A spring that is known better: the limit behind a line of the budget, times `share`.
fn of_spring(line: &str, spec: &Spec, sensor: &SensorSpec, share: f64) -> Option<Change> {
    let mut spec = spec.clone();
    let words = match line {
        cause::TEMPERATURE => {
            let kelvin = cut(share * spec.uncertainty.temperature_change);
            let (value, text) = written(Dimension::Temperature, format!("{kelvin} K"))?;
            spec.uncertainty.temperature_change = value;
            format!("a temperature within ±{text} of the calibration's")
        }
        cause::STIFFNESS => {
            let mut tolerance = spec.spring.stiffness_tolerance();
            let words = format!("a stiffness known within ±{}", percent(&mut tolerance, share)?);
            spec.spring.tolerances.stiffness = Some(tolerance);
            words
        }
        cause::INITIAL_TENSION => {
            let tolerance = &mut spec.spring.tolerances.initial_tension;
            format!("an initial tension known within ±{}", percent(tolerance, share)?)
        }
        cause::REST_LENGTH => {
            let length = cut(1e3 * share * spec.spring.rest_length_tolerance());
            let (value, text) = written(Dimension::Length, format!("{length} mm"))?;
            spec.spring.tolerances.rest_length = value;
            format!("a rest length known within ±{text}")
        }
        _ => return None,
    };
    Some(Change { words, sensor: sensor.clone(), spec: Some(spec) })
}

/// Makes a value `share` times itself, as a percentage that can be written, and says which.
fn percent(value: &mut f64, share: f64) -> Option<String> {
    let (short, text) = written(Dimension::Share, format!("{} %", cut(100.0 * share * *value)))?;
    *value = short;
    Some(text)
}

/// Two significant digits, the rest cut off, so that what is named does not ask for less than it takes.
fn cut(value: f64) -> String {
    let decimals = (1 - value.log10().floor() as i32).clamp(0, 12);
    let power = 10_f64.powi(decimals);
    format!("{:.*}", decimals as usize, (value * power).floor() / power)
}
