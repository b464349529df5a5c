//! `report.html` of a mitigation: one page that needs no other file and no network; the advice first.
//!
//! Next door: its layout (`page.html`), its figures (`figures`), the same as text (`text`).

use minijinja::{Value, context};

use super::shaping::{percent as share, shaping_advice};
use super::text::{advice, conditions, judged, notes, percent};
use super::{EXPORTS, figures};
use crate::mitigation::{Ranking, Shaping, Truth};
use crate::quantity::digits;
use crate::report::page::{self, drawn};
use crate::report::{Drawn, ReportError};
use crate::spec::Spec;

/// The page of a mitigation.
pub(super) fn page(answer: &Ranking, spec: &Spec, date: &str, trade_off: &Drawn) -> Result<String, ReportError> {
    let study = &answer.study;
    Ok(page::page(
        include_str!("page.html"),
        context! {
            date,
            spring => &spec.spring.name,
            file => std::path::Path::new(&spec.file).file_name().map(|name| name.to_string_lossy()),
            log => study.recorded.as_ref().map(|log| &log.name),
            text => &spec.text,
            answer => advice(answer).lines().map(str::to_owned).chain(notes(answer).iter().cloned()).collect::<Vec<_>>(),
            groups => judged(answer).into_iter().map(|truth| group(answer, truth)).collect::<Vec<_>>(),
            left_out => answer.left_out.iter().map(|it| context! { name => &it.name, reason => &it.reason }).collect::<Vec<_>>(),
            conditions => conditions(answer),
            nominal_force => digits(study.spring.nominal_force()),
            bandwidth => digits(study.bandwidth),
            rate => digits(study.rate),
            trade_off => context! { light => &trade_off.light, dark => &trade_off.dark },
            over_time => figures::over_time(answer).map(|figure| drawn("over-time", &figure)).transpose()?,
            run => answer.shown.as_ref().map(|shown| &shown.label),
            exports => exports(answer),
            shaping => answer.shaping.as_ref().map(shaping),
        },
    )?)
}

/// The ranking of those that are to give one force.
fn group(answer: &Ranking, truth: Truth) -> Value {
    let best = answer.best(truth).map(|(candidate, _)| candidate.name.as_str());
    let those = answer.judged.iter().filter(|(candidate, _)| candidate.truth == truth);
    let rows = those.map(|(candidate, judgement)| {
        context! {
            name => &candidate.name,
            advised => best == Some(candidate.name.as_str()),
            origin => candidate.origin.name(),
            nominal => format!("{:.3}", percent(answer, judgement.nominal)),
            worst => format!("{:.3}", percent(answer, judgement.worst)),
            worst_run => &judgement.worst_run,
            aligned => format!("{:.3}", percent(answer, judgement.aligned)),
            delay => format!("{:.1}", 1e3 * judgement.delay),
            lag => format!("{:.1}", (10.0 * judgement.lag.to_degrees()).round() / 10.0 + 0.0),
            late => judgement.lag > answer.study.most_lag,
            noise => format!("{:.3}", judgement.noise_gain),
            settling => format!("{:.1}", 1e3 * judgement.settling),
        }
    });
    let title = match truth {
        Truth::Static => "Filters of F_i, against k·Δl",
        Truth::Output => "Estimators, against F_o",
    };
    context! { title, rows => rows.collect::<Vec<_>>() }
}

/// Shaped commands.
fn shaping(shaping: &Shaping) -> Value {
    let best = shaping.best().map(|best| best.name);
    let rows = shaping.shapers.iter().map(|shaped| {
        context! {
            name => shaped.name,
            advised => best == Some(shaped.name),
            first => share(shaped.first),
            worst => share(shaped.first_worst),
            worst_case => &shaped.worst_case,
            higher => share(shaped.higher_worst),
            delay => format!("{:.1}", 1e3 * shaped.delay),
            length => format!("{:.1}", 1e3 * shaped.length),
        }
    });
    let left_out = shaping.left_out.iter().map(|it| context! { name => &it.name, reason => &it.reason });
    context! {
        advice => shaping_advice(shaping),
        rows => rows.collect::<Vec<_>>(),
        left_out => left_out.collect::<Vec<_>>(),
    }
}

/// What is exported, and how a controller calls it.
fn exports(answer: &Ranking) -> Vec<Value> {
    let each = EXPORTS.into_iter().filter_map(|(truth, name)| {
        let (candidate, _) = answer.best(truth)?;
        let settings = candidate.settings()?;
        let upper = name.to_ascii_uppercase();
        let ring = settings.ring().map_or(String::new(), |_| format!("::<{upper}_RING>"));
        let (first, each, taken) = match truth {
            Truth::Static => ("first_force", "force", "force"),
            Truth::Output => ("&first", "&Measured { force, ends: [u1, u2] }", "force, u1, u2"),
        };
        // An estimator of modes gives more than the force.
        let field = if settings.kind().contains("Kalman") { ".output" } else { "" };
        Some(context! {
            name,
            candidate => &candidate.name,
            kind => settings.kind(),
            rust => format!(
                "let mut state = {upper}.settled{ring}({first});\nlet estimate = {upper}.step(&mut state, {each}){field};"
            ),
            c => format!(
                "static {name}_state state;\n{name}_settle(&state, {taken});\n{name}_real estimate = {name}_step(&state, {taken}){field};"
            ),
        })
    });
    each.collect()
}
