//! A reproduction as people and machines read it: terminal text, HTML, JSON, CSV.
//!
//! Next door: what is computed (`reproduce`), the writer of its series (`series`).

mod html;
mod limits;
mod tables_json;
mod text;

#[cfg(feature = "reference")]
pub(super) use tables_json::ReproductionOutcome;
pub use tables_json::reproduction_json;
pub use text::reproduction_text;

use rayon::prelude::*;

use coilsense::{Channel, Signals};

use super::{Drawn, ReportError, draw};
use crate::output::Output;
use crate::reproduce::{NamedFigure, Reproduction, all_file_stems};
use crate::series::{self, Column, Format, Run};

/// Adds all files of a reproduction to `output`: `report.html`, `tables.json`, `figures/*`, `signals/*.csv`.
///
/// # Errors
/// [`ReportError`] for the first part that fails.
pub fn add_reproduction(reproduction: &Reproduction, output: &mut Output) -> Result<(), ReportError> {
    let drawn: Vec<Drawn> = reproduction.figures().into_par_iter().map(drawn).collect::<Result<_, _>>()?;
    for figure in &drawn {
        output.add(&format!("figures/{}.svg", figure.name), figure.light.as_bytes())?;
        output.add(&format!("figures/{}.png", figure.name), &figure.png)?;
    }
    for stem in all_file_stems() {
        output.remove(&format!("signals/{stem}.csv"));
    }
    for result in &reproduction.cases {
        let run = forces(&result.signals);
        output
            .write(&format!("signals/{}.csv", result.file_stem()), |file| series::write(&[run], Format::Csv, file))?;
    }
    output.add("tables.json", tables_json::tables_json(&reproduction.cells)?.as_bytes())?;
    output.add("report.html", html::page(reproduction, &drawn)?.as_bytes())?;
    Ok(())
}

fn drawn(named: NamedFigure) -> Result<Drawn, ReportError> {
    let NamedFigure { name, caption, figure } = named;
    draw(name, caption, &figure)
}

/// Time and the paper's four forces.
fn forces(signals: &Signals) -> Run<'_> {
    let mut run = Run::of("", "", signals);
    let wanted =
        |column: &Column<'_>| column.name == "time" || Channel::FORCES.iter().any(|force| force.name() == column.name);
    run.columns.retain(wanted);
    run
}
