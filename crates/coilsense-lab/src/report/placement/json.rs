//! A placement for machines: SI, one key per number.
//!
//! Next door: the same for people (`text`, `html`).

use serde::Serialize;

use crate::placement::{Assessment, Candidate, Estimated, FOLLOWS, LoopRun, MOST_PEAK, Placement, answer, drive_words};
use crate::report::outcome::{Outcome, to_json};
use crate::spec::DampingCase;

/// Which force to feed back, and how fast the loop may be; null stands for what is without bound.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct PlacementOutcome<'a> {
    /// The answer, a sentence each.
    answer: Vec<String>,
    /// The force to feed back.
    feed_back: &'static str,
    /// The same if there were no other spring than the nominal one.
    nominal_feed_back: &'static str,
    /// How far k is off on the springs on which all is judged, either way.
    stiffness_tolerance_percent: f64,
    /// How far their first surge frequency is off, the others in proportion, by the tolerances and as the model leaves it open.
    surge_tolerance_percent: f64,
    /// Of the loop as it is set, with a spring without mass.
    crossover_hz: f64,
    /// With the loop as set on the nominal spring: F_o over a slow reference, and up to where it stays within 3 dB of the reference, the least of all
    /// dampings; null where that loop is unstable, the second also where it does not follow a slow reference or nothing up to the fourth surge line ends it.
    follows_slowly: Option<f64>,
    follows_up_to_hz: Option<f64>,
    /// How far an end force may exceed its static response.
    most_peak: f64,
    /// In `command_unit` per newton.
    proportional_gain: f64,
    command_unit: &'static str,
    /// Whether the loop on that force, run at 0.98 and 1.02 of its predicted limit, stayed and grew; null without a limit or a run.
    limit_confirmed_over_time: Option<bool>,
    /// The drive of all runs over time, in words.
    drive: String,
    /// Each force and each estimate, run over time.
    over_time: Vec<RunRow<'a>>,
    estimates: Vec<EstimateRow>,
    candidates: Vec<CandidateRow<'a>>,
}

impl Outcome for PlacementOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/placement/1";
}

/// The loop behind an estimator.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct EstimateRow {
    name: &'static str,
    stable_crossover_hz: Option<f64>,
    robust_crossover_hz: Option<f64>,
    /// From which crossover on; zero where it is so in the slowest loop, too.
    robust_from_hz: f64,
}

/// A loop over time: a step of 1 % of F_nom at the set gain, and whether its limit holds, at the damping at which it has the least to spare.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct RunRow<'a> {
    fed_back: &'static str,
    damping: &'a str,
    /// By how much k and the first surge frequency of the spring are off on which it has the least to spare.
    stiffness_off_percent: f64,
    surge_off_percent: f64,
    /// By its response over frequency.
    stable: bool,
    /// From sample to sample; of a continuous loop the step of its run.
    step_s: Option<f64>,
    /// When a force passed 1e8 N.
    ran_away_at_s: Option<f64>,
    /// F_o in the last tenth of the run, over the step; null where it ran away.
    load_percent: Option<f64>,
    /// How far it moves then, either way.
    load_swing_percent: Option<f64>,
    /// In `command_unit`.
    largest_command: Option<f64>,
    /// As `limit_confirmed_over_time`.
    limit_confirmed: Option<bool>,
    /// How far F_L read off the whole inductance is from its straight line, over the step.
    coil_error_percent: Option<f64>,
    /// Why there is no run.
    not_run: Option<&'a str>,
}

/// A force that could be fed back: the worst over all springs, where it is not the nominal one's.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct CandidateRow<'a> {
    force: &'static str,
    /// The quickest sensor of the spec that measures it; null where none does, and it is taken without lag.
    sensor: Option<&'a str>,
    /// How late that tells slow changes, beside the delay of `[control]`.
    sensor_lag_s: f64,
    /// Where it has lost 3 dB, if that is below three times the first surge frequency, so that its limits are rough.
    sensor_coarse_hz: Option<f64>,
    stable_crossover_hz: Option<f64>,
    /// With a sensitivity of at most 2.
    robust_crossover_hz: Option<f64>,
    /// From which crossover on the sensitivity is at most 2; zero where it is in the slowest loop, too.
    robust_from_hz: f64,
    /// At which neither end rings besides.
    calm_crossover_hz: f64,
    /// The first on the nominal spring alone.
    nominal_stable_crossover_hz: Option<f64>,
    nominal_robust_crossover_hz: Option<f64>,
    nominal_calm_crossover_hz: f64,
    stable_as_set: bool,
    dampings: Vec<DampingRow<'a>>,
}

/// The same at one damping.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct DampingRow<'a> {
    damping: &'a str,
    gain_limit: Option<f64>,
    /// Of the nominal spring alone.
    nominal_gain_limit: Option<f64>,
    stable_crossover_hz: Option<f64>,
    robust_crossover_hz: Option<f64>,
    /// From which crossover on; zero where it is so in the slowest loop, too.
    robust_from_hz: f64,
    /// At its limit; zero without one.
    oscillates_at_hz: f64,
    as_set: AsSetPart<'a>,
}

/// The loop as it is set; peaks and bands are null where it is unstable.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct AsSetPart<'a> {
    stable: bool,
    gain_margin: Option<f64>,
    phase_margin_rad: Option<f64>,
    delay_margin_s: Option<f64>,
    modulus_margin: f64,
    drive_peak: Option<f64>,
    drive_peak_hz: Option<f64>,
    load_peak: Option<f64>,
    load_peak_hz: Option<f64>,
    /// Where the rendered impedance is not passive.
    active_bands_hz: Option<&'a [[f64; 2]]>,
}

