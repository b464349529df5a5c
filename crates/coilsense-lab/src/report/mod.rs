//! A reproduction as people and machines read it: terminal text, HTML, JSON, CSV.
//!
//! Next door: what is computed (`reproduce`), how files come to disk whole (`output`).

mod html;
mod limits;
mod signals_csv;
mod tables_json;
mod text;

pub use signals_csv::signals_csv;
pub use text::reproduction_text;

use rayon::prelude::*;

use crate::output::{Output, OutputError};
use crate::plot::{PlotError, Theme};
use crate::reproduce::{Reproduction, all_file_stems};

/// What can go wrong while a report is made.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A figure cannot be drawn.
    #[error("figure {name}")]
    Figure {
        /// Its file name.
        name: String,
        /// Why.
        source: PlotError,
    },
    /// The page cannot be filled in.
    #[error("report.html: {0}")]
    Page(#[from] minijinja::Error),
    /// The science refuses.
    #[error(transparent)]
    Science(#[from] coilsense::Error),
    /// JSON cannot be written.
    #[error("tables.json: {0}")]
    Json(#[from] serde_json::Error),
    /// A file cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
}

/// A figure drawn in every way that is needed.
struct Drawn {
    name: String,
    caption: String,
    light: String,
    dark: String,
    png: Vec<u8>,
}

/// Adds all files of a reproduction to `output`: `report.html`, `tables.json`, `figures/*`, `signals/*.csv`.
///
/// # Errors
/// [`ReportError`] for the first part that fails.
pub fn add_reproduction(reproduction: &Reproduction, output: &mut Output) -> Result<(), ReportError> {
    let drawn: Vec<Drawn> = reproduction.figures().into_par_iter().map(draw).collect::<Result<_, _>>()?;
    let series: Vec<(String, String)> = reproduction
        .cases
        .par_iter()
        .map(|result| (format!("signals/{}.csv", result.file_stem()), signals_csv(&result.signals)))
        .collect();
    for figure in &drawn {
        output.add(&format!("figures/{}.svg", figure.name), figure.light.as_bytes())?;
        output.add(&format!("figures/{}.png", figure.name), &figure.png)?;
    }
    for stem in all_file_stems() {
        output.remove(&format!("signals/{stem}.csv"));
    }
    for (name, text) in &series {
        output.add(name, text.as_bytes())?;
    }
    output.add("tables.json", tables_json::tables_json(&reproduction.cells)?.as_bytes())?;
    output.add("report.html", html::page(reproduction, &drawn)?.as_bytes())?;
    Ok(())
}

fn draw(named: crate::reproduce::NamedFigure) -> Result<Drawn, ReportError> {
    let crate::reproduce::NamedFigure { name, caption, figure } = named;
    let drawing = || Ok((figure.to_svg(Theme::Light)?, figure.to_svg(Theme::Dark)?, figure.to_png(Theme::Light)?));
    match drawing() {
        Ok((light, dark, png)) => Ok(Drawn { name, caption, light, dark, png }),
        Err(source) => Err(ReportError::Figure { name, source }),
    }
}
