//! A spec processed: every condition under every damping, every sensor judged, what breaks the goal and what would meet it.
//!
//! ```text
//! Spec ─► Case (condition × damping) ─┬────────────────────────► Verdict per sensor ─► answer, warnings ─► report
//!         on the nominal spring       └─► Responses: how each sensor's error moves with the spring's frequencies
//!                                         Specimens: springs that the tolerances allow
//! ```
//!
//! **Over which springs.** A tolerance of k or m moves every resonance, and a chain of masses is not a coil: what is said of a sensor is said
//! over all springs that tolerances and that doubt allow, their rms, the share of them inside the goal, the worst, and the nominal one.
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
mod change;
mod check;
mod curve;
mod doubts;
mod fix;
mod frames;
mod judge;
mod magnetisation;
mod met;
mod moments;
mod overload;
mod prepared;
mod rank;
mod refinement;
mod resonance;
mod response;
mod single;
mod sooner;
mod specimen;
mod spread;
mod tighter;
mod together;
#[cfg(test)]
mod toy_sensor;
mod trial;
mod trial_run;
mod under_way;
mod verdict;
mod warnings;
mod ways;
mod words;

pub use answer::{answer, changes_that_meet};
pub(crate) use assessed::{Assessed, assess};
pub use budget::SensorBudget;
pub use case::{Case, Reading};
pub use change::Fix;
pub use check::Check;
pub use frames::Frames;
pub use resonance::{driven, is_broad};
pub use single::Single;
pub use together::{Strand, Together};
pub use under_way::{Concluded, Earlier, UnderWay};
pub use verdict::{Assessment, GoalFilter, Sooner, Verdict};
pub use warnings::{Subject, Warning, of_simulated as warnings_of_simulated};
pub(crate) use words::several;

use std::sync::atomic::{AtomicUsize, Ordering};

use coilsense::Error;
use rayon::prelude::*;

use crate::data_sheet::DataSheet;
use crate::spec::{Quantity, SensorSpec, Spec, SpecError, SpringInductance};
use crate::study::{self, Helices, Masses};
use prepared::{Prepared, go_on};

