//! The answer in a few lines: which sensor, at which end, meets the goal; which condition breaks it. Beside it, what would meet it.
//!
//! Next door: what its figures hang on (`doubts`), names and places (`words`), the whole report (`report`).

use super::budget::OSCILLATION;
use super::doubts::{as_chain, exact_rate, masses, rebound, unjudged, untold, without_limits};
use super::verdict::Verdict;
use super::words::{case_name, force, name, of_specimens, place, several, wish};
use super::{Analysis, Fix, Subject};
use crate::quantity::{digits, plainly};

/// The answer, one sentence or two per line, at most eight lines.
pub fn answer(analysis: &Analysis) -> Vec<String> {
    let mut lines = vec![best(analysis)];
    lines.extend(failing(analysis));
    lines.extend(without_limits(analysis));
    lines.extend(untold(analysis));
    lines.extend(exact_rate(analysis));
    lines.extend(masses(analysis));
    lines.extend(as_chain(analysis));
    lines.extend(rebound(analysis));
    lines.push(damping(analysis));
    lines.push(warned(analysis));
    lines
}

/// Which share of the specimens is inside the goal all the same.
fn inside(verdict: &Verdict) -> String {
    match verdict.least_inside() {
        Some(share) if share > 0.0 => format!("{} of the springs meet it", of_specimens(share)),
        _ => "no spring within tolerance meets it".to_owned(),
    }
}

fn best(analysis: &Analysis) -> String {
    let Some(first) = analysis.verdicts.first() else { return String::new() };
    let of = analysis.verdicts.len();
    let at_most = |verdict: &Verdict| {
        let (most, place) = (force(analysis, verdict.combined()), place(analysis, verdict));
        format!("at most {most} in {place}{}", unjudged(analysis, verdict))
    };
    let (name_of_first, most) = (name(analysis, first), at_most(first));
    let Some(goal) = analysis.spec.goal.error else {
        let least = if of == 1 { "" } else { "Least uncertain is " };
        return format!(
            "{least}{name_of_first}, with a standard uncertainty of {most}. The spec sets no [goal], so nothing is judged."
        );
    };
    let wanted = match analysis.spec.goal.bandwidth {
        Some(bandwidth) => format!("{} up to {} Hz", wish(analysis, goal), plainly(bandwidth)),
        None => wish(analysis, goal),
    };
    let meeting: Vec<&Verdict> = analysis.verdicts.iter().filter(|v| v.meets_always() == Some(true)).collect();
    let Some(best) = meeting.first() else {
        let none = match of {
            1 => format!("{name_of_first} does not meet the goal of {wanted}"),
            _ => format!("No sensor meets the goal of {wanted}; nearest is {name_of_first}"),
        };
        let yet = if first.overload.is_some() { ", and it is overloaded" } else { "" };
        return format!("{none}: its standard uncertainty is {most}{yet}.");
    };
    let all = match (meeting.len(), of) {
        (1, 1) => "It meets".to_owned(),
        (2, 2) => "Both sensors meet".to_owned(),
        (all, of) if all == of => format!("All {of} sensors meet"),
        (1, of) => format!("One of {of} sensors meets"),
        (some, of) => format!("{some} of {of} sensors meet"),
    };
    let (best_name, most) = (name(analysis, best), at_most(best));
    let (behind, specimens) = (behind(analysis, best), specimens(best));
    format!(
        "Choose {best_name}{behind}. {all} the goal of {wanted}. Standard uncertainty of {best_name}: {most}{}.{specimens}",
        ties(analysis, &meeting)
    )
}

/// Uncertainties that differ by no more than this share are alike: a limit of error alone is not known more closely.
const ALIKE: f64 = 0.05;

/// `; laser has about as much (0.439 N)`: what meets the goal as well as the first that does.
fn ties(analysis: &Analysis, meeting: &[&Verdict]) -> String {
    let Some((best, others)) = meeting.split_first() else { return String::new() };
    let is_alike = |other: &&&Verdict| {
        other.has_limits == best.has_limits
            && other.sooner.is_none() == best.sooner.is_none()
            && other.combined() <= (1.0 + ALIKE) * best.combined()
    };
    let alike: Vec<&&Verdict> = others.iter().filter(is_alike).collect();
    let names: Vec<&str> = alike.iter().map(|other| name(analysis, other)).collect();
    let (have, most) = match alike.as_slice() {
        [] => return String::new(),
        [one] => ("has", digits(one.combined())),
        [.., last] => ("have", format!("up to {}", digits(last.combined()))),
    };
    format!("; {} {have} about as much ({most} N)", several(&names))
}

/// `, behind a low-pass of order 8 at 20 Hz (41 ms late; without it 11.1 N rms in resonance)`.
fn behind(analysis: &Analysis, verdict: &Verdict) -> String {
    let Some(filter) = verdict.filter else { return String::new() };
    format!(
        ", behind a Butterworth low-pass of order {} at {} Hz (which comes {:.0} ms late; without it {} N rms in {})",
        filter.order,
        plainly(filter.bandwidth),
        1e3 * filter.lag,
        digits(filter.raw),
        case_name(analysis, filter.case),
    )
}

/// ` Of the springs within tolerance 97 % meet the goal; the worst errs by 1.3 N, the nominal one by 0.4 N.`
fn specimens(verdict: &Verdict) -> String {
    let (worst, Some(inside)) = (verdict.at_worst(), verdict.least_inside()) else { return String::new() };
    format!(
        " Of the springs within tolerance {} meet the goal; the worst errs by {} N, the nominal one by {} N.",
        of_specimens(inside),
        digits(worst.worst),
        digits(worst.nominal),
    )
}

