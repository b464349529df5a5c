//! `results.json`: an analysis for machines.
//!
//! Next door: the same for people (`text`, `html`).

use coilsense::Deviation;
use serde_json::{Value, json};

use crate::analysis::{Analysis, Case, IfUsual, SensorBudget, USUAL_TOLERANCE, Verdict, answer};
use crate::report::data_sheet::data_sheet_value;
use crate::study::Masses;

/// The whole analysis as text; what was not computed is null.
///
/// # Errors
/// What `serde_json` says.
pub fn analysis_json(analysis: &Analysis, date: &str) -> Result<String, serde_json::Error> {
    let spec = &analysis.spec;
    let goal = &spec.goal;
    let value = json!({
        "schema": "coilsense/analysis/1",
        "version": env!("CARGO_PKG_VERSION"),
        "date": date,
        "spec_file": spec.file,
        "answer": answer(analysis),
        "goal": { "error_n": goal.error, "bandwidth_hz": goal.bandwidth, "force": goal.force.name() },
        "nominal_force_n": spec.spring.spring.nominal_force(),
        "masses": masses_value(&analysis.masses),
        "if_stiffness_tolerance_were_usual": analysis.if_usual.as_ref().map(|usual| usual_value(analysis, usual)),
        "ranking": analysis.verdicts.iter().map(|verdict| verdict_value(analysis, verdict)).collect::<Vec<_>>(),
        "cases": analysis.cases.iter().map(|case| case_value(analysis, case)).collect::<Vec<_>>(),
        "warnings": analysis.warnings.iter()
            .map(|warning| json!({ "subject": warning.subject.name(), "text": warning.text })).collect::<Vec<_>>(),
        "spring": data_sheet_value(&analysis.data_sheet),
        "spec": spec.text,
    });
    Ok(format!("{}\n", serde_json::to_string_pretty(&value)?))
}

/// How many masses stand for a winding, and whether they are enough.
fn masses_value(masses: &Masses) -> Value {
    json!({
        "per_winding": masses.per_winding,
        "given": masses.is_given,
        "change_when_doubled": masses.change,
        "enough": masses.are_enough(),
        "conditions_without_limit": masses.without_limit,
    })
}

/// The answer of a spec that is silent on its stiffness, within the usual tolerance.
fn usual_value(analysis: &Analysis, usual: &IfUsual) -> Value {
    let sensors = analysis.sensors.iter().zip(&usual.combined);
    json!({
        "stiffness_tolerance": USUAL_TOLERANCE,
        "best": analysis.sensors[usual.best].name,
        "sensors": sensors.map(|(sensor, combined)| json!({ "sensor": sensor.name, "combined_n": combined })).collect::<Vec<_>>(),
    })
}

fn verdict_value(analysis: &Analysis, verdict: &Verdict) -> Value {
    let sensor = &analysis.sensors[verdict.sensor];
    let worst = &analysis.cases[verdict.worst];
    let fixes =
        verdict.fixes.iter().map(|fix| json!({ "change": fix.change, "combined_n": fix.combined, "lag_s": fix.lag }));
    let dampings = analysis.spec.mount.cases.iter().zip(&verdict.meets);
    json!({
        "sensor": sensor.name,
        "kind": sensor.quantity.kind(),
        "combined_n": verdict.combined(),
        "combined_percent": 100.0 * verdict.combined() / analysis.spec.spring.spring.nominal_force(),
        "worst_condition": analysis.spec.conditions[worst.condition].name,
        "worst_damping": analysis.spec.mount.cases[worst.damping].label,
        "meets_goal": verdict.meets_always(),
        "meets_goal_by_damping": dampings.map(|(case, meets)| json!({ "damping": case.label, "meets": meets })).collect::<Vec<_>>(),
        // A sensor without limits has no −3 dB point.
        "bandwidth_hz": Some(verdict.bandwidth).filter(|bandwidth| bandwidth.is_finite()),
        "lag_s": verdict.lag,
        "goal_filter": verdict.filter.map(|filter| json!({
            "kind": "Butterworth low-pass",
            "order": filter.order,
            "bandwidth_hz": filter.bandwidth,
            "lag_s": filter.lag,
            "error_without_n": filter.raw,
        })),
        "share_inside_goal": verdict.least_inside(),
        "worst_specimen_n": verdict.at_worst().worst,
        "nominal_n": verdict.at_worst().nominal,
        "fixes": fixes.collect::<Vec<_>>(),
        "budget": budget_value(&verdict.budget),
    })
}

