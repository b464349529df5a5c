//! `report.html`: one page that needs no other file and no network; the answer first.
//!
//! Next door: its layout (`page.html`), its figures (`figures`), its interactive part (`viewer_data`, `report/viewer`).

use coilsense::Channel;
use minijinja::{Value, context};
use rayon::prelude::*;

use super::figures;
use super::frequency::over_frequency;
use super::text::{analysis_warnings, answered};
use super::viewer_data::viewer_json;
use crate::analysis::{Analysis, Fix, Verdict, changes_that_meet};
use crate::helix::{ModeLine, ModesAt, UnderEnds};
use crate::quantity::{digits, plainly};
use crate::report::ReportError;
use crate::report::page::{self, drawn};
use crate::report::prose::{file_name, unbroken};
use crate::spec::Spec;

/// The page of an analysis.
pub(super) fn page(analysis: &Analysis, date: &str) -> Result<String, ReportError> {
    let spec = &analysis.spec;
    let conditions: Vec<usize> = (0..spec.conditions.len()).collect();
    let verdicts: Vec<Value> =
        analysis.verdicts.par_iter().map(|verdict| verdict_value(analysis, verdict)).collect::<Result<_, _>>()?;
    Ok(page::page(
        include_str!("page.html"),
        context! {
            date,
            spring => &spec.spring.name,
            file => file_name(&spec.file),
            text => &spec.text,
            answer => answered(analysis).iter().map(|line| unbroken(line)).collect::<Vec<_>>(),
            goal => goal(analysis),
            changes => changes(analysis),
            warnings => analysis_warnings(analysis),
            ranking => drawn("ranking", &figures::ranking(analysis))?,
            verdicts,
            dampings => spec.mount.cases.iter().map(|case| case.label.clone()).collect::<Vec<_>>(),
            is_band => spec.mount.is_band,
            rows => conditions.iter().map(|&condition| condition_value(analysis, condition)).collect::<Vec<_>>(),
            figures => conditions.par_iter().map(|&condition| figures_of(analysis, condition)).collect::<Result<Vec<_>, _>>()?,
            frequency => frequency(spec)?,
            frequency => frequency(spec)?,
        contact => contact_value(analysis)?,
            series => super::SERIES.0,
            meets => spec.mount.cases.iter().any(|case| case.contact.is_some()),
            groups => groups(analysis),
            surge => surge(analysis),
            modes_at => modes_at(analysis),
            modes => super::modes_figure::modes(analysis).map(|figure| drawn("modes", &figure)).transpose()?,
            material => &analysis.data_sheet.material,
            reference => spec.goal.force.name(),
            nominal => digits(spec.spring.spring.nominal_force()),
            coverage => plainly(100.0 * spec.uncertainty.coverage),
            trials => spec.uncertainty.trials,
            seed => spec.uncertainty.seed,
            temperature => plainly(spec.uncertainty.temperature_change),
            remarks => remarks(spec),
            viewer_style => include_str!("../viewer/viewer.css"),
            viewer => include_str!("../viewer/viewer.js"),
            data => viewer_json(analysis)?,
        },
    )?)
}

/// What would make the sensors meet the goal that miss it.
fn changes(analysis: &Analysis) -> Vec<Value> {
    let row = |(sensor, fix): (&str, Option<&Fix>)| match fix {
        Some(fix) => {
            context! { sensor, change => &fix.change, newton => digits(fix.combined), lag => format!("{:.1}", 1e3 * fix.lag) }
        }
        None => context! { sensor, change => "no single change that was tried", newton => "–", lag => "–" },
    };
    changes_that_meet(analysis).into_iter().map(row).collect()
}

/// What each recorded input says of itself: conditions that read one file share a line.
fn remarks(spec: &Spec) -> Vec<String> {
    let mut shared: Vec<(Vec<&str>, String)> = Vec::new();
    for condition in spec.conditions.iter().filter(|condition| !condition.remarks.is_empty()) {
        let said = condition.remarks.join("; ");
        match shared.iter_mut().find(|(_, text)| *text == said) {
            Some((names, _)) => names.push(&condition.name),
            None => shared.push((vec![&condition.name], said)),
        }
    }
    shared.into_iter().map(|(names, said)| format!("{}: {said}.", names.join(", "))).collect()
}

/// `1.22 N (1 % of F_nom) up to 20 Hz`, where there is a goal.
fn goal(analysis: &Analysis) -> Option<String> {
    let spec = &analysis.spec;
    let error = spec.goal.error?;
    let percent = plainly(100.0 * error / spec.spring.spring.nominal_force());
    let band = spec.goal.bandwidth.map_or(String::new(), |bandwidth| format!(" up to {} Hz", plainly(bandwidth)));
    Some(format!("{} N ({percent} % of F_nom){band}", plainly(error)))
}

