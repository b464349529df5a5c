//! What matters, in a sentence for each column.
//!
//! Next door: the indices (`study`).

use super::study::{OfColumn, Study};
use super::{Index, Indices};
use crate::quantity::without_unit;

/// From this total index on, a variable is one on which a column hangs.
const MATTERS: f64 = 0.05;
/// Below this one, at the upper end of its interval, it does nothing.
const NOTHING: f64 = 0.01;
/// From this share of the variance on, interactions are worth a word.
const TOGETHER: f64 = 0.1;
/// Wider than this, an interval says little.
const WIDE: f64 = 0.3;

/// Variables with their indices, the largest total index first.
pub fn ranked<'s>(study: &'s Study, found: &'s Indices) -> Vec<(&'s str, &'s Index)> {
    let mut ranked: Vec<(&str, &Index)> = study.variables.iter().map(String::as_str).zip(&found.variables).collect();
    ranked.sort_by(|a, b| b.1.total.value.total_cmp(&a.1.total.value));
    ranked
}

/// What a column hangs on.
pub fn sentence(study: &Study, column: &OfColumn) -> String {
    let name = without_unit(&column.title);
    let found = match &column.found {
        Ok(found) => found,
        Err(error) => return format!("No indices of {name}: {error}."),
    };
    let ranked = ranked(study, found);
    let those = |wanted: &dyn Fn(&Index) -> bool| ranked.iter().filter(|(_, index)| wanted(index)).collect::<Vec<_>>();
    let matter = those(&|index| index.total.value >= MATTERS);
    let idle = those(&|index| index.total.value < MATTERS && index.total.upper < NOTHING);
    let named: Vec<String> = matter
        .iter()
        .enumerate()
        .map(|(place, (key, index))| match place {
            0 => format!("{key} (S_T {:.2})", index.total.value),
            _ => format!("{key} ({:.2})", index.total.value),
        })
        .collect();
    let mut parts = vec![format!("{name} hangs on {}", joined(&named))];
    if !idle.is_empty() {
        let keys: Vec<String> = idle.iter().map(|(key, _)| (*key).to_owned()).collect();
        parts.push(format!("{} {} nothing", joined(&keys), if keys.len() == 1 { "does" } else { "do" }));
    }
    let alone: f64 = found.variables.iter().map(|index| index.first.value).sum();
    // Each S_T less its S_1 is what a variable does only together with others.
    let shared = found.variables.iter().any(|index| index.total.lower > index.first.upper);
    if shared && 1.0 - alone > TOGETHER {
        parts.push(format!("{:.0} % of its variance takes several of them together", 100.0 * (1.0 - alone)));
    }
    let widest = found.variables.iter().map(|index| index.total.upper - index.total.lower).fold(0.0, f64::max);
    if widest > WIDE {
        parts.push(format!("but intervals of S_T are up to {widest:.1} wide: take more base rows"));
    }
    parts.join("; ") + "."
}

/// What is said of all columns: a sentence each, and what did not count.
pub fn answer(study: &Study) -> Vec<String> {
    let with = study.columns.iter().filter(|column| column.found.is_ok());
    let mut lines: Vec<String> = with.map(|column| sentence(study, column)).collect();
    let without: Vec<String> = study
        .columns
        .iter()
        .filter_map(|column| Some(format!("{} ({})", without_unit(&column.title), column.found.as_ref().err()?)))
        .collect();
    if !without.is_empty() {
        lines.push(format!("No indices of {}.", without.join(", ")));
    }
    lines.push(account(study));
    lines
}

/// Which evaluations count, and what it means that some do not.
pub fn account(study: &Study) -> String {
    let counts = &study.evaluations;
    let of_base = study.variables.len() as u64 + 2;
    let mut text = format!("{} base rows of {of_base} designs each", counts.planned / of_base);
    let away = counts.planned - counts.rows;
    let lost = [
        (counts.clash, "in which windings would touch"),
        (counts.refused, "that could not be judged"),
        (away, "not computed yet"),
    ];
    let lost: Vec<String> =
        lost.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
    if lost.is_empty() {
        return text + ", all of which count.";
    }
    let most = study.columns.iter().filter_map(|column| Some(column.found.as_ref().ok()?.left_out)).max().unwrap_or(0);
    text += &format!(
        "; {}: {most} base rows are left out as wholes, and indices are of the designs that are left, among which variables are no longer \
         quite independent.",
        lost.join(", ")
    );
    text
}

/// `a, b and c`.
fn joined(words: &[String]) -> String {
    match words {
        [] => "no variable by itself".to_owned(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
