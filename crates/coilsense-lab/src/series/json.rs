//! Series as JSON.
//!
//! Next door: the other formats (`csv`, `parquet`).

use std::io;

use serde_json::{Map, Value, json};

use super::{Column, Run, key_of};

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

/// `f_i_n`: the name as a key with its unit behind.
fn key(column: &Column<'_>) -> String {
    format!("{}_{}", key_of(&column.name), column.unit.to_lowercase())
}
