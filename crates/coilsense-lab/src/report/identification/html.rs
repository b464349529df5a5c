//! `report.html` of an identification: one page that needs no other file and no network; the answer first.
//!
//! Next door: its layout (`page.html`), its figures (`figures`).

use coilsense::identify::Line;
use minijinja::{Value, context};

use crate::identification::{Identified, answer, component_name, interval};
use crate::quantity::digits;
use crate::report::page::{self, shown};
use crate::report::prose::{file_name, unbroken};
use crate::report::{Drawn, ReportError};

/// The page of an identification.
pub(super) fn page(identified: &Identified, date: &str, drawn: &[Drawn]) -> Result<String, ReportError> {
    let found = &identified.found;
    let hits: Vec<String> = found.hits.iter().map(|hit| format!("{:.3}", hit.time)).collect();
    Ok(page::page(
        include_str!("page.html"),
        context! {
            date,
            file => file_name(&identified.file),
            simulated => &identified.simulated,
            answer => answer(identified).iter().map(|line| unbroken(line)).collect::<Vec<_>>(),
            figures => drawn.iter().map(shown).collect::<Vec<_>>(),
            lines => found.lines.iter().map(line_value).collect::<Vec<_>>(),
            both => found.has_both_forces,
            fitted_windings => found.fitted_windings.map(digits),
            no_stiffness => found.stiffness.as_ref().err(),
            hits => hits.join(", "),
            account => &identified.account,
        },
    )?)
}

fn line_value(line: &Line) -> Value {
    let half = line.half_power.as_ref();
    context! {
        frequency => interval(&line.frequency, 1.0),
        ratio => line.ratio.filter(|_| line.decays).map(|ratio| interval(&ratio, 1.0)),
        half_power => half.ok().map(|ratio| interval(ratio, 1.0)),
        refused => half.err(),
        amplitude => digits(line.amplitude),
        part => component_name(line.part),
        reason => unbroken(&line.reason),
        known => line.mode().is_some(),
    }
}