fn budget_value(budget: &SensorBudget) -> Value {
    let lines = budget.budget.contributions().iter().map(|line| {
        json!({
            "name": line.name,
            "standard_uncertainty": line.standard_uncertainty,
            "sensitivity": line.sensitivity,
            "contribution_n": line.contribution,
            "share": line.share,
        })
    });
    json!({
        "force_n": budget.force,
        "lines": lines.collect::<Vec<_>>(),
        "bias_n": budget.budget.bias(),
        "combined_n": budget.budget.combined(),
        "coverage_factor": budget.coverage_factor,
        "expanded_n": budget.expanded,
        "monte_carlo": {
            "mean_n": budget.mean,
            "standard_n": budget.standard,
            "interval_n": [budget.interval.0, budget.interval.1],
            "agrees": budget.agreement.holds(),
            "decided": budget.agreement.decided(),
            "difference_n": [budget.agreement.low, budget.agreement.high],
            "tolerance_n": budget.agreement.tolerance,
        },
    })
}

fn case_value(analysis: &Analysis, case: &Case) -> Value {
    let spec = &analysis.spec;
    let nominal = spec.spring.spring.nominal_force();
    let ideal =
        case.ideal.iter().map(|(channel, deviation)| (channel.name().to_owned(), deviation_value(deviation, nominal)));
    let number = case.condition * spec.mount.cases.len() + case.damping;
    let sensors = analysis.sensors.iter().enumerate().zip(&case.readings).map(|((index, sensor), reading)| {
        let verdict = analysis.verdicts.iter().find(|verdict| verdict.sensor == index);
        let assessment = verdict.map(|verdict| verdict.assessments[number]);
        json!({
            "sensor": sensor.name,
            "deviation": deviation_value(&reading.deviation, nominal),
            "oscillation_in_band_n": assessment.map(|assessment| assessment.oscillation),
            "oscillation_over_specimens_n": assessment.map(|assessment| assessment.over_specimens),
            "oscillation_of_loudest_specimen_n": assessment.map(|assessment| assessment.loudest),
            "combined_n": assessment.map(|assessment| assessment.combined),
            "nominal_n": assessment.map(|assessment| assessment.nominal),
            "every_frequency_n": assessment.map(|assessment| assessment.raw),
            "worst_specimen_n": assessment.map(|assessment| assessment.worst),
            "share_inside_goal": assessment.and_then(|assessment| assessment.inside),
        })
    });
    // A single winding has no neighbour.
    let pitch = Some(case.clash.smallest_pitch).filter(|pitch| pitch.is_finite());
    let condition = &spec.conditions[case.condition];
    let damping = &spec.mount.cases[case.damping];
    json!({
        "condition": condition.name,
        "kind": condition.kind,
        "damping": damping.label,
        "damping_ratio": damping.ratio,
        "window_s": [condition.window.0, condition.window.1],
        "sample_rate_hz": condition.sample_rate,
        "forces": Value::Object(ideal.collect()),
        "sensors": sensors.collect::<Vec<_>>(),
        "shortest_length_m": case.lengths.0,
        "longest_length_m": case.lengths.1,
        "smallest_pitch_m": pitch.map(|pitch| spec.spring.winding_pitch(pitch)),
        "smallest_gap_m": pitch.map(|pitch| spec.spring.gap(pitch)),
        "first_contact_s": case.clash.first_contact,
    })
}

/// Every measure in newtons and in percent of F_nom.
fn deviation_value(deviation: &Deviation, nominal: f64) -> Value {
    let percent = |newton: f64| 100.0 * newton / nominal;
    json!({
        "rmsd_n": deviation.rmsd,
        "rmsd_percent": percent(deviation.rmsd),
        "maximum_n": deviation.maximum,
        "maximum_absolute_n": deviation.maximum_absolute,
        "maximum_absolute_percent": percent(deviation.maximum_absolute),
        "mean_n": deviation.mean,
        "mean_percent": percent(deviation.mean),
        "standard_error_n": deviation.standard_error,
    })
}
