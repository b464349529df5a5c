//! A spec worked off: every condition under every damping, every sensor judged, what breaks the goal and what would meet it.
//!
//! ```text
//! Spec ─► Case (condition × damping) ─► Verdict per sensor ─► answer, warnings ─► report
//! ```
//!
//! **What counts as error** is the force a sensor tells less the true force *at the same instant*. A reading that comes late is off where the
//! force moves, by its lag times the force's rate, and nothing is shifted in time to make it look better: a controller has no such shift.
//!
//! Next door: what a spec says (`spec`), how an analysis is shown (`report`).

mod answer;
mod assessed;
mod band;
mod budget;
mod case;
mod fix;
mod frames;
mod instrument;
mod single;
mod tighter;
mod verdict;
mod warnings;

pub use answer::answer;
pub(crate) use assessed::{Assessed, assess};
pub use budget::SensorBudget;
pub use case::{Case, Reading};
pub use fix::Fix;
pub use frames::Frames;
pub use instrument::Instrument;
pub use single::Single;
pub use verdict::Verdict;
pub use warnings::{Subject, Warning};

use std::sync::atomic::{AtomicUsize, Ordering};

use coilsense::Error;
use coilsense::inductance::MaxwellSum;
use rayon::prelude::*;

use crate::data_sheet::DataSheet;
use crate::spec::{Quantity, SensorSpec, Spec};