/// Why an analysis did not come to its end.
#[derive(Debug, thiserror::Error)]
pub enum AnalysisError {
    /// The spec has nothing to process.
    #[error("{0}: no [[condition]] says what is done to the spring; give at least one")]
    NoCondition(String),
    /// A condition or a damping that the spec does not have.
    #[error("{0}")]
    NoSuchCase(String),
    /// What the spec says is not for this.
    #[error(transparent)]
    Spec(#[from] SpecError),
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

/// A spec, processed.
#[derive(Debug, Clone)]
pub struct Analysis {
    /// What was asked.
    pub spec: Spec,
    /// The sensors that were judged: the spec's, or perfect ones where it has none.
    pub sensors: Vec<SensorSpec>,
    /// Every condition under every damping, condition by condition.
    pub cases: Vec<Case>,
    /// The sensors, best first: those that meet the goal, of those the ones whose limits of error are told, of those the least uncertain.
    pub verdicts: Vec<Verdict>,
    /// What a reader must know before using the numbers.
    pub warnings: Vec<Warning>,
    /// What follows from the spring alone.
    pub data_sheet: DataSheet,
    /// How many masses stand for a winding.
    pub masses: Masses,
    /// Of a spec that is silent on how far the stiffness may be off: the same question with [`USUAL_TOLERANCE`].
    pub if_usual: Option<IfUsual>,
    /// Of a helix: the largest combined standard uncertainty of each sensor if the coil's chain moved in its place, in the sensors' order \[N\].
    pub as_chain: Option<Vec<f64>>,
}

/// How far the rate of a bought spring is off, where nobody says: 5 to 10 % by the standards for wound springs.
pub const USUAL_TOLERANCE: f64 = 0.05;

/// What would be so if the stiffness had the usual tolerance.
#[derive(Debug, Clone, PartialEq)]
pub struct IfUsual {
    /// The sensors' numbers, best first.
    pub order: Vec<usize>,
    /// The largest combined standard uncertainty of each sensor, in the sensors' order \[N\].
    pub combined: Vec<f64>,
}

/// Simulates every condition under every damping.
///
/// # Errors
/// [`AnalysisError`] for a spec without conditions or of several springs ([`Together`] takes those), the first case that the science refuses, or where
/// `progress` says stop.
pub fn simulate(spec: &Spec, progress: &Progress<'_>) -> Result<Vec<Case>, AnalysisError> {
    spec.needs_one_spring("a case of its own")?;
    simulate_alone(spec, progress)
}

fn simulate_alone(spec: &Spec, progress: &Progress<'_>) -> Result<Vec<Case>, AnalysisError> {
    let mut spec = spec.clone();
    prepare(&mut spec)?;
    let coil = SpringInductance::of(&spec.spring)?;
    simulate_watched(&spec, &spec.sensors, &coil, &helices(&spec)?, progress)
}

fn simulate_watched(
    spec: &Spec,
    sensors: &[SensorSpec],
    coil: &SpringInductance,
    helices: &Helices,
    progress: &Progress<'_>,
) -> Result<Vec<Case>, AnalysisError> {
    if spec.conditions.is_empty() {
        return Err(AnalysisError::NoCondition(spec.file.clone()));
    }
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
        let case = run_case(spec, sensors, coil, helices, (condition, damping))?;
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
    coil: &SpringInductance,
    helices: &Helices,
    (condition, damping): (usize, usize),
) -> Result<Case, AnalysisError> {
    let case = Case::run(spec, sensors, coil, helices, (condition, damping));
    case.map_err(|reason| refused(spec, condition, damping, reason))
}

/// The helices of a prepared spec.
fn helices(spec: &Spec) -> Result<Helices, AnalysisError> {
    Helices::of(spec).map_err(|(condition, damping, reason)| refused(spec, condition, damping, reason))
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

/// Gives a spec's spring as many masses as its figures need.
///
/// # Errors
/// As [`study::enough_masses`].
pub(crate) fn prepare(spec: &mut Spec) -> Result<Masses, Error> {
    spec.spring.look_up_surges(&spec.mount.ends);
    study::prepare(&mut spec.spring, &mut spec.mount, &spec.conditions)
}

impl Analysis {
    /// Processes a spec.
    ///
    /// # Errors
    /// As [`simulate`].
    pub fn run(spec: Spec, progress: &Progress<'_>) -> Result<Self, AnalysisError> {
        let prepared = Prepared::of(spec, progress)?;
        let cases = prepared.cases(progress)?;
        let count = cases.len();
        let each = cases.par_iter().map(|case| {
            go_on(progress, count)?;
            prepared.responses(case)
        });
        let responses = each.collect::<Result<Vec<_>, AnalysisError>>()?;
        prepared.conclude(cases, responses, progress)
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
    let coil = Quantity::Inductance {
        uncalibrated: false,
        form: 0.0,
        form_by: coilsense::sensors::FormBy::Measured,
        remounting: 0.0,
    };
    let (shortest, longest) = spec.spring.spring.operating_range();
    let mut sensors = vec![
        load_cell(coilsense::End::One, "perfect load cell, end 1"),
        load_cell(coilsense::End::Two, "perfect load cell, end 2"),
        SensorSpec::perfect("perfect deflection sensor", Quantity::Deflection, longest - shortest),
    ];
    // The inductance of a single winding does not tell its length.
    let sum = SpringInductance::Air(spec.spring.inductance_in_air());
    let length = spec.spring.spring.mid_length();
    if study::Coil::of(&spec.spring.spring, &sum, length, study::Method::Exact).is_ok() {
        sensors.push(SensorSpec::perfect("perfect inductance meter", coil, 1.0));
    }
    sensors
}
