//! A data sheet as text and as JSON.
//!
//! Next door: its numbers (`crate::data_sheet`).

use std::collections::BTreeMap;
use std::fmt::Write;

use anstyle::{AnsiColor, Style};
use serde::Serialize;

use crate::data_sheet::{AtLength, DataSheet, MountFrequencies};
use crate::helix::{ModeLine, ModesAt, UnderEnds};
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
    curve_text(&mut text, &sheet.static_curve);
    for at in &sheet.modes_at {
        modes_text(&mut text, at);
    }
    for warning in sheet.doubts.iter().chain(&sheet.beyond_axial) {
        let _ = writeln!(text, "{MARK}Warning:{MARK:#} {warning}");
    }
    text
}

/// Force, rate and first surge frequency over lengths.
fn curve_text(text: &mut String, curve: &[AtLength]) {
    if curve.is_empty() {
        return;
    }
    let _ = writeln!(text, "\n{BOLD}Static curve{BOLD:#}");
    let _ = writeln!(
        text,
        "  {:>10}{:>12}{:>14}{:>18}{:>12}",
        "l [mm]", "F [N]", "dF/dl [N/mm]", "closed windings", "f1 [Hz]"
    );
    for at in curve {
        let first = at.first_surge_hz.map_or_else(|| "solid".to_owned(), |hertz| format!("{hertz:.1}"));
        let mark = if at.is_knee { "  knee" } else { "" };
        let _ = writeln!(
            text,
            "  {:>10.3}{:>12.2}{:>14.3}{:>18.2}{:>12}{mark}",
            1e3 * at.length_m,
            at.force_n,
            1e-3 * at.stiffness_n_per_m,
            at.closed_windings,
            first
        );
    }
}

/// How many modes people read.
const SHOWN: usize = 10;

/// The modes at one length, in one way beside the other where there are two.
fn modes_text(text: &mut String, at: &ModesAt) {
    let heading = |way: &UnderEnds| if way.buckles { format!("{}: buckles", way.ends) } else { way.ends.clone() };
    let ways: Vec<String> = at.ways().map(heading).collect();
    let _ = writeln!(
        text,
        "\n{BOLD}Modes at {:.1} mm{BOLD:#}, wire as a helix, {}: axial line, then side force and couple per newton of axial force",
        1e3 * at.length_m,
        ways.join(" | ")
    );
    let cells: Vec<Vec<String>> = at.ways().map(|way| way.modes.iter().take(SHOWN).map(mode_text).collect()).collect();
    for row in 0..SHOWN {
        let of_way = |cells: &Vec<String>| cells.get(row).cloned().unwrap_or_default();
        let line = cells.iter().map(of_way).collect::<Vec<_>>().join("   | ");
        let _ = writeln!(text, "  {}", line.trim_end());
    }
}

fn mode_text(mode: &ModeLine) -> String {
    let side = mode.side_force_n_per_n.map_or_else(String::new, |value| format!("{} N/N", three(value)));
    let couple = mode.couple_m.map_or_else(String::new, |value| format!("{} mm", three(1e3 * value)));
    let strength = three(100.0 * mode.axial_strength);
    format!("{:>9.2} Hz {:9} {strength:>7} % {side:>10} {couple:>10}", mode.frequency_hz, mode.kind)
}

/// Three significant digits, in a form that fits.
fn three(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if !(1e-3..1e4).contains(&size) => format!("{value:.0e}"),
        size => format!("{value:.*}", (2 - size.log10().floor() as i32).clamp(0, 5) as usize),
    }
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
    /// Of a coil of sections, its static curve over the range in use, knees among the lengths; empty for a uniform coil.
    static_curve: &'a [AtLength],
    /// Every mode of the coil as a helix, at the shortest, the middle and the longest length.
    modes_at: &'a [ModesAt],
    warnings: Vec<String>,
}

impl Outcome for DataSheetOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/data-sheet/2";
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
            static_curve: &sheet.static_curve,
            modes_at: &sheet.modes_at,
            warnings: sheet.doubts.iter().chain(&sheet.beyond_axial).cloned().collect(),
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