/// Those that miss the goal, and where; those that miss it alike share the words.
fn failing(analysis: &Analysis) -> Option<String> {
    let mut each: Vec<(Vec<&str>, String)> = Vec::new();
    for verdict in analysis.verdicts.iter().filter(|verdict| verdict.meets_always() == Some(false)) {
        let how = missed(analysis, verdict);
        match each.iter_mut().find(|(_, other)| *other == how) {
            Some((names, _)) => names.push(name(analysis, verdict)),
            None => each.push((vec![name(analysis, verdict)], how)),
        }
    }
    let each: Vec<String> = each.into_iter().map(|(names, how)| format!("{} ({how})", several(&names))).collect();
    if each.is_empty() { None } else { Some(format!("Missed by: {}.", each.join("; "))) }
}

/// By how much and where a sensor misses the goal, and why.
fn missed(analysis: &Analysis, verdict: &Verdict) -> String {
    if let Some(most) = verdict.overload {
        let overloaded = format!("overloaded at {} N", digits(most));
        let goal = analysis.spec.goal.error.unwrap_or(f64::INFINITY);
        if verdict.combined() <= goal {
            return overloaded;
        }
        return format!("{overloaded}, and {} N off in {}", digits(verdict.combined()), place(analysis, verdict));
    }
    if verdict.too_slow && verdict.meets.iter().all(|meets| *meets) {
        return format!("reaches {} Hz only", digits(verdict.bandwidth));
    }
    format!(
        "{} N in {}, mostly {}; {}",
        digits(verdict.combined()),
        place(analysis, verdict),
        cause(verdict),
        inside(verdict),
    )
}

/// Why a mean error is there, where that is it.
const BENDS: &str = " since the coil's force is no straight line";

/// What the uncertainty of the worst case is mostly made of: a mean error, or the largest line of the budget.
fn cause(verdict: &Verdict) -> String {
    let budget = &verdict.budget.budget;
    let largest = budget.contributions().iter().max_by(|a, b| a.contribution.total_cmp(&b.contribution));
    match largest {
        Some(line) if line.contribution >= budget.bias().abs() => match line.name.as_ref() {
            OSCILLATION if verdict.by_readout => "its own lag".to_owned(),
            name => name.to_owned(),
        },
        _ => {
            let why = if (budget.bias() - verdict.budget.bend).abs() < 0.5 * budget.bias().abs() { BENDS } else { "" };
            format!("a mean error of {} N{why}", digits(budget.bias()).replace('-', "−"))
        }
    }
}

/// For each sensor that misses the goal, best first: what would make it meet it, the soonest first and at most two; `None` where no single
/// change that was tried does.
pub fn changes_that_meet(analysis: &Analysis) -> Vec<(&str, Option<&Fix>)> {
    let failing = analysis.verdicts.iter().filter(|verdict| verdict.meets_always() == Some(false));
    let rows = failing.flat_map(|verdict| {
        let fixes: Vec<Option<&Fix>> = match verdict.fixes.as_slice() {
            [] => vec![None],
            some => some.iter().take(2).map(Some).collect(),
        };
        fixes.into_iter().map(|fix| (name(analysis, verdict), fix))
    });
    rows.collect()
}

fn damping(analysis: &Analysis) -> String {
    let dampings = &analysis.spec.mount.cases;
    if !analysis.spec.mount.is_band {
        let labels: Vec<&str> = dampings.iter().map(|case| case.label.as_str()).collect();
        let between = if labels.iter().any(|label| label.contains(',')) { "; " } else { ", " };
        return format!("Damping as the spec says: {}.", labels.join(between));
    }
    let turn: Vec<String> = analysis
        .verdicts
        .iter()
        .filter(|verdict| verdict.meets.iter().any(|m| *m) && verdict.meets.iter().any(|m| !m))
        .map(|verdict| {
            let meeting =
                verdict.meets.iter().zip(dampings).filter(|(meets, _)| **meets).map(|(_, case)| case.label.as_str());
            format!("{} meets it at {} only", name(analysis, verdict), meeting.collect::<Vec<_>>().join(", "))
        })
        .collect();
    let band = "No damping given: results are the worst case over ζ = 0 (the paper's case) to 0.02";
    if turn.is_empty() { format!("{band}.") } else { format!("{band}; {}.", turn.join("; ")) }
}

fn warned(analysis: &Analysis) -> String {
    let count = |subject| analysis.warnings.iter().filter(|warning| warning.subject == subject).count();
    let kinds = [
        (Subject::Resonance, "a natural frequency of the real spring may coincide with the input's"),
        (Subject::NoLimit, "the rms of a step has no limit"),
        (Subject::Window, "a window begins after the loudest part"),
        (Subject::Clash, "windings touch"),
        (Subject::Contact, "windings meet, ends leave their seats, or a follower its cam"),
        (Subject::Length, "a length leaves the range in use"),
        (Subject::Lift, "an end that only pushes would have to pull"),
        (Subject::Doubt, "values of the spring do not fit together, or are unusual"),
        (Subject::Instrument, "an instrument has no limit of error"),
        (Subject::Alias, "surge lines alias"),
        (Subject::Range, "a load cell is overloaded, or its range is not given"),
        (Subject::Magnetisation, "the wire may be more magnetic than what is computed"),
        (Subject::Temperature, "a drift with temperature is not known"),
        (Subject::Neighbour, "the coil rings in other modes too"),
    ];
    let each: Vec<&str> = kinds.into_iter().filter(|(subject, _)| count(*subject) > 0).map(|(_, text)| text).collect();
    if each.is_empty() { "No warnings.".to_owned() } else { format!("See the warnings: {}.", each.join("; ")) }
}
