//! A data sheet as text and as JSON.
//!
//! Next door: its numbers (`crate::data_sheet`).

use std::fmt::Write;

use anstyle::{AnsiColor, Style};
use serde_json::{Map, Value, json};

use crate::data_sheet::DataSheet;

const BOLD: Style = Style::new().bold();
const MARK: Style = AnsiColor::Yellow.on_default();

/// The data sheet as people read it in a terminal.
pub fn data_sheet_text(sheet: &DataSheet) -> String {
    // Writing to a String cannot fail.
    let mut text = format!("{BOLD}{}{BOLD:#}, {}\n", sheet.name, sheet.material);
    for (heading, rows) in &sheet.groups {
        let _ = writeln!(text, "\n{BOLD}{heading}{BOLD:#}");
        for row in rows {
            let line = format!("  {:50}{:>12} {}", row.label, row.shown(), row.unit);
            let _ = writeln!(text, "{}", line.trim_end());
        }
    }
    let _ = writeln!(text, "\n{BOLD}Surge frequencies{BOLD:#}, chain of windings (continuous coil), Hz");
    for mount in &sheet.surge {
        let mode = |(chain, continuous): (&f64, &f64)| format!("{:>18}", format!("{chain:.2} ({continuous:.2})"));
        let modes: String = mount.chain_hz.iter().zip(&mount.continuous_hz).map(mode).collect();
        let rule = mount.third_rule_error.map_or(String::new(), |error| format!("   ⅓-rule {:+.2} %", 100.0 * error));
        let star = if mount.is_the_specs { "*" } else { " " };
        let _ = writeln!(text, "{star} {:34}{modes}{rule}", mount.mount);
    }
    let _ = writeln!(text, "  * the spec's own mount");
    let _ = writeln!(text, "\n{BOLD}Neighbours{BOLD:#} that the axial model leaves out, both ends held, estimates");
    for neighbour in &sheet.neighbours {
        let shown = neighbour.frequency_hz.map_or_else(|| "buckles".to_owned(), |frequency| format!("{frequency:.1}"));
        let _ = writeln!(text, "  {:50}{shown:>12} Hz", format!("{} {}", neighbour.name, neighbour.place));
    }
    for warning in sheet.neighbour_warnings() {
        let _ = writeln!(text, "{MARK}Warning:{MARK:#} {warning}");
    }
    text
}

/// The data sheet for machines: SI, one key per number.
///
/// # Errors
/// What the JSON writer says.
pub fn data_sheet_json(sheet: &DataSheet) -> Result<String, serde_json::Error> {
    Ok(format!("{}\n", serde_json::to_string_pretty(&data_sheet_value(sheet))?))
}

/// The same as a JSON value.
pub(super) fn data_sheet_value(sheet: &DataSheet) -> Value {
    let rows = sheet.groups.iter().flat_map(|(_, rows)| rows);
    let mut object = Map::new();
    object.insert("schema".into(), json!("coilsense/data-sheet/1"));
    object.insert("name".into(), json!(sheet.name));
    object.insert("material".into(), json!(sheet.material));
    object.extend(rows.map(|row| (row.key.to_owned(), json!(row.value))));
    let surge = sheet.surge.iter().map(|mount| {
        json!({
            "mount": mount.mount,
            "is_the_specs": mount.is_the_specs,
            "chain_hz": mount.chain_hz,
            "continuous_hz": mount.continuous_hz,
            "third_rule_error_percent": mount.third_rule_error.map(|error| 100.0 * error),
        })
    });
    object.insert("surge".into(), surge.collect());
    let neighbours = sheet.neighbours.iter().map(
        |neighbour| json!({ "name": neighbour.name, "place": neighbour.place, "frequency_hz": neighbour.frequency_hz }),
    );
    object.insert("neighbours".into(), neighbours.collect());
    object.insert("warnings".into(), json!(sheet.neighbour_warnings()));
    Value::Object(object)
}