/// Why an analysis did not come to its end.
#[derive(Debug, thiserror::Error)]
pub enum AnalysisError {
    /// The spec has nothing to work off.
    #[error("{0}: no [[condition]] says what is done to the spring; give at least one")]
    NoCondition(String),
    /// A condition or a damping that the spec does not have.
    #[error("{0}")]
    NoSuchCase(String),
    /// The science refuses.
    #[error("{place}: {reason}")]
    Case {
        /// The spec's file, the condition's name and the damping.
        place: String,
        /// What the science says.
        reason: Box<Error>,
    },
    /// The science refuses outside of any case.
    #[error("{0}")]
    Science(#[from] Error),
    /// Somebody stopped it.
    #[error("interrupted; nothing was written")]
    Interrupted,
}

/// Told how much is done, and of how much; whether to go on.
pub type Progress<'a> = dyn Fn(usize, usize) -> bool + Sync + 'a;

/// A spec, worked off.
#[derive(Debug, Clone)]
pub struct Analysis {
    /// What was asked.
    pub spec: Spec,
    /// The sensors that were judged: the spec's, or perfect ones where it has none.
    pub sensors: Vec<SensorSpec>,
    /// Every condition under every damping, condition by condition.
    pub cases: Vec<Case>,
    /// The sensors, best first.
    pub verdicts: Vec<Verdict>,
    /// What a reader must know before using the numbers.
    pub warnings: Vec<Warning>,
    /// What follows from the spring alone.
    pub data_sheet: DataSheet,
}

/// Simulates every condition under every damping.
///
/// # Errors
/// [`AnalysisError`] for a spec without conditions, the first case that the science refuses, or where `progress` says stop.
pub fn simulate(spec: &Spec, progress: &Progress<'_>) -> Result<Vec<Case>, AnalysisError> {
    simulate_watched(spec, &spec.sensors, progress)
}

fn simulate_watched(spec: &Spec, sensors: &[SensorSpec], progress: &Progress<'_>) -> Result<Vec<Case>, AnalysisError> {
    if spec.conditions.is_empty() {
        return Err(AnalysisError::NoCondition(spec.file.clone()));
    }
    let coil = MaxwellSum::new(&spec.spring.spring, spec.spring.self_distance);
    let dampings = spec.mount.cases.len();
    let count = spec.conditions.len() * dampings;
    let done = AtomicUsize::new(0);
    if !progress(0, count) {
        return Err(AnalysisError::Interrupted);
    }
    let one = |index: usize| {
        let (condition, damping) = (index / dampings, index % dampings);
        if !progress(done.load(Ordering::Relaxed), count) {
            return Err(AnalysisError::Interrupted);
        }
        let case = run_case(spec, sensors, &coil, condition, damping)?;
        match progress(done.fetch_add(1, Ordering::Relaxed) + 1, count) {
            true => Ok(case),
            false => Err(AnalysisError::Interrupted),
        }
    };
    (0..count).into_par_iter().map(one).collect()
}

/// Numbers of a condition and a damping that the spec has.
fn check_case(spec: &Spec, condition: usize, damping: usize) -> Result<(), AnalysisError> {
    if spec.conditions.is_empty() {
        return Err(AnalysisError::NoCondition(spec.file.clone()));
    }
    for (what, number, count) in
        [("condition", condition, spec.conditions.len()), ("damping", damping, spec.mount.cases.len())]
    {
        if number >= count {
            let text = format!("{}: {what} {number}: must be below {count}, counted from 0", spec.file);
            return Err(AnalysisError::NoSuchCase(text));
        }
    }
    Ok(())
}

/// A case, or where it went wrong.
fn run_case(
    spec: &Spec,
    sensors: &[SensorSpec],
    coil: &MaxwellSum,
    condition: usize,
    damping: usize,
) -> Result<Case, AnalysisError> {
    Case::run(spec, sensors, coil, condition, damping).map_err(|reason| refused(spec, condition, damping, reason))
}

/// What the science refuses, and where.
fn refused(spec: &Spec, condition: usize, damping: usize, reason: Error) -> AnalysisError {
    let (condition, damping) = (&spec.conditions[condition].name, &spec.mount.cases[damping].label);
    let place = format!("{}: {condition}, {damping}", spec.file);
    AnalysisError::Case { place, reason: Box::new(reason) }
}

/// The spec's sensors, or perfect ones where it has none.
fn judged_sensors(spec: &Spec) -> Vec<SensorSpec> {
    if spec.sensors.is_empty() { perfect_sensors(spec) } else { spec.sensors.clone() }
}

impl Analysis {
    /// Works off a spec.
    ///
    /// # Errors
    /// As [`simulate`].
    pub fn run(spec: Spec, progress: &Progress<'_>) -> Result<Self, AnalysisError> {
        let sensors = judged_sensors(&spec);
        let cases = simulate_watched(&spec, &sensors, progress)?;
        let coil = MaxwellSum::new(&spec.spring.spring, spec.spring.self_distance);
        let judge = verdict::Judge { spec: &spec, coil: &coil, cases: &cases };
        let mut verdicts: Vec<Verdict> = (0..sensors.len())
            .into_par_iter()
            .map(|index| match progress(cases.len(), cases.len()) {
                true => Ok(judge.verdict(index, &sensors[index])?),
                false => Err(AnalysisError::Interrupted),
            })
            .collect::<Result<_, AnalysisError>>()?;
        verdicts.sort_by(|a, b| a.combined().total_cmp(&b.combined()));
        let data_sheet = DataSheet::of(&spec)?;
        let warnings = warnings::of(&judge, &sensors, &data_sheet)?;
        Ok(Self { spec, sensors, cases, verdicts, warnings, data_sheet })
    }

    /// The conditions' case under a damping.
    pub fn case(&self, condition: usize, damping: usize) -> Option<&Case> {
        self.cases.get(condition * self.spec.mount.cases.len() + damping)
    }
}

/// The paper's sensors, without any limits of their own: what the spring alone does to a force.
fn perfect_sensors(spec: &Spec) -> Vec<SensorSpec> {
    let nominal = spec.spring.spring.nominal_force();
    let load_cell = |end, name| SensorSpec::perfect(name, Quantity::Force(end), nominal);
    let coil = Quantity::Inductance { uncalibrated: false, form: 0.0 };
    let (shortest, longest) = spec.spring.spring.operating_range();
    vec![
        load_cell(coilsense::End::One, "perfect load cell, end 1"),
        load_cell(coilsense::End::Two, "perfect load cell, end 2"),
        SensorSpec::perfect("perfect deflection sensor", Quantity::Deflection, longest - shortest),
        SensorSpec::perfect("perfect inductance meter", coil, 1.0),
    ]
}
