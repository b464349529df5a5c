//! Sensors judged and nothing else: what a sweep asks of a design. Only the signals that those sensors read are computed.
//!
//! Next door: how a sensor is judged in a case (`verdict`), the whole analysis (the parent).

use coilsense::Error;
use coilsense::sensors::{Instrument, Readout};
use coilsense::signals::sampled_window;

use super::band::judged;
use super::case::Scene;
use super::judge::{Counted, Judge, Over};
use super::moments::Moments;
use super::overload::full_scale;
use super::specimen::{MANY, Springs};
use super::trial_run::needs_coil;
use super::{AnalysisError, band, refused};
use crate::spec::{SensorSpec, Spec, SpringInductance};
use crate::study::{self, Coil, Helices, Meets, Method, Setup, Simulation};

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
    // Said in the sweep's notes.
    let coil = SpringInductance::Air(spec.spring.inductance_in_air());
    let springs = Springs::of(spec, &spec.spring.tolerances, MANY);
    // A sweep takes no helix.
    let helices = Helices::default();
    let judge = Judge { spec, coil: &coil, helices: &helices, cases: &[], springs: &springs };
    let sensors: Vec<(usize, &SensorSpec)> =
        wanted.iter().filter_map(|&index| Some((index, spec.sensors.get(index)?))).collect();
    let mut largest = vec![[f64::NEG_INFINITY; 3]; sensors.len()];
    for condition in 0..spec.conditions.len() {
        for damping in 0..spec.mount.cases.len() {
            let seen = seen(&judge, &sensors, (condition, damping));
            let seen = seen.map_err(|reason| refused(spec, condition, damping, reason))?;
            for (largest, own) in largest.iter_mut().zip(seen) {
                *largest = [0, 1, 2].map(|which| largest[which].max(own[which]));
            }
        }
    }
    let of_all = |((index, sensor), [combined, raw, most]): ((usize, &SensorSpec), [f64; 3])| {
        let readout = Readout::new(sensor.readout.clone())?;
        let bandwidth = spec.goal.bandwidth;
        let reaches = bandwidth.is_none_or(|bandwidth| readout.bandwidth_3db() >= bandwidth);
        let reads = reaches && most <= full_scale(sensor);
        let meets = spec.goal.error.map(|goal| reads && combined <= goal);
        let behind = if spec.goal.error.is_some_and(|goal| raw > goal) { band::lag(bandwidth) } else { 0.0 };
        Ok((index, Assessed { combined, meets, lag: readout.lag(bandwidth.unwrap_or(0.0)) + behind }))
    };
    sensors.into_iter().zip(largest).map(of_all).collect()
}

/// Combined standard uncertainties of sensors in one condition under one damping, their errors at every frequency, and the most that they tell \[N\].
fn seen(
    judge: &Judge<'_>,
    sensors: &[(usize, &SensorSpec)],
    (condition, damping): (usize, usize),
) -> Result<Vec<[f64; 3]>, Error> {
    let spec = judge.spec;
    let asked = &spec.conditions[condition];
    let times = sampled_window(asked.sample_rate, 0.0, asked.duration)?;
    let each: Vec<&SensorSpec> = sensors.iter().map(|(_, sensor)| *sensor).collect();
    let mean_length = asked.excitation.mean_length();
    let coil = match needs_coil(spec, &each) {
        true => Some(Coil::of(&spec.spring.spring, judge.coil, mean_length, Method::Exact)?),
        false => None,
    };
    let (spring, way) = (&spec.spring.spring, &spec.mount.cases[damping]);
    let contact = way.contact.as_ref().map(|way| Meets { contact: &way.contact, apart: None });
    let (mount, excitation) = (&way.mount, &asked.excitation);
    let setup = Setup { spring, mount, excitation, coil, positions: false, helix: None, contact };
    let Simulation { signals, seen, .. } = study::simulate(&setup, &times)?;
    let judged = judged(&times, asked.window);
    let scene_of = |sensor: &SensorSpec| {
        let (signals, seen) = (seen.truth(&signals, &spec.goal), seen.by(&signals, sensor, &spec.goal));
        Scene { condition, signals, seen, judged: &judged, inductance_doubt: 0.0 }
    };
    let ready = |sensor: &&SensorSpec| {
        let instrument = judge.instrument(sensor, condition)?;
        let scene = scene_of(sensor);
        let forces = instrument.forces(&instrument.steady_readings(scene.seen)?);
        let most = forces.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
        let counted = judge.counted(scene, &forces)?;
        let known = (judge.beside(sensor, &instrument, scene)?, Moments::of(&counted.errors));
        Ok(((instrument, counted, most), known))
    };
    let ready = each.iter().map(ready).collect::<Result<Vec<_>, Error>>()?;
    let (ready, known): (Vec<_>, Vec<_>) = ready.into_iter().unzip();
    let responses = judge.responses((condition, damping), &each, &known, &judge.springs.specimens)?;
    let of = |(number, (instrument, counted, most)): (usize, (Instrument, Counted, f64))| {
        let over = Over { responses: &responses, sensor: number };
        let assessment = judge.assessment(each[number], &instrument, scene_of(each[number]), counted, Some(over))?;
        Ok([assessment.combined, assessment.raw, most])
    };
    ready.into_iter().enumerate().map(of).collect()
}
