//! Series as JSON.
//!
//! Next door: the other formats (`csv`, `parquet`).

use std::io;

use serde_json::{Map, Value, json};

use super::{Column, Run};

/// `{"schema": …, "runs": [{"condition", "damping", "columns": {"time_s": […], …}}]}`.
pub(super) fn write(runs: &[Run<'_>], out: &mut impl io::Write) -> io::Result<()> {
    writeln!(out, "{{\"schema\":\"coilsense/signals/1\",\"runs\":[")?;
    for (index, run) in runs.iter().enumerate() {
        let columns: Map<String, Value> =
            run.columns.iter().map(|column| (key(column), json!(column.values))).collect();
        let object = json!({ "condition": run.condition, "damping": run.damping, "columns": columns });
        serde_json::to_writer(&mut *out, &object)?;
        writeln!(out, "{}", if index + 1 < runs.len() { "," } else { "" })?;
    }
    writeln!(out, "]}}")
}

/// `f_i_n`: the name in snake case with its unit behind.
fn key(column: &Column<'_>) -> String {
    let plain = |c: char| if c.is_alphanumeric() { c } else { '_' };
    let name: String = column.name.to_lowercase().chars().map(plain).collect();
    format!("{name}_{}", column.unit.to_lowercase())
}