fn verdict_value(analysis: &Analysis, verdict: &Verdict) -> Result<Value, ReportError> {
    let spec = &analysis.spec;
    let (sensor, worst) = (&analysis.sensors[verdict.sensor], &analysis.cases[verdict.worst]);
    let budget = &verdict.budget;
    let lines: Vec<Value> = budget
        .budget
        .contributions()
        .iter()
        .map(|line| {
            context! {
                name => line.name.as_ref(),
                standard => scientific(line.standard_uncertainty),
                sensitivity => scientific(line.sensitivity),
                contribution => digits(line.contribution),
                share => format!("{:.0}", 100.0 * line.share),
            }
        })
        .collect();
    let fixes: Vec<Value> = verdict
        .fixes
        .iter()
        .map(|fix| context! { change => &fix.change, combined => digits(fix.combined), lag => format!("{:.1}", 1e3 * fix.lag) })
        .collect();
    let figure = drawn(&format!("budget of {}", sensor.name), &figures::budget(analysis, verdict))?;
    Ok(context! {
        name => &sensor.name,
        kind => sensor.quantity.kind(),
        percent => digits(100.0 * verdict.combined() / spec.spring.spring.nominal_force()),
        newton => digits(verdict.combined()),
        nominal => digits(verdict.at_worst().nominal),
        worst_specimen => digits(verdict.at_worst().worst),
        inside => verdict.least_inside().map(|share| format!("{:.0}", 100.0 * share)),
        filter => verdict.filter.map(|filter| format!(
            "a Butterworth low-pass of order {} at {} Hz, which comes {:.0} ms late (counted in the lag); without it {} N rms in {}",
            filter.order, digits(filter.bandwidth), 1e3 * filter.lag, digits(filter.raw),
            spec.conditions[analysis.cases[filter.case].condition].name,
        )),
        meets => verdict.meets_always(),
        too_slow => verdict.too_slow,
        overload => verdict.overload.map(digits),
        by_damping => spec.mount.cases.iter().zip(&verdict.meets).map(|(case, meets)| context! { label => &case.label, meets }).collect::<Vec<_>>(),
        bandwidth => if verdict.bandwidth.is_finite() { digits(verdict.bandwidth) } else { "no limit".to_owned() },
        lag => format!("{:.2}", 1e3 * verdict.lag),
        worst => format!("{}, {}", spec.conditions[worst.condition].name, spec.mount.cases[worst.damping].label),
        fixes,
        lines,
        figure,
        force => digits(budget.force),
        bias => digits(budget.budget.bias()),
        combined => digits(budget.budget.combined()),
        coverage_factor => format!("{:.2}", budget.coverage_factor),
        expanded => digits(budget.expanded),
        monte_carlo => digits(budget.standard),
        interval => format!("{:.2} … {:.2}", budget.interval.0, budget.interval.1),
        agrees => budget.agreement.holds(),
        decided => budget.agreement.decided(),
        difference => digits(budget.agreement.low.max(budget.agreement.high)),
        tolerance => digits(budget.agreement.tolerance),
    })
}

/// A number over many decades: three significant digits, with a power of ten where that is shorter.
fn scientific(value: f64) -> String {
    // The root of a variance that is zero but for the last digit.
    if value.abs() < 1e-100 {
        return "0".to_owned();
    }
    if (1e-3..1e5).contains(&value.abs()) { digits(value) } else { format!("{value:.2e}") }
}

/// Percent as a table shows it: three significant digits, but no more than three decimals.
fn percent_text(percent: f64) -> String {
    match percent.abs() {
        tiny if tiny < 5e-4 => "0".to_owned(),
        small if small < 1.0 => format!("{percent:.3}"),
        _ => digits(percent),
    }
}

/// A condition's rows in the table of measures: each force and each sensor, one cell per damping.
fn condition_value(analysis: &Analysis, condition: usize) -> Value {
    let spec = &analysis.spec;
    let nominal = spec.spring.spring.nominal_force();
    let dampings = 0..spec.mount.cases.len();
    let percent = |newton: f64| percent_text(100.0 * newton / nominal);
    let of_force = |force: Channel| {
        let cells = dampings.clone().filter_map(|damping| {
            let (_, deviation) = analysis.case(condition, damping)?.ideal.iter().find(|(of, _)| *of == force)?;
            Some(context! {
                rmsd => percent(deviation.rmsd), most => percent(deviation.maximum_absolute), mean => percent(deviation.mean),
            })
        });
        context! { name => force.name(), ideal => true, cells => cells.collect::<Vec<_>>() }
    };
    let of_sensor = |(index, name): (usize, &str)| {
        let verdict = analysis.verdicts.iter().find(|verdict| verdict.sensor == index);
        let cells = dampings.clone().filter_map(|damping| {
            let deviation = analysis.case(condition, damping)?.readings[index].deviation;
            let combined = verdict?.assessments[condition * spec.mount.cases.len() + damping].combined;
            let over = spec.goal.error.is_some_and(|goal| combined > goal);
            Some(context! {
                rmsd => percent(deviation.rmsd), most => percent(deviation.maximum_absolute), mean => percent(deviation.mean),
                combined => percent(combined), over,
            })
        });
        context! { name, ideal => false, cells => cells.collect::<Vec<_>>() }
    };
    let forces = Channel::FORCES.into_iter().filter(|force| *force != spec.goal.force).map(of_force);
    let sensors = analysis.sensors.iter().map(|sensor| sensor.name.as_str()).enumerate().map(of_sensor);
    let asked = &spec.conditions[condition];
    context! {
        name => &asked.name,
        kind => asked.kind,
        window => format!("{}–{} s", asked.window.0, asked.window.1),
        rows => forces.chain(sensors).collect::<Vec<_>>(),
    }
}

