//! An experiment for machines, in SI units but for shares in percent, as the names of its keys say.
//!
//! Next door: the same for people (`text`, `html`).

use std::collections::BTreeMap;

use coilsense::Channel;
use serde::Serialize;

use crate::experiment::{Curve, Drift, Experiment, FORCES, Findings, Offset, Peak, Run, answer};
use crate::report::outcome::{Outcome, to_json};

/// What the runs of an experiment show; null for what was not computed.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct ExperimentOutcome<'a> {
    date: Option<&'a str>,
    file: &'a str,
    simulated: bool,
    /// The answer, a sentence each.
    answer: Vec<String>,
    nominal_force_n: f64,
    /// Mean force of the first preload, against which means are held.
    reference_n: f64,
    spring: SpringPart,
    inverse_length: Option<CurvePart>,
    /// The file of the calibration that was stored, in place of that curve.
    stored_calibration: Option<&'a str>,
    peak: Option<PeakPart<'a>>,
    drift: Vec<DriftRow>,
    runs: Vec<RunRow<'a>>,
    /// What became of the logs' rows, line by line.
    account: Vec<String>,
}

impl Outcome for ExperimentOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/experiment/1";
}

/// The spring by its points at rest.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct SpringPart {
    stiffness_n_per_m: f64,
    /// Standard error; null where the stiffness was given.
    stiffness_n_per_m_se: Option<f64>,
    length_at_zero_force_m: f64,
    length_at_zero_m: f64,
    rmse_n: Option<f64>,
}

/// 1/l = α L + β, eq. (13).
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct CurvePart {
    alpha_per_h_m: f64,
    beta_per_m: f64,
    alpha_per_h_m_se: Option<f64>,
    beta_per_m_se: Option<f64>,
    rmse_m: Option<f64>,
    through_length_m: Option<f64>,
    through_inductance_h: Option<f64>,
}

/// The sine at which F_o departs most from F_x.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct PeakPart<'a> {
    run: &'a str,
    frequency_hz: f64,
    rmsd_over_neighbours: Option<f64>,
    maximum_over_neighbours: Option<f64>,
}

/// How a force's mean changes over the experiment.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct DriftRow {
    force: &'static str,
    last_less_first_preload: Option<OffsetPart>,
    /// Probability of such a trend by chance.
    trend_p: Option<f64>,
    trend_n_per_run: Option<f64>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct OffsetPart {
    value_n: f64,
    standard_error_n: f64,
    /// Whether it is more than chance.
    seen: bool,
}

/// A run: how F_o departs from F_x, and the forces' means.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct RunRow<'a> {
    name: &'a str,
    kind: &'static str,
    /// As its run states it.
    frequency_hz: f64,
    /// Of the strongest line of F_x; null at rest, and where no line stands out.
    measured_frequency_hz: Option<f64>,
    /// Half of the interval that holds it with 95 %.
    measured_frequency_hz_half_width: Option<f64>,
    amplitude_m: Option<f64>,
    rmsd_n: f64,
    rmsd_percent: f64,
    maximum_n: f64,
    maximum_absolute_n: f64,
    maximum_absolute_percent: f64,
    oscillation_n: f64,
    samples_left_out: usize,
    /// Of the inductance.
    readings: usize,
    /// By force.
    means: BTreeMap<&'static str, MeanPart>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct MeanPart {
    mean_n: f64,
    /// From the reference.
    difference_n: f64,
    difference_percent: f64,
    standard_error_n: f64,
    /// Over the means of blocks; null with too few of them.
    block_standard_error_n: Option<f64>,
    samples: usize,
    against_neighbours: Option<OffsetPart>,
}

impl<'a> ExperimentOutcome<'a> {
    /// Of an experiment that was read.
    pub fn of(experiment: &'a Experiment, findings: &Findings, date: Option<&'a str>) -> Self {
        let runs = experiment.runs.iter().enumerate();
        Self {
            date,
            file: &experiment.spec.file,
            simulated: experiment.simulated,
            answer: answer(experiment, findings),
            nominal_force_n: experiment.spec.nominal_force,
            reference_n: experiment.reference,
            spring: SpringPart::of(experiment),
            stored_calibration: match &experiment.curve {
                Some(Curve::Stored(stored)) => Some(&stored.name),
                Some(Curve::InverseLength { .. }) | None => None,
            },
            inverse_length: experiment.curve.as_ref().and_then(CurvePart::of),
            peak: findings.peak.map(|peak| PeakPart::of(experiment, peak)),
            drift: findings.drifts.iter().map(DriftRow::of).collect(),
            runs: runs.map(|(index, run)| RunRow::of(experiment, findings, index, run)).collect(),
            account: experiment.account(),
        }
    }
}

