//! What would fix a sensor that misses the goal: each change is tried on the same motions.
//!
//! Next door: how a sensor is judged (`verdict`).

use coilsense::{End, Error};

use super::verdict::{Judge, Verdict};
use crate::spec::{Quantity, SensorSpec};

/// A change with which a sensor meets the goal.
#[derive(Debug, Clone, PartialEq)]
pub struct Fix {
    /// What is changed, as a noun.
    pub change: String,
    /// The largest combined uncertainty with it \[N\].
    pub combined: f64,
    /// How much later the force then comes \[s\].
    pub lag: f64,
}

/// Most changes that are named.
const MOST_NAMED: usize = 3;
/// A limit of error that must shrink to less than this share of itself is another instrument.
const LEAST_SHARE: f64 = 0.05;

/// Single changes with which a sensor meets the goal under every damping, the quickest first.
pub(super) fn of(judge: &Judge<'_>, sensor: &SensorSpec, verdict: &Verdict) -> Result<Vec<Fix>, Error> {
    let Some(goal) = judge.spec.goal.error else { return Ok(Vec::new()) };
    let mut fixes = Vec::new();
    let tried = candidates(judge, sensor).into_iter().chain(better(sensor, verdict, goal));
    for (change, changed) in tried {
        let trial = judge.trial(&changed)?;
        if trial.reaches && trial.combined <= goal {
            fixes.push(Fix { change, combined: trial.combined, lag: trial.lag });
        }
    }
    fixes.sort_by(|a, b| a.lag.total_cmp(&b.lag));
    fixes.truncate(MOST_NAMED);
    Ok(fixes)
}

/// Changes of place and of dynamics.
fn candidates(judge: &Judge<'_>, sensor: &SensorSpec) -> Vec<(String, SensorSpec)> {
    let f1 = judge.spec.spring.spring.surge_frequency();
    let period = 1.0 / f1;
    let readout = &sensor.readout;
    let with = |change: &dyn Fn(&mut SensorSpec)| {
        let mut changed = sensor.clone();
        change(&mut changed);
        changed
    };
    let mut each = Vec::new();
    match sensor.quantity {
        Quantity::Force(End::One) => {
            each.push(("its place at end 2".to_owned(), with(&|s| s.quantity = Quantity::Force(End::Two))));
        }
        Quantity::Force(End::Two) => {
            each.push(("its place at end 1".to_owned(), with(&|s| s.quantity = Quantity::Force(End::One))));
        }
        Quantity::TwoEncoder { compliance, .. } => {
            let quantity = Quantity::TwoEncoder { compliance, backlash: 0.0 };
            each.push(("a drive train without backlash".to_owned(), with(&|s| s.quantity = quantity)));
            let quantity = Quantity::TwoEncoder { compliance: 0.0, backlash: 0.0 };
            each.push(("encoders on the spring's own ends".to_owned(), with(&|s| s.quantity = quantity)));
        }
        _ => {}
    }
    if readout.averaging.is_none_or(|window| window < period) {
        let change = format!("a mean over one surge period, {:.1} ms", 1e3 * period);
        each.push((change, with(&|s| s.readout.averaging = Some(period))));
    }
    if readout.bandwidth.is_none_or(|bandwidth| bandwidth > 0.5 * f1) {
        let change = format!("a low-pass at half the surge frequency, {:.0} Hz", 0.5 * f1);
        each.push((change, with(&|s| (s.readout.bandwidth, s.readout.order) = (Some(0.5 * f1), 2))));
    }
    if let Some(bandwidth) = readout.bandwidth {
        let change = format!("a bandwidth of {:.0} Hz", 4.0 * bandwidth);
        each.push((change, with(&|s| s.readout.bandwidth = Some(4.0 * bandwidth))));
    }
    if let Some(rate) = readout.sample_rate {
        let change = format!("a sample rate of {:.0} Hz", 10.0 * rate);
        each.push((change, with(&|s| s.readout.sample_rate = Some(10.0 * rate))));
    }
    if let Some(window) = readout.averaging {
        let change = format!("an averaging window of {:.1} ms", 100.0 * window);
        each.push((change, with(&|s| s.readout.averaging = Some(0.1 * window))));
    }
    if readout.delay > 0.0 {
        each.push(("no dead time".to_owned(), with(&|s| s.readout.delay = 0.0)));
    }
    each
}

/// The largest line of the budget beside the oscillation, made as small as the goal needs it, where that can be.
fn better(sensor: &SensorSpec, verdict: &Verdict, goal: f64) -> Option<(String, SensorSpec)> {
    let budget = &verdict.budget.budget;
    let lines = budget.contributions().iter().filter(|line| line.name != "oscillation");
    let largest = lines.max_by(|a, b| a.contribution.total_cmp(&b.contribution))?;
    let others = budget.combined().powi(2) - largest.contribution.powi(2);
    let room = goal * goal - others;
    if room <= 0.0 {
        return None;
    }
    // A little less than what just meets the goal.
    let share = 0.98 * room.sqrt() / largest.contribution;
    if !(LEAST_SHARE..1.0).contains(&share) {
        return None;
    }
    let mut changed = sensor.clone();
    let percent = |value: f64| format!("{:.2} %", 100.0 * value);
    let change = match largest.name.as_ref() {
        "sensor: accuracy of full scale" => {
            changed.accuracy_full_scale *= share;
            format!("an accuracy of {} of full scale", percent(changed.accuracy_full_scale))
        }
        "sensor: accuracy of reading" => {
            changed.accuracy_reading *= share;
            format!("an accuracy of {} of the reading", percent(changed.accuracy_reading))
        }
        "calibration" => {
            changed.calibration_uncertainty *= share;
            format!("a gain calibrated to {}", percent(changed.calibration_uncertainty))
        }
        "sensor: noise" => {
            changed.readout.noise *= share;
            format!("noise of {} of full scale", percent(changed.readout.noise / changed.range))
        }
        "sensor: resolution" => {
            changed.readout.resolution = changed.readout.resolution.map(|step| step * share);
            format!("{:.1} times its resolution", 1.0 / share)
        }
        "calibration form: measured springs" => {
            let Quantity::Inductance { uncalibrated, form } = sensor.quantity else { return None };
            let form = share * form;
            changed.quantity = Quantity::Inductance { uncalibrated, form };
            format!("a calibration that fits within {} of the travel", percent(form))
        }
        _ => return None,
    };
    Some((change, changed))
}
