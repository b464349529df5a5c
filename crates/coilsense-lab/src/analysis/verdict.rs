//! What is said of a sensor over all cases.
//!
//! Next door: how it is found (`judge`), what makes a force uncertain (`budget`), what would help (`fix`).

use super::budget::SensorBudget;
use super::change::Fix;
use crate::spec::Spec;

/// What the analysis says of one sensor.
#[derive(Debug, Clone)]
pub struct Verdict {
    /// Number of the sensor among [`super::Analysis::sensors`].
    pub sensor: usize,
    /// One per case.
    pub assessments: Vec<Assessment>,
    /// Number of the case with the largest combined uncertainty, the first of them where several are alike.
    pub worst: usize,
    /// The budget of that case.
    pub budget: SensorBudget,
    /// For each damping, whether all conditions meet the goal; empty without a goal.
    pub meets: Vec<bool>,
    /// Where the sensor's own answer has fallen by 3 dB \[Hz\]; infinite for one without limits.
    pub bandwidth: f64,
    /// How much later the force comes at the wanted bandwidth, or slowly where none is wanted, behind the filter if it needs one \[s\].
    pub lag: f64,
    /// The low-pass without which the sensor does not meet a goal with a bandwidth; `None` where it needs none.
    pub filter: Option<GoalFilter>,
    /// Whether the sensor does not reach the wanted bandwidth.
    pub too_slow: bool,
    /// What a load cell sees at most, where that is beyond its full scale \[N\]: it does not meet a goal that it cannot read.
    pub overload: Option<f64>,
    /// Whether a limit of error of it is told; without one its uncertainty is the least that it errs by.
    pub has_limits: bool,
    /// What comes before the judged part of a case, where that is louder.
    pub sooner: Option<Sooner>,
    /// Whether most of the oscillation in the worst case is what its own delay, averaging and filter make of the motion.
    pub by_readout: bool,
    /// Single changes with which it meets the goal, the quickest first.
    pub fixes: Vec<Fix>,
}

/// A sensor in a case.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct Assessment {
    /// Rms deviation from the true force at the same instant within the wanted bandwidth, without noise and resolution \[N\]: surge,
    /// and the lag behind a moving force; on the nominal spring.
    #[serde(rename = "oscillation_in_band_n")]
    pub oscillation: f64,
    /// The same over the springs that the tolerances allow \[N\].
    #[serde(rename = "oscillation_over_specimens_n")]
    pub over_specimens: f64,
    /// The same on the spring on which it is largest \[N\].
    #[serde(rename = "oscillation_of_loudest_specimen_n")]
    pub loudest: f64,
    /// Combined standard uncertainty over them, with the bias that stays uncorrected \[N\].
    #[serde(rename = "combined_n")]
    pub combined: f64,
    /// Of the nominal spring: its oscillation and the instrument's own errors \[N\].
    #[serde(rename = "nominal_n")]
    pub nominal: f64,
    /// The same with errors of every frequency, where the goal has a bandwidth \[N\].
    #[serde(rename = "every_frequency_n")]
    pub raw: f64,
    /// Share of the specimens whose rms error meets the goal \[1\]; `None` without a goal, and where it was not asked for.
    #[serde(rename = "share_inside_goal")]
    pub inside: Option<f64>,
    /// Rms error of the worst specimen that was drawn \[N\].
    #[serde(rename = "worst_specimen_n")]
    pub worst: f64,
}

/// A sensor in a part that the window leaves out, after a stop, a step, a ramp or a pulse, in a sweep or a recording.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sooner {
    /// Number of the case.
    pub case: usize,
    /// From the event on, at most as long as the judged part \[s\].
    pub window: (f64, f64),
    /// Rms error there on the nominal spring, that of the instrument included \[N\].
    pub error: f64,
}

/// What makes a goal with a bandwidth true: errors above it count for nothing only behind a low-pass there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GoalFilter {
    /// Where it has lost 3 dB \[Hz\].
    pub bandwidth: f64,
    /// Its order, a Butterworth.
    pub order: usize,
    /// How much later a slow force comes behind it \[s\].
    pub lag: f64,
    /// Rms error without it in the case where it is largest \[N\].
    pub raw: f64,
    /// Number of that case.
    pub case: usize,
}

/// Share of the goal, and of F_nom where there is none, below which an error decides nothing.
const LEAST: (f64, f64) = (0.1, 1e-4);

/// Whether an error \[N\] is large enough to be spoken of beside the goal.
pub(super) fn matters(spec: &Spec, error: f64) -> bool {
    let least = spec.goal.error.map_or(LEAST.1 * spec.spring.spring.nominal_force(), |goal| LEAST.0 * goal);
    error > least
}

impl Verdict {
    /// The assessment of the worst case.
    pub fn at_worst(&self) -> &Assessment {
        &self.assessments[self.worst]
    }

    /// The smallest share of specimens inside the goal over all cases.
    pub fn least_inside(&self) -> Option<f64> {
        self.assessments.iter().filter_map(|assessment| assessment.inside).min_by(f64::total_cmp)
    }

    /// The combined standard uncertainty of the worst case \[N\].
    pub fn combined(&self) -> f64 {
        self.assessments[self.worst].combined
    }

    /// Whether it meets the goal under every damping; `None` without a goal.
    pub fn meets_always(&self) -> Option<bool> {
        let reads = !self.too_slow && self.overload.is_none();
        if self.meets.is_empty() { None } else { Some(reads && self.meets.iter().all(|meets| *meets)) }
    }
}
