//! What to do about ringing as `results.json`, and as `coilsense mitigate --json`, Python and the page have it.
//!
//! Next door: the same as text (`text`).

use serde::Serialize;
use serde_json::Value;

use super::shaping::shaping_advice;
use super::text::{advice, notes};
use crate::mitigation::{Candidate, Judgement, LeftOut, Ranking, Shaped, Shaping, Source};
use crate::report::ReportError;
use crate::report::outcome::{Outcome, to_json};

/// Every candidate judged, best first: filters of F_i, then estimators of F_o. A part that was not run is null.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct MitigationOutcome {
    /// What to do, a sentence each.
    advice: Vec<String>,
    /// F_nom.
    nominal_force_n: f64,
    /// How often the controller samples.
    sampling_rate_hz: f64,
    /// Where that is from: words of the spec, or "assumed"; null for what was asked for, and for a log's.
    sampling_rate_from: Option<String>,
    /// White noise of F_i, rms per sample.
    noise_n: f64,
    /// Where that is from, likewise.
    noise_from: Option<String>,
    /// Up to which frequency the force moves by itself.
    bandwidth_hz: f64,
    /// Most lag at the bandwidth that what is advised may have.
    most_lag_rad: f64,
    /// The log that it was judged on; null for conditions.
    log: Option<String>,
    /// Of the log; null for conditions, or where it tells none.
    log_stiffness_n_per_m: Option<f64>,
    /// Half of the interval that holds it with 95 %.
    log_stiffness_n_per_m_half_width: Option<f64>,
    /// Length of the coil where u1 and u2 of the log read zero; null for conditions.
    length_at_zero_m: Option<f64>,
    /// What the log says of its spring, a sentence each.
    notes: Vec<String>,
    /// How many series of noise.
    seeds: u64,
    /// The first one's seed.
    first_seed: u64,
    /// By how much k may be off, as a share.
    stiffness_tolerance: f64,
    /// Where that is from, likewise.
    stiffness_tolerance_from: Option<String>,
    /// By how much m may be off, as a share.
    mass_tolerance: f64,
    /// Where that is from, likewise.
    mass_tolerance_from: Option<String>,
    candidates: Vec<CandidateRow>,
    left_out: Vec<LeftOutRow>,
    /// What shaping the command would do; null where no condition moves u1.
    command_shaping: Option<ShapingPart>,
}

impl Outcome for MitigationOutcome {
    const SCHEMA: &'static str = "coilsense/mitigation/2";
}

/// A filter or an estimator, and how it did. Errors are rms over all samples, conditions and series of noise.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct CandidateRow {
    name: String,
    /// "raw", "textbook" or "fitted".
    origin: &'static str,
    /// The true force that it is held against: "k·Δl" or "F_o".
    against: &'static str,
    /// On the nominal spring.
    rms_error_n: f64,
    /// The largest of a run over the tolerances.
    worst_rms_error_n: f64,
    worst_run: String,
    /// On the nominal spring, the truth shifted by the delay at which it fits best.
    aligned_rms_error_n: f64,
    /// That delay.
    best_fit_delay_s: f64,
    /// Below zero it leads.
    lag_at_bandwidth_rad: f64,
    /// Noise that comes out over noise that goes in, rms.
    noise_gain: f64,
    /// How long after an impact the error stays above a tenth of what the impact makes.
    settling_s: f64,
    /// What a controller takes; null for what is measured as it is.
    settings: Option<Value>,
}

/// A candidate that cannot be, and why.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct LeftOutRow {
    name: String,
    reason: String,
}

/// Shaped commands.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct ShapingPart {
    /// Conditions that move u1.
    conditions: Vec<String>,
    advice: String,
    shapers: Vec<ShaperRow>,
    left_out: Vec<LeftOutRow>,
}

