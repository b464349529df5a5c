//! What the answer's sentences are made of: names, forces, places.
//!
//! Next door: the sentences (`answer`, `doubts`).

use super::Analysis;
use super::verdict::Verdict;
use crate::quantity::{digits, plainly};

pub(super) fn name<'a>(analysis: &'a Analysis, verdict: &Verdict) -> &'a str {
    &analysis.sensors[verdict.sensor].name
}

/// `1.23 N (1.01 % of F_nom)`.
pub(super) fn force(analysis: &Analysis, newton: f64) -> String {
    let nominal = analysis.spec.spring.spring.nominal_force();
    format!("{} N ({} % of F_nom)", digits(newton), digits(100.0 * newton / nominal))
}

/// `1.22 N (1 % of F_nom)`.
pub(super) fn wish(analysis: &Analysis, newton: f64) -> String {
    let nominal = analysis.spec.spring.spring.nominal_force();
    format!("{} N ({} % of F_nom)", plainly(newton), plainly(100.0 * newton / nominal))
}

/// A condition, and under which damping where there are several.
pub(super) fn case_name(analysis: &Analysis, number: usize) -> String {
    let case = &analysis.cases[number];
    let condition = &analysis.spec.conditions[case.condition].name;
    let dampings = &analysis.spec.mount.cases;
    if dampings.len() > 1 { format!("{condition}, {}", dampings[case.damping].label) } else { condition.clone() }
}

/// The same of a sensor's worst case, and whether it lies beyond contact.
pub(super) fn place(analysis: &Analysis, verdict: &Verdict) -> String {
    let case = &analysis.cases[verdict.worst];
    let place = case_name(analysis, verdict.worst);
    match &case.contacts {
        Some(contacts) if !contacts.floats.is_empty() => format!("{place}, where the follower leaves its cam"),
        Some(contacts) if contacts.touches.is_empty() => place,
        Some(_) => format!("{place}, where windings meet"),
        None if case.clash.happens() => format!("{place}, where windings would touch"),
        None => place,
    }
}

/// A share of specimens in words.
pub(super) fn of_specimens(share: f64) -> String {
    match share {
        all if all >= 1.0 => "all".to_owned(),
        none if none <= 0.0 => "none".to_owned(),
        many if many > 0.99 => "more than 99 %".to_owned(),
        few if few < 0.01 => "less than 1 %".to_owned(),
        share => format!("{:.0} %", 100.0 * share),
    }
}

/// `a`, `a and b`; names that have commas themselves are told apart.
pub(crate) fn several(names: &[&str]) -> String {
    let marked: Vec<String> = match names {
        [one] => vec![(*one).to_owned()],
        many if many.iter().any(|name| name.contains(',')) => many.iter().map(|name| format!("“{name}”")).collect(),
        many => many.iter().map(|name| (*name).to_owned()).collect(),
    };
    match marked.split_last() {
        Some((last, before)) if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        _ => marked.concat(),
    }
}
