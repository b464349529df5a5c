//! `report.html` of a front: one page that needs no other file and no network; the answer first.
//!
//! Next door: its layout (`page.html`), its figure (`figures`), which designs are listed (`table`).

use minijinja::{Value, context};

use super::table::{columns, listed, role};
use crate::pareto::{Aim, Study, answer};
use crate::quantity::Shown;
use crate::report::page::{self, shown};
use crate::report::prose::{file_name, unbroken};
use crate::report::{Drawn, ReportError};
use crate::sweep::Dataset;

/// Most designs on the page; the files hold all.
const MOST: usize = 60;

/// The page of a front.
pub(super) fn page(
    study: &Study,
    dataset: &Dataset,
    date: &str,
    figure: Option<&Drawn>,
) -> Result<String, ReportError> {
    let plan = dataset.plan();
    let parameters = plan.parameters();
    let places = listed(study, MOST);
    let columns = columns(study, &places);
    let objectives = &study.question.objectives;
    let word = |aim: Aim| if aim == Aim::Minimize { "little" } else { "much" };
    Ok(page::page(
        include_str!("page.html"),
        context! {
            date,
            file => file_name(&parameters.spec_file),
            answer => answer(study).iter().map(|line| unbroken(line)).collect::<Vec<_>>(),
            wanted => objectives.iter().map(|own| format!("{} {}", word(own.aim), own.name())).collect::<Vec<_>>().join(", "),
            conditions => study.question.conditions(),
            figure => figure.map(shown),
            drawn => study.cloud.len(),
            compared => study.counts.compared,
            titles => columns.iter().map(|column| column.title.clone()).collect::<Vec<_>>(),
            of_objectives => objectives.len(),
            of_variables => columns.len() - objectives.len(),
            rows => rows(study, &places, &columns),
            count => study.rows.len(),
            spans => spans(study),
            over => &parameters.over,
            sampling => parameters.sampling.map(|sampling| sampling.name()),
            planned => plan.rows(),
            seed => parameters.seed,
            text => &parameters.spec,
        },
    )?)
}

fn rows(study: &Study, places: &[usize], columns: &[super::table::Listed]) -> Vec<Value> {
    let row = |(index, place): (usize, &usize)| {
        let cells = columns.iter().map(|column| column.cells[index].clone());
        context! { row => study.rows[*place], role => role(study, *place), cells => cells.collect::<Vec<_>>() }
    };
    places.iter().enumerate().map(row).collect()
}

/// What the front has in common: where each variable lies there.
fn spans(study: &Study) -> Vec<Value> {
    let span = |span: &crate::pareto::Span| {
        let shown = Shown::of(&span.title, span.all);
        let [width, kept] = [span.all, span.front].map(|[least, most]| most - least);
        let share = if width > 0.0 { format!("{:.0} %", 100.0 * kept / width) } else { "–".to_owned() };
        context! {
            title => shown.title(),
            all => span.all.map(|value| shown.digits(value)),
            front => span.front.map(|value| shown.digits(value)),
            share,
        }
    };
    study.spans.iter().map(span).collect()
}