/// Spectrum, force over length and winding map of a condition, at the first damping: the largest ringing.
fn figures_of(analysis: &Analysis, condition: usize) -> Result<Value, ReportError> {
    let name = &analysis.spec.conditions[condition].name;
    let shown = 0;
    let spectrum = figures::spectra(analysis, condition, shown);
    let spectrum = spectrum.map(|figure| drawn(&format!("spectrum of {name}"), &figure)).transpose()?;
    let map = analysis.case(condition, shown).and_then(figures::map);
    let map = map.map(|figure| drawn(&format!("map of {name}"), &figure)).transpose()?;
    let over_length = analysis.case(condition, shown).and_then(figures::over_length);
    let over_length = over_length.map(|figure| drawn(&format!("force over length in {name}"), &figure)).transpose()?;
    Ok(context! { name, damping => &analysis.spec.mount.cases[shown].label, spectrum, over_length, map })
}

/// How far off forces are over frequency, where the spring has such a response.
fn frequency(spec: &Spec) -> Result<Option<Value>, ReportError> {
    let Some(found) = over_frequency(spec) else { return Ok(None) };
    Ok(Some(context! { figure => drawn("frequency", &found.figure)?, caption => unbroken(&found.caption) }))
}

/// What met, of all cases and of the busiest; `None` where nothing did.
fn contact_value(analysis: &Analysis) -> Result<Option<Value>, ReportError> {
    let Some((case, contacts)) = super::contact::busiest(analysis) else { return Ok(None) };
    let spec = &analysis.spec;
    Ok(Some(context! {
        rows => super::contact::rows(analysis),
        condition => &spec.conditions[case.condition].name,
        way => &spec.mount.cases[case.damping].label,
        figure => drawn("contact", &super::contact::figure(case, contacts))?,
        tables => super::contact::tables(contacts),
        apart => digits(contacts.apart),
        has_floats => analysis.cases.iter().filter_map(|case| case.contacts.as_ref()).any(|contacts| !contacts.floats.is_empty()),
    }))
}

fn groups(analysis: &Analysis) -> Vec<Value> {
    let group = |(heading, rows): &(&'static str, Vec<crate::data_sheet::Row>)| {
        let row =
            |row: &crate::data_sheet::Row| context! { label => row.label, shown => row.shown(), unit => row.unit };
        context! { heading => *heading, rows => rows.iter().map(row).collect::<Vec<_>>() }
    };
    analysis.data_sheet.groups.iter().map(group).collect()
}

fn surge(analysis: &Analysis) -> Vec<Value> {
    let hertz = |values: &[f64]| values.iter().map(|value| format!("{value:.2}")).collect::<Vec<_>>();
    let mount = |mount: &crate::data_sheet::MountFrequencies| {
        context! {
            mount => &mount.mount,
            own => mount.is_the_specs,
            chain => hertz(&mount.chain_hz),
            continuous => hertz(&mount.continuous_hz),
            rule => mount.third_rule_error_percent.map(|error| format!("{error:+.2} %")),
        }
    };
    analysis.data_sheet.surge.iter().map(mount).collect()
}

/// The modes at each length, one way of the ends after the other.
fn modes_at(analysis: &Analysis) -> Vec<Value> {
    let number = |value: Option<f64>, scale: f64| value.map_or_else(|| "–".to_owned(), |value| digits(scale * value));
    let row = |mode: &ModeLine| {
        context! {
            frequency => format!("{:.2}", mode.frequency_hz),
            kind => mode.kind,
            strength => digits(100.0 * mode.axial_strength),
            side => number(mode.side_force_n_per_n, 1.0),
            couple => number(mode.couple_m, 1e3),
        }
    };
    let of = |at: &ModesAt, way: &UnderEnds| {
        context! {
            length => format!("{:.1}", 1e3 * at.length_m),
            ends => &way.ends,
            buckles => way.buckles,
            rows => way.modes.iter().take(MODES_SHOWN).map(row).collect::<Vec<_>>(),
        }
    };
    analysis.data_sheet.modes_at.iter().flat_map(|at| at.ways().map(move |way| of(at, way))).collect()
}

/// Modes that a table holds.
const MODES_SHOWN: usize = 10;
