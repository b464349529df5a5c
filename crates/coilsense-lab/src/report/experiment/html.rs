//! `report.html` of an experiment: one page that needs no other file and no network; the answer first.
//!
//! Next door: its layout (`page.html`), its figures (`figures`).

use coilsense::Channel;
use minijinja::{Value, context};

use crate::experiment::{Curve, Experiment, FORCES, Findings, Run, answer, pair, probability};
use crate::quantity::digits;
use crate::report::page::{self, shown};
use crate::report::prose::{file_name, unbroken};
use crate::report::{Drawn, ReportError};

/// The page of an experiment.
pub(super) fn page(
    experiment: &Experiment,
    findings: &Findings,
    date: &str,
    drawn: &[Drawn],
) -> Result<String, ReportError> {
    let runs = experiment.runs.iter().enumerate();
    Ok(page::page(
        include_str!("page.html"),
        context! {
            date,
            name => name(experiment),
            simulated => experiment.simulated,
            answer => answer(experiment, findings).iter().map(|line| unbroken(line)).collect::<Vec<_>>(),
            figures => drawn.iter().map(shown).collect::<Vec<_>>(),
            nominal => experiment.spec.nominal_force,
            reference => exact(experiment.reference, 3),
            forces => FORCES.map(Channel::name),
            runs => runs.clone().map(|(index, run)| run_value(experiment, findings, index, run)).collect::<Vec<_>>(),
            offsets => runs.filter_map(|(index, run)| offsets(findings, index, run)).collect::<Vec<_>>(),
            drifts => drifts(experiment, findings),
            spring => spring(experiment),
            account => experiment.account(),
        },
    )?)
}

/// What people call it: its own name, or that of its folder.
fn name(experiment: &Experiment) -> String {
    let folder = std::path::Path::new(&experiment.spec.file).parent().map(|folder| folder.display().to_string());
    let folder = folder.filter(|folder| !folder.is_empty()).unwrap_or_else(|| "this folder".to_owned());
    experiment.spec.name.clone().unwrap_or_else(|| file_name(&folder).to_owned())
}

/// A number with some decimals.
pub(super) fn exact(value: f64, decimals: usize) -> String {
    format!("{value:.decimals$}")
}

/// A mean less the preload's, and σ/√n, in percent of F_nom.
pub(super) fn cell(experiment: &Experiment, run: &Run, force: Channel) -> Option<String> {
    let mean = run.mean(force)?;
    let [value, error] =
        [mean.mean - experiment.reference, mean.standard_error].map(|newton| experiment.percent(newton));
    let text = format!("{value:+.4}");
    // What rounds to zero has no sign.
    let text = if text.ends_with("0.0000") { "0.0000".to_owned() } else { text };
    Some(format!("{text} ± {error:.4}"))
}

fn run_value(experiment: &Experiment, findings: &Findings, index: usize, run: &Run) -> Value {
    let deviation = &run.fast.deviation;
    let percent = |newton: f64| exact(experiment.percent(newton), 3);
    context! {
        name => &run.spec.name,
        kind => run.spec.kind.word(),
        frequency => (run.spec.frequency > 0.0).then(|| exact(run.spec.frequency, 3)),
        peak => findings.peak.is_some_and(|peak| peak.run == index),
        rmsd => percent(deviation.rmsd),
        most => percent(deviation.maximum_absolute),
        oscillation => percent(run.fast.oscillation),
        means => FORCES.map(|force| cell(experiment, run, force)),
        samples => run.fast.output.samples,
        readings => run.readings,
    }
}

fn offsets(findings: &Findings, index: usize, run: &Run) -> Option<Value> {
    let cell = |force: Channel| {
        findings.offset(index, force).map(|offset| {
            context! {
                text => pair(1e3 * offset.value, 1e3 * offset.error),
                ratio => exact(offset.ratio(), 1),
                seen => offset.is_seen(),
            }
        })
    };
    let cells = FORCES.map(cell);
    cells.iter().any(Option::is_some).then(|| {
        context! { name => &run.spec.name, frequency => exact(run.spec.frequency, 3), cells,
        peak => findings.peak.is_some_and(|peak| peak.run == index) }
    })
}

fn drifts(experiment: &Experiment, findings: &Findings) -> Vec<Value> {
    let one = |drift: &crate::experiment::Drift| {
        context! {
            force => drift.force.name(),
            change => drift.preloads.map(|offset| pair(1e3 * offset.value, 1e3 * offset.error)),
            percent => drift.preloads.map(|offset| exact(experiment.percent(offset.value), 4)),
            seen => drift.preloads.is_some_and(|offset| offset.is_seen()),
            slope => drift.trend.map(|trend| exact(1e3 * trend.slope, 3)),
            p => drift.trend.map(|trend| probability(trend.p)),
        }
    };
    findings.drifts.iter().map(one).collect()
}

fn spring(experiment: &Experiment) -> Vec<[String; 3]> {
    let line = &experiment.line;
    let row = |name: &str, value: String, how: &str| [name.to_owned(), value, how.to_owned()];
    let error = |error: Option<f64>| error.map_or(String::new(), |error| format!(" ± {}", digits(error)));
    let from = |given: bool| if given { "given" } else { "from the calibration run" };
    let se = line.fit.filter(|_| experiment.spec.stiffness.is_none()).and_then(|fit| fit.stiffness_se);
    let mut rows = vec![
        row(
            "k, stiffness",
            format!("{}{} N/m", exact(line.stiffness, 3), error(se)),
            from(experiment.spec.stiffness.is_some()),
        ),
        row("l0, length at zero force", format!("{} mm", exact(1e3 * line.length_at_zero_force, 3)), "given"),
        row(
            "length where positions read zero",
            format!("{} mm", exact(1e3 * line.length_at_zero, 3)),
            from(experiment.spec.length_at_zero.is_some()),
        ),
    ];
    if let Some(fit) = line.fit {
        let rows_of = "root mean square of the residuals";
        rows.push(row("F_o in the calibration run", format!("{} mN", digits(1e3 * fit.rmse)), rows_of));
    }
    let (calibration, fit, through) = match &experiment.curve {
        Some(Curve::InverseLength { calibration, fit, through }) => (calibration, fit, *through),
        Some(Curve::Stored(stored)) => {
            let [shortest, longest] = stored.lengths().map(|length| exact(1e3 * length, 1));
            rows.push(row("length from L", stored.name.clone(), &format!("from {shortest} to {longest} mm")));
            return rows;
        }
        None => return rows,
    };
    let how = match (fit, through) {
        (None, _) => "given".to_owned(),
        (Some(fit), Some((length, _))) => format!(
            "from the calibration run, through the preload at {} mm; {} mm RMS",
            exact(1e3 * length, 3),
            digits(1e3 * fit.misfit.rmse)
        ),
        (Some(fit), None) => format!("from the calibration run; {} mm RMS", digits(1e3 * fit.misfit.rmse)),
    };
    let number = |value: f64, error: Option<f64>| crate::calibration::with_error(value, error);
    let (alpha, beta) = (calibration.alpha(), calibration.beta());
    let fit = fit.as_ref();
    rows.push(row("α of 1/l = αL + β", format!("{} 1/(H m)", number(alpha, fit.and_then(|fit| fit.alpha_se))), &how));
    rows.push(row("β", format!("{} 1/m", number(beta, fit.and_then(|fit| fit.beta_se))), &how));
    rows
}