/// What a shaper leaves of ringing, as shares of what the plain command leaves.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct ShaperRow {
    name: &'static str,
    mode_1_left: f64,
    mode_1_left_worst: f64,
    /// On which spring that is.
    worst_case: String,
    modes_2_to_5_left_worst: f64,
    mean_delay_s: f64,
    length_s: f64,
    /// What a controller takes; null for the command as it is.
    settings: Option<Value>,
}

impl MitigationOutcome {
    /// Of a study that was run.
    pub fn of(answer: &Ranking) -> Self {
        let study = &answer.study;
        let from = |source: &Source| source.words().map(str::to_owned);
        let stiffness = study.recorded.as_ref().and_then(|recorded| recorded.stiffness);
        Self {
            advice: advice(answer).lines().map(str::to_owned).collect(),
            nominal_force_n: study.spring.nominal_force(),
            sampling_rate_hz: study.rate,
            sampling_rate_from: from(&study.sources.rate),
            noise_n: study.noise,
            noise_from: from(&study.sources.noise),
            bandwidth_hz: study.bandwidth,
            most_lag_rad: study.most_lag,
            log: study.recorded.as_ref().map(|recorded| recorded.name.clone()),
            log_stiffness_n_per_m: stiffness.map(|stiffness| stiffness.value),
            log_stiffness_n_per_m_half_width: stiffness.map(|stiffness| stiffness.expanded),
            length_at_zero_m: study.recorded.as_ref().map(|recorded| recorded.length_at_zero),
            notes: notes(answer).to_vec(),
            seeds: study.seeds,
            first_seed: study.seed,
            stiffness_tolerance: study.tolerances.stiffness(),
            stiffness_tolerance_from: from(&study.sources.stiffness),
            mass_tolerance: study.tolerances.mass(),
            mass_tolerance_from: from(&study.sources.mass),
            candidates: answer.judged.iter().map(CandidateRow::of).collect(),
            left_out: answer.left_out.iter().map(LeftOutRow::of).collect(),
            command_shaping: answer.shaping.as_ref().map(ShapingPart::of),
        }
    }
}

impl CandidateRow {
    fn of((candidate, judgement): &(Candidate, Judgement)) -> Self {
        Self {
            name: candidate.name.clone(),
            origin: candidate.origin.name(),
            against: candidate.truth.name(),
            rms_error_n: judgement.nominal,
            worst_rms_error_n: judgement.worst,
            worst_run: judgement.worst_run.clone(),
            aligned_rms_error_n: judgement.aligned,
            best_fit_delay_s: judgement.delay,
            lag_at_bandwidth_rad: judgement.lag,
            noise_gain: judgement.noise_gain,
            settling_s: judgement.settling,
            settings: candidate.settings().map(|settings| settings.numbers()),
        }
    }
}

impl LeftOutRow {
    fn of(left_out: &LeftOut) -> Self {
        Self { name: left_out.name.clone(), reason: left_out.reason.clone() }
    }
}

impl ShapingPart {
    fn of(shaping: &Shaping) -> Self {
        Self {
            conditions: shaping.conditions.clone(),
            advice: shaping_advice(shaping),
            shapers: shaping.shapers.iter().map(ShaperRow::of).collect(),
            left_out: shaping.left_out.iter().map(LeftOutRow::of).collect(),
        }
    }
}

impl ShaperRow {
    fn of(shaped: &Shaped) -> Self {
        Self {
            name: shaped.name,
            mode_1_left: shaped.first,
            mode_1_left_worst: shaped.first_worst,
            worst_case: shaped.worst_case.clone(),
            modes_2_to_5_left_worst: shaped.higher_worst,
            mean_delay_s: shaped.delay,
            length_s: shaped.length,
            settings: shaped.settings().map(|settings| settings.numbers()),
        }
    }
}

/// Everything as JSON, in SI units.
///
/// # Errors
/// [`ReportError::Json`].
pub fn mitigation_json(answer: &Ranking) -> Result<String, ReportError> {
    Ok(to_json(MitigationOutcome::of(answer))?)
}