impl<'a> PlacementOutcome<'a> {
    /// Of a placement that was judged.
    pub fn of(placement: &'a Placement) -> Self {
        Self {
            answer: answer(placement),
            feed_back: placement.candidates[placement.best].channel.name(),
            nominal_feed_back: placement.nominal[placement.nominal_best].channel.name(),
            stiffness_tolerance_percent: 100.0 * placement.allowed.stiffness,
            surge_tolerance_percent: 100.0 * placement.allowed.frequency,
            crossover_hz: placement.crossover,
            follows_slowly: placement.follows.map(|[slow, _]| slow),
            follows_up_to_hz: placement.follows.and_then(|[slow, up_to]| finite(up_to).filter(|_| slow >= FOLLOWS)),
            most_peak: MOST_PEAK,
            proportional_gain: placement.gain,
            command_unit: placement.control.drive.command_unit(),
            limit_confirmed_over_time: placement.best_run().verdict.confirmed(),
            drive: drive_words(&placement.control.drive),
            over_time: placement.runs.iter().map(RunRow::of).collect(),
            estimates: placement.estimates.iter().map(EstimateRow::of).collect(),
            candidates: placement
                .candidates
                .iter()
                .zip(&placement.nominal)
                .map(|(candidate, nominal)| CandidateRow::of(placement, candidate, nominal))
                .collect(),
        }
    }
}

impl EstimateRow {
    fn of(estimate: &Estimated) -> Self {
        Self {
            name: estimate.name,
            stable_crossover_hz: finite(estimate.stable_crossover),
            robust_crossover_hz: finite(estimate.robust_crossover),
            robust_from_hz: estimate.robust_from,
        }
    }
}

impl<'a> RunRow<'a> {
    fn of(run: &'a LoopRun) -> Self {
        let shown = run.shown.as_ref().ok();
        Self {
            fed_back: run.fed_back,
            damping: &run.damping,
            stiffness_off_percent: 100.0 * run.off[0],
            surge_off_percent: 100.0 * run.off[1],
            stable: run.stable,
            step_s: shown.and_then(|shown| Some(shown.time.get(1)? - shown.time[0])),
            ran_away_at_s: shown.and_then(|shown| shown.ran_away_at),
            load_percent: run.last.map(|[place, _]| 100.0 * place),
            load_swing_percent: run.last.map(|[_, swing]| 100.0 * swing),
            largest_command: shown.map(|_| run.largest_command),
            limit_confirmed: run.verdict.confirmed(),
            coil_error_percent: run.coil_error.map(|error| 100.0 * error),
            not_run: run.shown.as_ref().err().map(String::as_str),
        }
    }
}

impl<'a> CandidateRow<'a> {
    fn of(placement: &'a Placement, candidate: &'a Candidate, nominal: &Candidate) -> Self {
        let judged = candidate.judged.iter().zip(&nominal.judged).zip(&placement.dampings);
        let reading = placement.reading(candidate.channel);
        Self {
            force: candidate.channel.name(),
            sensor: reading.sensor.as_deref(),
            sensor_lag_s: reading.lag,
            sensor_coarse_hz: reading.coarse,
            stable_crossover_hz: finite(candidate.stable_crossover()),
            robust_crossover_hz: finite(candidate.robust_crossover()),
            robust_from_hz: candidate.robust_from(),
            calm_crossover_hz: candidate.calm_crossover,
            nominal_stable_crossover_hz: finite(nominal.stable_crossover()),
            nominal_robust_crossover_hz: finite(nominal.robust_crossover()),
            nominal_calm_crossover_hz: nominal.calm_crossover,
            stable_as_set: candidate.is_stable(),
            dampings: judged.map(|((judged, nominal), damping)| DampingRow::of(judged, nominal, damping)).collect(),
        }
    }
}

impl<'a> DampingRow<'a> {
    fn of(judged: &'a Assessment, nominal: &Assessment, damping: &'a DampingCase) -> Self {
        let margins = &judged.margins;
        let [drive, load] = [0, 1].map(|end| judged.peaks.map(|peaks| peaks[end]));
        Self {
            damping: &damping.label,
            gain_limit: finite(judged.limit),
            nominal_gain_limit: finite(nominal.limit),
            stable_crossover_hz: finite(judged.stable_crossover),
            robust_crossover_hz: finite(judged.robust_crossover),
            robust_from_hz: judged.robust_from,
            oscillates_at_hz: judged.oscillates_at,
            as_set: AsSetPart {
                stable: margins.stable,
                gain_margin: finite(margins.gain_limit),
                phase_margin_rad: finite(margins.phase),
                delay_margin_s: finite(margins.delay),
                modulus_margin: margins.modulus,
                drive_peak: drive.map(|peak| peak.size),
                drive_peak_hz: drive.map(|peak| peak.at),
                load_peak: load.map(|peak| peak.size),
                load_peak_hz: load.map(|peak| peak.at),
                active_bands_hz: judged.passivity.as_ref().map(|passivity| passivity.active.as_slice()),
            },
        }
    }
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// The placement as JSON.
///
/// # Errors
/// What the JSON writer says.
pub fn placement_json(placement: &Placement) -> Result<String, serde_json::Error> {
    to_json(PlacementOutcome::of(placement))
}
