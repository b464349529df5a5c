//! Sensors judged and nothing else: what a sweep asks of a design. Only the signals that those sensors read are computed.
//!
//! Next door: how a sensor is judged in a case (`verdict`), the whole analysis (the parent).

use coilsense::inductance::MaxwellSum;
use coilsense::sensors::Readout;
use coilsense::signals::sampled_window;
use coilsense::{Calibration, Channel, Error, InductanceSensor, Motion, Signals};

use super::case::judged;
use super::verdict::{Judge, Scene};
use super::{AnalysisError, refused};
use crate::spec::{Quantity, SensorSpec, Spec};

/// A sensor in a word or three.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Assessed {
    /// The largest combined standard uncertainty \[N\].
    pub combined: f64,
    /// Whether it meets the goal; `None` without one.
    pub meets: Option<bool>,
    /// How much later the force comes \[s\].
    pub lag: f64,
}

/// Those sensors of a spec that are `wanted`, by their numbers; the same numbers as those of [`super::Analysis::run`].
///
/// # Errors
/// [`AnalysisError`] for a spec without conditions, and for what the science refuses.
pub(crate) fn assess(spec: &Spec, wanted: &[usize]) -> Result<Vec<(usize, Assessed)>, AnalysisError> {
    if spec.conditions.is_empty() {
        return Err(AnalysisError::NoCondition(spec.file.clone()));
    }
    let coil = MaxwellSum::new(&spec.spring.spring, spec.spring.self_distance);
    let judge = Judge { spec, coil: &coil, cases: &[] };
    let sensors: Vec<(usize, &SensorSpec)> =
        wanted.iter().filter_map(|&index| Some((index, spec.sensors.get(index)?))).collect();
    let of_coil = |(_, sensor): &(usize, &SensorSpec)| matches!(sensor.quantity, Quantity::Inductance { .. });
    let by_coil = spec.goal.force == Channel::InductanceForce || sensors.iter().any(of_coil);
    let mut largest = vec![f64::NEG_INFINITY; sensors.len()];
    for condition in 0..spec.conditions.len() {
        for damping in 0..spec.mount.cases.len() {
            let seen = seen(&judge, &sensors, by_coil, (condition, damping));
            let seen = seen.map_err(|reason| refused(spec, condition, damping, reason))?;
            for (largest, combined) in
                largest.iter_mut().zip(seen).filter(|(largest, own)| own.total_cmp(largest).is_gt())
            {
                *largest = combined;
            }
        }
    }
    let of_all = |((index, sensor), combined): ((usize, &SensorSpec), f64)| {
        let readout = Readout::new(sensor.readout.clone())?;
        let bandwidth = spec.goal.bandwidth;
        let reaches = bandwidth.is_none_or(|bandwidth| readout.bandwidth_3db() >= bandwidth);
        let meets = spec.goal.error.map(|goal| reaches && combined <= goal);
        Ok((index, Assessed { combined, meets, lag: readout.lag(bandwidth.unwrap_or(0.0)) }))
    };
    sensors.into_iter().zip(largest).map(of_all).collect()
}

/// Combined standard uncertainties of sensors in one condition under one damping \[N\].
fn seen(
    judge: &Judge<'_>,
    sensors: &[(usize, &SensorSpec)],
    by_coil: bool,
    (condition, damping): (usize, usize),
) -> Result<Vec<f64>, Error> {
    let asked = &judge.spec.conditions[condition];
    let times = sampled_window(asked.sample_rate, 0.0, asked.duration)?;
    let motion = Motion::mounted(&judge.spec.spring.spring, &judge.spec.mount.cases[damping].mount, &asked.excitation)?;
    let mut signals = motion.signals(&times)?;
    if by_coil {
        add_inductance(judge, &motion, asked.excitation.mean_length(), &times, &mut signals)?;
    }
    let judged = judged(&times, asked.window);
    let scene = Scene { condition, signals: &signals, judged: &judged };
    let of = |(_, sensor): &(usize, &SensorSpec)| {
        let instrument = judge.instrument(sensor, condition)?;
        let steady = instrument.forces(&instrument.steady_readings(&signals)?);
        Ok(judge.assessment(sensor, &instrument, scene, &steady)?.combined)
    };
    sensors.iter().map(of).collect()
}

/// L by the exact sum, as the analysis has it, and F_L.
fn add_inductance(
    judge: &Judge<'_>,
    motion: &Motion,
    mean_length: f64,
    times: &[f64],
    signals: &mut Signals,
) -> Result<(), Error> {
    let spring = &judge.spec.spring.spring;
    let inductance = judge.coil.series(&motion.windings(times)?);
    let calibration = Calibration::theoretical(spring, judge.coil, mean_length)?;
    signals.insert(Channel::InductanceForce, InductanceSensor::new(spring, calibration).force(&inductance))?;
    signals.insert(Channel::Inductance, inductance)
}
