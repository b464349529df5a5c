//! `report.html` of sensitivity indices: one page that needs no other file and no network; the answer first.
//!
//! Next door: its layout (`page.html`), its figures (`figures`).

use minijinja::{Value, context};

use super::figures;
use super::text::cell;
use crate::quantity::{Shown, without_unit};
use crate::report::page;
use crate::report::prose::{file_name, unbroken};
use crate::report::{ReportError, draw};
use crate::sensitivity::{OfColumn, Study, account, ranked, sentence};
use crate::sweep::Dataset;

/// The page of a study.
pub(super) fn page(study: &Study, dataset: &Dataset, date: &str) -> Result<String, ReportError> {
    let parameters = dataset.plan().parameters();
    let columns = study.columns.iter().filter(|column| column.found.is_ok());
    Ok(page::page(
        include_str!("page.html"),
        context! {
            date,
            file => file_name(&parameters.spec_file),
            sentences => columns.clone().map(|column| unbroken(&sentence(study, column))).collect::<Vec<_>>(),
            account => account(study),
            without => study.columns.iter().filter(|column| column.found.is_err()).map(|column| sentence(study, column)).collect::<Vec<_>>(),
            columns => columns.map(|column| section(study, column)).collect::<Result<Vec<_>, _>>()?,
            level => format!("{:.0}", 100.0 * study.resampling.level),
            resamples => study.resampling.resamples,
            over => &parameters.over,
            base_rows => parameters.rows,
            planned => study.evaluations.planned,
            seed => parameters.seed,
            text => &parameters.spec,
        },
    )?)
}

fn section(study: &Study, column: &OfColumn) -> Result<Value, ReportError> {
    let Ok(found) = &column.found else { return Ok(Value::UNDEFINED) };
    let name = without_unit(&column.title);
    let shown = Shown::of(&column.title, [found.mean.abs() + found.variance.sqrt()]);
    let drawn = draw(name.to_owned(), String::new(), &figures::bars(study, found))?;
    let rows = ranked(study, found).into_iter().map(|(key, index)| {
        context! { key, first => cell(&index.first), total => cell(&index.total) }
    });
    Ok(context! {
        name,
        mean => shown.with_unit(found.mean),
        deviation => shown.with_unit(found.variance.sqrt()),
        base_rows => found.base_rows,
        left_out => found.left_out,
        light => drawn.light,
        dark => drawn.dark,
        rows => rows.collect::<Vec<_>>(),
    })
}
