//! What an experiment says, in words.
//!
//! Next door: the numbers (`outcome`, `findings`).

use super::{Curve, Drift, Experiment, FORCES, Findings, Offset};
use crate::quantity::digits;
use crate::stored::StoredCalibration;

/// Probability below which a drift counts as seen.
const CHANCE: f64 = 0.01;

/// Sentences, the first of which says where the forces at load cell and by deflection part, and by how much.
pub fn answer(experiment: &Experiment, findings: &Findings) -> Vec<String> {
    let mark = if experiment.simulated { "Simulated data: " } else { "" };
    let mut lines = vec![format!("{mark}{}", parting(experiment, findings))];
    lines.extend(means(experiment, findings));
    lines.extend(relaxation(experiment, findings));
    lines.push(spring(experiment));
    lines
}

fn parting(experiment: &Experiment, findings: &Findings) -> String {
    let percent = |newton: f64| format!("{} %", digits(experiment.percent(newton)));
    let Some(peak) = findings.peak else {
        return "there is no sine to compare F_o and F_x in.".to_owned();
    };
    let run = &experiment.runs[peak.run];
    let others = experiment.harmonics().filter(|(index, _)| *index != peak.run);
    let least = others.map(|(_, run)| run.fast.deviation.rmsd).fold(f64::INFINITY, f64::min);
    let beside = if least.is_finite() { format!(" (elsewhere down to {})", percent(least)) } else { String::new() };
    let neighbours = if peak.rmsd_ratio.is_finite() {
        format!(", {} times its neighbours'", digits(peak.rmsd_ratio))
    } else {
        String::new()
    };
    format!(
        "F_o and F_x differ most at {} Hz ({}): RMSD {} of F_nom{beside}{neighbours}, largest difference {}.",
        digits(run.spec.frequency),
        run.spec.name,
        percent(run.fast.deviation.rmsd),
        percent(run.fast.deviation.maximum_absolute)
    )
}

/// What the means do at the peak.
fn means(experiment: &Experiment, findings: &Findings) -> Option<String> {
    let peak = findings.peak?;
    let said: Vec<String> = FORCES
        .into_iter()
        .filter_map(|force| {
            Some(format!("{} {}", force.name(), against(experiment, findings.offset(peak.run, force)?)))
        })
        .collect();
    if said.is_empty() {
        return Some("Its means have no neighbours on both sides to be compared with.".to_owned());
    }
    Some(format!("Mean forces there against those of the runs before and after: {}.", said.join("; ")))
}

fn against(experiment: &Experiment, offset: Offset) -> String {
    let numbers = format!("{} mN", pair(1e3 * offset.value, 1e3 * offset.error));
    if !offset.is_seen() {
        return format!("no significant difference ({numbers})");
    }
    let way = if offset.value < 0.0 { "low" } else { "high" };
    let percent = digits(experiment.percent(offset.value.abs()));
    format!("is biased {way} by {percent} % of F_nom ({numbers}, {} standard errors)", digits(offset.ratio().abs()))
}

fn relaxation(experiment: &Experiment, findings: &Findings) -> Option<String> {
    let said: Vec<String> = findings.drifts.iter().filter_map(|drift| drifted(experiment, drift)).collect();
    (!said.is_empty()).then(|| format!("From the first preload to the last: {}.", said.join("; ")))
}

fn drifted(experiment: &Experiment, drift: &Drift) -> Option<String> {
    let preloads = drift.preloads?;
    let numbers = format!("{} mN", pair(1e3 * preloads.value, 1e3 * preloads.error));
    let seen = if preloads.is_seen() {
        format!("{numbers}, {} % of F_nom", digits(experiment.percent(preloads.value.abs())))
    } else {
        format!("unchanged, {numbers}")
    };
    let trend = match drift.trend {
        Some(trend) if trend.p < CHANCE && trend.slope != 0.0 => {
            format!(
                ", a drift of {} mN a run over all of them (p = {})",
                signed(1e3 * trend.slope),
                probability(trend.p)
            )
        }
        Some(trend) => format!(", no drift over all runs (p = {})", probability(trend.p)),
        None => String::new(),
    };
    Some(format!("{} {seen}{trend}", drift.force.name()))
}

fn spring(experiment: &Experiment) -> String {
    let line = &experiment.line;
    let error = |error: Option<f64>| error.map_or(String::new(), |error| format!(" ± {}", digits(error)));
    let stiffness = match (experiment.spec.stiffness, line.fit) {
        (None, Some(fit)) => {
            format!("k = {:.2}{} N/m from the calibration run", fit.stiffness, error(fit.stiffness_se))
        }
        _ => format!("k = {:.2} N/m as given", line.stiffness),
    };
    let curve = match &experiment.curve {
        Some(Curve::InverseLength { fit: Some(fit), through, .. }) => format!(
            "; 1/l = αL + β fitted {}leaves {} mm RMS",
            if through.is_some() { "through the preload " } else { "" },
            digits(1e3 * fit.misfit.rmse)
        ),
        Some(Curve::InverseLength { .. }) => "; 1/l = αL + β as given".to_owned(),
        Some(Curve::Stored(stored)) => format!("; {}", of_file(stored)),
        None => String::new(),
    };
    format!("{stiffness}, {:.3} mm long where positions read zero{curve}.", 1e3 * line.length_at_zero)
}

/// What a stored calibration is, and how surely it tells a length.
fn of_file(stored: &StoredCalibration) -> String {
    let doubt = match stored.doubts(stored.lengths()) {
        Some([own, mounted]) => {
            let anew = if mounted > 0.0 { " (remounting included)" } else { "" };
            format!("standard uncertainty of length {} mm{anew}", digits(1e3 * own.hypot(mounted)))
        }
        None => "its uncertainty unknown".to_owned(),
    };
    format!("length from L by {}, {doubt}", stored.name)
}

/// A number with its sign, a true minus.
fn signed(value: f64) -> String {
    if value < 0.0 { format!("\u{2212}{}", digits(-value)) } else { format!("+{}", digits(value)) }
}

/// A number and its standard error, both to two digits of the error.
pub(crate) fn pair(value: f64, error: f64) -> String {
    let decimals = if error > 0.0 { (1 - error.log10().floor() as i32).clamp(0, 9) as usize } else { 3 };
    format!("{value:+.decimals$} ± {error:.decimals$}").replace('-', "\u{2212}")
}

/// A probability to two digits.
pub(crate) fn probability(p: f64) -> String {
    if p < 1e-4 { format!("{p:.0e}") } else { format!("{p:.2}").replace("0.00", "0.001") }
}
