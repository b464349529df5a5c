//! An experiment for machines, in SI units but for shares in percent, as their names say.
//!
//! Next door: the same for people (`text`, `html`).

use serde_json::{Map, Value, json};

use crate::experiment::{Experiment, FORCES, Findings, Offset, Run, answer};

/// The whole experiment; what was not computed is null.
///
/// # Errors
/// [`serde_json::Error`] where it cannot be written.
pub fn experiment_json(
    experiment: &Experiment,
    findings: &Findings,
    date: Option<&str>,
) -> Result<String, serde_json::Error> {
    let line = &experiment.line;
    let fit = line.fit;
    let curve = experiment.curve.as_ref().map(|curve| {
        json!({
            "alpha_per_h_m": curve.calibration.alpha(),
            "beta_per_m": curve.calibration.beta(),
            "alpha_per_h_m_se": curve.fit.as_ref().and_then(|fit| fit.alpha_se),
            "beta_per_m_se": curve.fit.as_ref().and_then(|fit| fit.beta_se),
            "rmse_m": curve.fit.as_ref().map(|fit| fit.misfit.rmse),
            "through_length_m": curve.through.map(|(length, _)| length),
            "through_inductance_h": curve.through.map(|(_, inductance)| inductance),
        })
    });
    let value = json!({
        "schema": "coilsense/experiment/1",
        "version": env!("CARGO_PKG_VERSION"),
        "date": date,
        "file": experiment.spec.file,
        "simulated": experiment.simulated,
        "answer": answer(experiment, findings),
        "nominal_force_n": experiment.spec.nominal_force,
        "reference_n": experiment.reference,
        "spring": {
            "stiffness_n_per_m": line.stiffness,
            "stiffness_n_per_m_se": fit.filter(|_| experiment.spec.stiffness.is_none()).and_then(|fit| fit.stiffness_se),
            "length_at_zero_force_m": line.length_at_zero_force,
            "length_at_zero_m": line.length_at_zero,
            "rmse_n": fit.map(|fit| fit.rmse),
        },
        "inverse_length": curve,
        "peak": findings.peak.map(|peak| json!({
            "run": experiment.runs[peak.run].spec.name,
            "frequency_hz": experiment.runs[peak.run].spec.frequency,
            "rmsd_over_neighbours": finite(peak.rmsd_ratio),
            "maximum_over_neighbours": finite(peak.maximum_ratio),
        })),
        "drift": findings.drifts.iter().map(|drift| json!({
            "force": drift.force.name(),
            "last_less_first_preload": drift.preloads.map(offset),
            "trend_p": drift.trend.map(|trend| trend.p),
            "trend_n_per_run": drift.trend.map(|trend| trend.slope),
        })).collect::<Vec<_>>(),
        "runs": experiment.runs.iter().enumerate().map(|(index, one)| run(experiment, findings, index, one)).collect::<Vec<_>>(),
        "account": experiment.account(),
    });
    serde_json::to_string_pretty(&value).map(|text| text + "\n")
}

/// A ratio to nothing is none.
fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

fn offset(offset: Offset) -> Value {
    json!({ "value_n": offset.value, "standard_error_n": offset.error, "seen": offset.is_seen() })
}

fn run(experiment: &Experiment, findings: &Findings, index: usize, run: &Run) -> Value {
    let deviation = &run.fast.deviation;
    let mean = |force: coilsense::Channel| {
        let mean = run.mean(force)?;
        Some((
            force.name().to_owned(),
            json!({
                "mean_n": mean.mean,
                "difference_n": mean.mean - experiment.reference,
                "difference_percent": experiment.percent(mean.mean - experiment.reference),
                "standard_error_n": mean.standard_error,
                "block_standard_error_n": mean.block_error,
                "samples": mean.samples,
                "against_neighbours": findings.offset(index, force).map(offset),
            }),
        ))
    };
    json!({
        "name": run.spec.name,
        "kind": run.spec.kind.word(),
        "frequency_hz": run.spec.frequency,
        "amplitude_m": run.spec.amplitude,
        "rmsd_n": deviation.rmsd,
        "rmsd_percent": experiment.percent(deviation.rmsd),
        "maximum_n": deviation.maximum,
        "maximum_absolute_n": deviation.maximum_absolute,
        "maximum_absolute_percent": experiment.percent(deviation.maximum_absolute),
        "oscillation_n": run.fast.oscillation,
        "samples_left_out": run.fast.left_out,
        "readings": run.readings,
        "means": Value::Object(FORCES.into_iter().filter_map(mean).collect::<Map<_, _>>()),
    })
}
