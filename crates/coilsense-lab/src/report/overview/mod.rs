//! A log before anything is made of it: what is in it, in words, for machines, and as a page with the course and the spectrogram of each channel.
//!
//! Next door: the log itself (`crate::recording`).

mod figures;
mod shown;

use minijinja::context;

pub use shown::{OverviewOutcome, overview_json, overview_text};

use super::page::{self, shown};
use super::prose::file_name;
use super::{Drawn, ReportError, draw};
use crate::output::Output;
use crate::recording::{Overview, Recording};

/// Adds the page of a log to `output`: `report.html`, `results.json`, `figures/*`.
///
/// # Errors
/// [`ReportError`] for the first part that fails.
pub fn add_overview(
    overview: &Overview,
    recording: &Recording,
    date: &str,
    output: &mut Output,
) -> Result<(), ReportError> {
    let drawn: Vec<Drawn> = figures::all(recording)
        .into_iter()
        .map(|(name, caption, figure)| draw(name, caption, &figure))
        .collect::<Result<_, _>>()?;
    for figure in &drawn {
        output.add(&format!("figures/{}.svg", figure.name), figure.light.as_bytes())?;
        output.add(&format!("figures/{}.png", figure.name), &figure.png)?;
    }
    output.add("report.html", page(overview, recording, date, &drawn)?.as_bytes())?;
    output.add("results.json", overview_json(overview)?.as_bytes())?;
    Ok(())
}

fn page(overview: &Overview, recording: &Recording, date: &str, drawn: &[Drawn]) -> Result<String, ReportError> {
    let rows = shown::columns(overview);
    Ok(page::page(
        include_str!("page.html"),
        context! {
            date,
            file => file_name(&overview.file.display().to_string()),
            simulated => recording.simulated(),
            summary => shown::summary(overview),
            uneven => recording.sample_rate().err().map(|error| error.to_string()),
            columns => rows,
            remarks => &overview.remarks,
            figures => drawn.iter().map(shown).collect::<Vec<_>>(),
            account => recording.account().lines(),
        },
    )?)
}
