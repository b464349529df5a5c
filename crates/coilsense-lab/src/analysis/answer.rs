//! The answer in five lines: which sensor, at which end, meets the goal; which condition breaks it; what would fix it.
//!
//! Next door: the whole report (`report`).

use super::verdict::Verdict;
use super::{Analysis, Subject};
use crate::quantity::{digits, plainly};

/// The answer, one sentence or two per line, at most five lines.
pub fn answer(analysis: &Analysis) -> Vec<String> {
    let mut lines = vec![best(analysis)];
    lines.extend(failing(analysis));
    lines.extend(fixes(analysis));
    lines.push(damping(analysis));
    lines.push(warned(analysis));
    lines
}

fn name<'a>(analysis: &'a Analysis, verdict: &Verdict) -> &'a str {
    &analysis.sensors[verdict.sensor].name
}

/// `1.23 N (1.01 % of F_nom)`.
fn force(analysis: &Analysis, newton: f64) -> String {
    let nominal = analysis.spec.spring.spring.nominal_force();
    format!("{} N ({} % of F_nom)", digits(newton), digits(100.0 * newton / nominal))
}

/// `1.22 N (1 % of F_nom)`.
fn wish(analysis: &Analysis, newton: f64) -> String {
    let nominal = analysis.spec.spring.spring.nominal_force();
    format!("{} N ({} % of F_nom)", plainly(newton), plainly(100.0 * newton / nominal))
}

/// In which condition, and under which damping where there are several.
fn place(analysis: &Analysis, verdict: &Verdict) -> String {
    let case = &analysis.cases[verdict.worst];
    let condition = &analysis.spec.conditions[case.condition].name;
    let dampings = &analysis.spec.mount.cases;
    let place =
        if dampings.len() > 1 { format!("{condition}, {}", dampings[case.damping].label) } else { condition.clone() };
    if case.clash.happens() { format!("{place}, where windings would touch") } else { place }
}

fn best(analysis: &Analysis) -> String {
    let Some(first) = analysis.verdicts.first() else { return String::new() };
    let of = analysis.verdicts.len();
    let at_most =
        |verdict: &Verdict| format!("at most {} in {}", force(analysis, verdict.combined()), place(analysis, verdict));
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
        return format!("{none}: its standard uncertainty is {most}.");
    };
    let all = match (meeting.len(), of) {
        (1, 1) => "It meets".to_owned(),
        (2, 2) => "Both sensors meet".to_owned(),
        (all, of) if all == of => format!("All {of} sensors meet"),
        (1, of) => format!("One of {of} sensors meets"),
        (some, of) => format!("{some} of {of} sensors meet"),
    };
    let (best_name, most) = (name(analysis, best), at_most(best));
    format!("Choose {best_name}. {all} the goal of {wanted}; its standard uncertainty is {most}.")
}

/// Those that miss the goal, and where.
fn failing(analysis: &Analysis) -> Option<String> {
    let each: Vec<String> = analysis
        .verdicts
        .iter()
        .filter(|verdict| verdict.meets_always() == Some(false))
        .map(|verdict| match verdict.too_slow && verdict.meets.iter().all(|meets| *meets) {
            true => format!("{} (reaches {} Hz only)", name(analysis, verdict), digits(verdict.bandwidth)),
            false => format!(
                "{} ({} N in {}, mostly {})",
                name(analysis, verdict),
                digits(verdict.combined()),
                place(analysis, verdict),
                cause(verdict)
            ),
        })
        .collect();
    if each.is_empty() { None } else { Some(format!("Missed by: {}.", each.join("; "))) }
}

/// What the uncertainty of the worst case is mostly made of: a mean error, or the largest line of the budget.
fn cause(verdict: &Verdict) -> String {
    let budget = &verdict.budget.budget;
    let largest = budget.contributions().iter().max_by(|a, b| a.contribution.total_cmp(&b.contribution));
    match largest {
        Some(line) if line.contribution >= budget.bias().abs() => line.name.to_string(),
        _ => format!("a mean error of {} N", digits(budget.bias()).replace('-', "−")),
    }
}

fn fixes(analysis: &Analysis) -> Option<String> {
    let failing: Vec<&Verdict> =
        analysis.verdicts.iter().filter(|verdict| verdict.meets_always() == Some(false)).collect();
    if failing.is_empty() {
        return None;
    }
    let each: Vec<String> = failing
        .iter()
        .map(|verdict| match verdict.fixes.first() {
            Some(fix) => {
                let lag = if fix.lag > 5e-5 { format!(", {:.1} ms late", 1e3 * fix.lag) } else { String::new() };
                format!("{}: {} ({} N{lag})", name(analysis, verdict), fix.change, digits(fix.combined))
            }
            None => format!("{}: no single change that was tried", name(analysis, verdict)),
        })
        .collect();
    Some(format!("What would fix it: {}.", each.join("; ")))
}

fn damping(analysis: &Analysis) -> String {
    let dampings = &analysis.spec.mount.cases;
    if !analysis.spec.mount.is_band {
        let labels: Vec<&str> = dampings.iter().map(|case| case.label.as_str()).collect();
        return format!("Damping as the spec says: {}.", labels.join(", "));
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
    let band = "Damping is not given, so all holds for ζ from 0 (the paper's case) to 0.02";
    if turn.is_empty() { format!("{band}.") } else { format!("{band}; {}.", turn.join("; ")) }
}

fn warned(analysis: &Analysis) -> String {
    let count = |subject| analysis.warnings.iter().filter(|warning| warning.subject == subject).count();
    let kinds = [
        (Subject::Clash, "windings touch"),
        (Subject::Length, "a length leaves the range in use"),
        (Subject::Doubt, "values of the spring do not fit together"),
        (Subject::Alias, "sampling folds surge lines down"),
        (Subject::Range, "a load cell is overloaded"),
        (Subject::Temperature, "a drift with temperature is not known"),
        (Subject::Neighbour, "torsional or lateral motion lies below the first surge"),
    ];
    let each: Vec<&str> = kinds.into_iter().filter(|(subject, _)| count(*subject) > 0).map(|(_, text)| text).collect();
    if each.is_empty() { "No warnings.".to_owned() } else { format!("Mind the warnings: {}.", each.join("; ")) }
}
