//! A data sheet as text and as JSON.
//!
//! Next door: its numbers (`crate::data_sheet`).

use std::collections::BTreeMap;
use std::fmt::Write;

use anstyle::{AnsiColor, Style};
use serde::Serialize;

use crate::data_sheet::{DataSheet, MountFrequencies, Neighbour};
use crate::report::outcome::{Outcome, to_json};

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
        let rule = mount
            .third_rule_error_percent
            .map_or(String::new(), |error| format!("   with m/3 at the end {error:+.2} %"));
        let star = if mount.is_the_specs { "*" } else { " " };
        let _ = writeln!(text, "{star} {:34}{modes}{rule}", mount.mount);
    }
    let _ = writeln!(text, "  * the spec's own mount");
    let _ = writeln!(
        text,
        "\n{BOLD}Lateral and torsional modes{BOLD:#}, not in the axial model (estimates; ends held in place, free to tilt)"
    );
    for neighbour in &sheet.neighbours {
        let shown =
            neighbour.frequency_hz.map_or_else(|| "may buckle".to_owned(), |frequency| format!("{frequency:.1} Hz"));
        let _ = writeln!(text, "  {:50}{shown:>15}", format!("{} {}", neighbour.name, neighbour.place));
    }
    for warning in sheet.doubts.iter().cloned().chain(sheet.neighbour_warnings()) {
        let _ = writeln!(text, "{MARK}Warning:{MARK:#} {warning}");
    }
    text
}

/// The data sheet for machines: a number a key, its SI unit as suffix.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct DataSheetOutcome<'a> {
    name: &'a str,
    material: &'a str,
    /// Rate, mass, lengths, stress and the like; null for what is not known.
    #[serde(flatten)]
    rows: BTreeMap<&'static str, Option<f64>>,
    /// Surge frequencies on every mount.
    surge: &'a [MountFrequencies],
    /// Motions that the axial model leaves out.
    neighbours: &'a [Neighbour],
    warnings: Vec<String>,
}

impl Outcome for DataSheetOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/data-sheet/1";
}

impl<'a> DataSheetOutcome<'a> {
    /// Of a data sheet.
    pub fn of(sheet: &'a DataSheet) -> Self {
        let rows = sheet.groups.iter().flat_map(|(_, rows)| rows);
        Self {
            name: &sheet.name,
            material: &sheet.material,
            rows: rows.map(|row| (row.key, row.value)).collect(),
            surge: &sheet.surge,
            neighbours: &sheet.neighbours,
            warnings: sheet.doubts.iter().cloned().chain(sheet.neighbour_warnings()).collect(),
        }
    }
}

/// The data sheet as JSON.
///
/// # Errors
/// What the JSON writer says.
pub fn data_sheet_json(sheet: &DataSheet) -> Result<String, serde_json::Error> {
    to_json(DataSheetOutcome::of(sheet))
}
