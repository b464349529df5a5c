//! What would fix a sensor that misses the goal: each change is tried on the same motions.
//!
//! Next door: lines of the budget that would have to shrink (`tighter`), how a sensor is judged (`verdict`).

use coilsense::Error;
use coilsense::sensors::ReadoutParameters;

use super::change::{Change, Fix, written};
use super::judge::Judge;
use super::specimen::{MANY, Springs};
use super::tighter;
use super::verdict::Verdict;
use crate::quantity::Dimension;
use crate::quantity::digits;
use crate::spec::SensorSpec;

/// Most changes that are named.
const MOST_NAMED: usize = 3;

/// Single changes with which a sensor meets the goal under every damping, the quickest first.
pub(super) fn of(judge: &Judge<'_>, sensor: &SensorSpec, verdict: &Verdict) -> Result<Vec<Fix>, Error> {
    let Some(goal) = judge.spec.goal.error else { return Ok(Vec::new()) };
    let fewer = Springs::of(judge.spec, &judge.spec.spring.tolerances, MANY);
    let mut fixes = Vec::new();
    let changes = candidates(judge, sensor).into_iter().chain(tighter::all(judge.spec, sensor, verdict, goal));
    for Change { words, sensor, spec } in changes {
        let springs = spec.as_ref().map(|spec| Springs::of(spec, &spec.spring.tolerances, MANY));
        let springs = springs.as_ref().unwrap_or(&fewer);
        let trial = Judge { spec: spec.as_ref().unwrap_or(judge.spec), springs, ..*judge }.trial(&sensor)?;
        if let Some(trial) = trial {
            fixes.push(Fix { change: words, combined: trial.combined, lag: trial.lag });
        }
    }
    fixes.sort_by(|a, b| a.lag.total_cmp(&b.lag));
    fixes.truncate(MOST_NAMED);
    Ok(fixes)
}

/// Changes of place and of dynamics.
fn candidates(judge: &Judge<'_>, sensor: &SensorSpec) -> Vec<Change> {
    let mut changes = of_place(sensor);
    let f1 = judge.spec.spring.spring.surge_frequency();
    let readout = &sensor.readout;
    let mut add = |words: &str, made: Option<(f64, String)>, change: &dyn Fn(&mut ReadoutParameters, f64)| {
        if let Some((value, text)) = made {
            let mut sensor = sensor.clone();
            change(&mut sensor.readout, value);
            changes.push(Change { words: format!("{words}{text}"), sensor, spec: None });
        }
    };
    let time = |seconds: f64| written(Dimension::Time, format!("{} ms", digits(1e3 * seconds)));
    let hertz = |frequency: f64| written(Dimension::Frequency, format!("{} Hz", digits(frequency)));
    if readout.averaging.is_none_or(|window| window < 0.999 / f1) {
        add("a mean over one surge period, ", time(1.0 / f1), &|r, window| r.averaging = Some(window));
    }
    if readout.bandwidth.is_none_or(|bandwidth| bandwidth > 0.5 * f1) {
        let low_pass = |r: &mut ReadoutParameters, cutoff| (r.bandwidth, r.order) = (Some(cutoff), 2);
        add("a low-pass at half the surge frequency, ", hertz(0.5 * f1), &low_pass);
    }
    let wider = readout.bandwidth.and_then(|bandwidth| hertz(4.0 * bandwidth));
    add("a bandwidth of ", wider, &|r, bandwidth| r.bandwidth = Some(bandwidth));
    let faster = readout.sample_rate.and_then(|rate| hertz(10.0 * rate));
    add("a sample rate of ", faster, &|r, rate| r.sample_rate = Some(rate));
    let shorter = readout.averaging.and_then(|window| time(0.1 * window));
    add("an averaging window of ", shorter, &|r, window| r.averaging = Some(window));
    if readout.delay > 0.0 {
        add("no dead time", Some((0.0, String::new())), &|r, delay| r.delay = delay);
    }
    changes
}

/// Another place of the same instrument.
fn of_place(sensor: &SensorSpec) -> Vec<Change> {
    let at = |(words, quantity): (&str, _)| Change {
        words: words.to_owned(),
        sensor: SensorSpec { quantity, ..sensor.clone() },
        spec: None,
    };
    sensor.quantity.alternatives().into_iter().map(at).collect()
}
