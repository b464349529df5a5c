//! Which designs of a front are listed, and what is said of each.
//!
//! Next door: the table in the terminal (`text`) and on the page (`html`).

use crate::pareto::Study;
use crate::quantity::{Shown, without_unit};
use crate::sweep::{Data, cell};

/// A column of the table: its title, its cells of the listed designs.
pub(super) struct Listed {
    pub title: String,
    pub cells: Vec<String>,
}

/// Places of the designs that are listed: the named ones, and others evenly along the front.
pub(super) fn listed(study: &Study, most: usize) -> Vec<usize> {
    let count = study.rows.len();
    let mut places: Vec<usize> = study.extremes.iter().copied().chain([study.knee]).collect();
    places.sort_unstable();
    places.dedup();
    let left = most.saturating_sub(places.len());
    let others: Vec<usize> = (0..count).filter(|place| !places.contains(place)).collect();
    let step = others.len().div_ceil(left.max(1)).max(1);
    places.extend(others.into_iter().step_by(step).take(left));
    places.sort_unstable();
    places
}

/// What a design is known for: `knee`, `least mass`.
pub(super) fn role(study: &Study, place: usize) -> String {
    let best = study.extremes.iter().zip(&study.question.objectives).filter(|(extreme, _)| **extreme == place);
    let mut roles: Vec<String> = best.map(|(_, own)| format!("{} {}", own.best_word(), own.name())).collect();
    if study.knee == place {
        roles.insert(0, "knee".to_owned());
    }
    roles.join(", ")
}

/// Objectives first, then what is varied; numbers in the units in which people think of them.
pub(super) fn columns(study: &Study, places: &[usize]) -> Vec<Listed> {
    let objectives = &study.question.objectives;
    let is_objective = |title: &str| objectives.iter().any(|own| own.title == title);
    let columns = &study.front.columns;
    let status = columns.iter().position(|(title, _)| title == "status").unwrap_or(columns.len());
    let varied = columns[..status].iter().skip(1).filter(|(title, _)| !is_objective(title));
    let first = objectives.iter().filter_map(|own| columns.iter().find(|(title, _)| *title == own.title));
    let listed = |(title, data): &(String, Data)| {
        let (title_shown, cells) = match data {
            Data::Numbers(values) => {
                let shown = Shown::of(title, values.iter().copied());
                let cell = |place: &usize| shown.digits(values.get(*place).copied().unwrap_or(f64::NAN));
                (shown.title(), places.iter().map(cell).collect())
            }
            _ => (without_unit(title).to_owned(), places.iter().map(|place| cell(data, *place)).collect()),
        };
        Listed { title: title_shown, cells }
    };
    first.chain(varied).map(listed).collect()
}
