//! `tables.json`: Tables II and III for machines.
//!
//! Next door: the same for people (`text`, `html`).

use serde::Serialize;

use crate::reproduce::{Cell, Protocol};

/// One cell; `null` for a protocol that was not run.
#[derive(Serialize)]
struct JsonCell<'a> {
    table: &'static str,
    spring: &'a str,
    condition: &'static str,
    force: &'static str,
    published_percent: f64,
    text_percent: Option<f64>,
    tables_percent: Option<f64>,
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