impl SpringPart {
    fn of(experiment: &Experiment) -> Self {
        let (line, fit) = (&experiment.line, experiment.line.fit);
        let fitted = fit.filter(|_| experiment.spec.stiffness.is_none());
        Self {
            stiffness_n_per_m: line.stiffness,
            stiffness_n_per_m_se: fitted.and_then(|fit| fit.stiffness_se),
            length_at_zero_force_m: line.length_at_zero_force,
            length_at_zero_m: line.length_at_zero,
            rmse_n: fit.map(|fit| fit.rmse),
        }
    }
}

impl CurvePart {
    fn of(curve: &Curve) -> Option<Self> {
        let Curve::InverseLength { calibration, fit, through } = curve else { return None };
        let fit = fit.as_ref();
        Some(Self {
            alpha_per_h_m: calibration.alpha(),
            beta_per_m: calibration.beta(),
            alpha_per_h_m_se: fit.and_then(|fit| fit.alpha_se),
            beta_per_m_se: fit.and_then(|fit| fit.beta_se),
            rmse_m: fit.map(|fit| fit.misfit.rmse),
            through_length_m: through.map(|(length, _)| length),
            through_inductance_h: through.map(|(_, inductance)| inductance),
        })
    }
}

impl<'a> PeakPart<'a> {
    fn of(experiment: &'a Experiment, peak: Peak) -> Self {
        // A ratio to nothing is none.
        let finite = |value: f64| value.is_finite().then_some(value);
        let run = &experiment.runs[peak.run].spec;
        Self {
            run: &run.name,
            frequency_hz: run.frequency,
            rmsd_over_neighbours: finite(peak.rmsd_ratio),
            maximum_over_neighbours: finite(peak.maximum_ratio),
        }
    }
}

impl DriftRow {
    fn of(drift: &Drift) -> Self {
        Self {
            force: drift.force.name(),
            last_less_first_preload: drift.preloads.map(OffsetPart::of),
            trend_p: drift.trend.map(|trend| trend.p),
            trend_n_per_run: drift.trend.map(|trend| trend.slope),
        }
    }
}

impl OffsetPart {
    fn of(offset: Offset) -> Self {
        Self { value_n: offset.value, standard_error_n: offset.error, seen: offset.is_seen() }
    }
}

impl<'a> RunRow<'a> {
    fn of(experiment: &Experiment, findings: &Findings, index: usize, run: &'a Run) -> Self {
        let deviation = &run.fast.deviation;
        let mean = |force: Channel| {
            let mean = run.mean(force)?;
            let difference = mean.mean - experiment.reference;
            let part = MeanPart {
                mean_n: mean.mean,
                difference_n: difference,
                difference_percent: experiment.percent(difference),
                standard_error_n: mean.standard_error,
                block_standard_error_n: mean.block_error,
                samples: mean.samples,
                against_neighbours: findings.offset(index, force).map(OffsetPart::of),
            };
            Some((force.name(), part))
        };
        Self {
            name: &run.spec.name,
            kind: run.spec.kind.word(),
            frequency_hz: run.spec.frequency,
            measured_frequency_hz: run.fast.moves.map(|line| line.frequency),
            measured_frequency_hz_half_width: run.fast.moves.map(|line| line.half_width),
            amplitude_m: run.spec.amplitude,
            rmsd_n: deviation.rmsd,
            rmsd_percent: experiment.percent(deviation.rmsd),
            maximum_n: deviation.maximum,
            maximum_absolute_n: deviation.maximum_absolute,
            maximum_absolute_percent: experiment.percent(deviation.maximum_absolute),
            oscillation_n: run.fast.oscillation,
            samples_left_out: run.fast.left_out,
            readings: run.readings,
            means: FORCES.into_iter().filter_map(mean).collect(),
        }
    }
}

/// The whole experiment as JSON.
///
/// # Errors
/// [`serde_json::Error`] where it cannot be written.
pub fn experiment_json(
    experiment: &Experiment,
    findings: &Findings,
    date: Option<&str>,
) -> Result<String, serde_json::Error> {
    to_json(ExperimentOutcome::of(experiment, findings, date))
}
