//! Tables II and III for machines: `tables.json`, and what `reproduce --json` prints.
//!
//! Next door: the same for people (`text`, `html`).

use serde::Serialize;

use crate::report::outcome::{Outcome, to_json};
use crate::reproduce::{Cell, Protocol, Reproduction};

/// One cell; `null` for a protocol that was not run.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct JsonCell<'a> {
    table: &'static str,
    spring: &'a str,
    condition: &'static str,
    force: &'static str,
    published_percent: f64,
    text_percent: Option<f64>,
    tables_percent: Option<f64>,
}

/// The paper's tables beside what is computed here; shares in percent of F_nom.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct ReproductionOutcome<'a> {
    cells: Vec<JsonCell<'a>>,
}

impl Outcome for ReproductionOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/reproduction/1";
}

/// The tables as JSON.
///
/// # Errors
/// What the JSON writer says.
pub fn reproduction_json(reproduction: &Reproduction) -> Result<String, serde_json::Error> {
    to_json(ReproductionOutcome { cells: reproduction.cells.iter().map(json_cell).collect() })
}

/// The cells as a JSON array, one object per line.
pub(super) fn tables_json(cells: &[Cell]) -> Result<String, serde_json::Error> {
    let lines: Vec<String> =
        cells.iter().map(|cell| serde_json::to_string(&json_cell(cell))).collect::<Result<_, _>>()?;
    Ok(format!("[\n{}\n]\n", lines.join(",\n")))
}

fn json_cell(cell: &Cell) -> JsonCell<'_> {
    let (spring, condition, force) = cell.place();
    let percent = |protocol| cell.by(protocol).map(|computed| computed.percent);
    JsonCell {
        table: cell.table().numeral(),
        spring,
        condition: condition.name(),
        force: force.name(),
        published_percent: cell.published.percent,
        text_percent: percent(Protocol::Text),
        tables_percent: percent(Protocol::Tables),
    }
}
