//! The options of the commands that make and ask sweeps, as far as they are not of a table of their own.
//!
//! Next door: the other commands (the parent), what a sweep may be asked (`crate::sweep::request`).

use crate::request::{DATE_OF_OUT, Door, IfAbsent, JSON, OVERWRITE, OVERWRITE_OUT, Row, SPEC, Takes, out};

pub(super) const VARIED: Row = Row { meaning: "The spec whose values are varied", ..SPEC };
/// The rows as one table.
pub const CSV: Row = Row {
    name: "csv",
    takes: Takes::File("FILE"),
    meaning: "Write all rows as one CSV file, too, for a spreadsheet; not into the sweep's folder, whose files are read as Parquet",
    elsewhere: &[(Door::Python, "SweepDataset.to_pandas")],
    ..Row::PLAIN
};
pub(super) const SWEEP: [Row; 4] = [
    Row { meaning: "Print the summary as JSON", ..JSON },
    out(
        "Folder for the manifest and one Parquet file a chunk; a folder of the same sweep is continued",
        IfAbsent::Refused,
    ),
    CSV,
    Row {
        meaning: "Replace a file of --csv that coilsense did not write, or that has changed since",
        requires: &["csv"],
        ..OVERWRITE
    },
];

/// A sweep that was made.
pub const DATASET: Row = Row {
    name: "sweep",
    takes: Takes::File("DIR"),
    if_absent: IfAbsent::Refused,
    meaning: "Folder of a sweep, as `coilsense sweep --out` makes it",
    by_place: true,
    ..Row::PLAIN
};
/// Columns that are asked for.
pub const OF: Row = Row {
    name: "of",
    takes: Takes::Text("COLUMN"),
    if_absent: IfAbsent::Found("all that hold numbers"),
    meaning: "Column to ask for, such as F_o.rmsd; may be given several times",
    repeated: true,
    ..Row::PLAIN
};
/// Draws of the intervals.
pub const RESAMPLES: Row = Row {
    name: "resamples",
    takes: Takes::Count,
    if_absent: IfAbsent::Value("1000"),
    meaning: "How often base rows are drawn anew for the intervals",
    ..Row::PLAIN
};
/// Seed of these draws.
pub const DRAWS_SEED: Row = Row {
    name: "seed",
    takes: Takes::Count,
    if_absent: IfAbsent::Value("0"),
    meaning: "Seed of these draws",
    ..Row::PLAIN
};
pub(super) const SENSITIVITY: [Row; 8] = [
    Row { meaning: "Folder of a sweep that was made with --sampling saltelli", ..DATASET },
    OF,
    RESAMPLES,
    DRAWS_SEED,
    out("Folder for report.html and results.json; its other files are left alone", IfAbsent::Nothing),
    OVERWRITE_OUT,
    JSON,
    DATE_OF_OUT,
];

/// A row of columns or conditions.
const COLUMN: Row = Row { takes: Takes::Text("COLUMN"), repeated: true, ..Row::PLAIN };
/// Columns to minimise.
pub const MINIMIZE: Row = Row {
    name: "minimize",
    meaning: "Column to minimise, such as F_o.rmsd or mass; may be given several times",
    ..COLUMN
};
/// Columns to maximise.
pub const MAXIMIZE: Row = Row { name: "maximize", meaning: "Column to maximise, such as f1", ..COLUMN };
/// What designs have to meet.
pub const WHERE: Row = Row {
    name: "where",
    takes: Takes::Text("CONDITION"),
    meaning: "What a design has to meet, such as 'mass < 100 g' or 'F_o.rmsd <= 2'; may be given several times",
    ..COLUMN
};
/// Rows whose specs are written.
pub const SPEC_ROW: Row = Row {
    name: "spec_row",
    takes: Takes::Text("ROW|knee"),
    meaning: "Write the spec of a row, or of the knee, into the folder of --out, for `coilsense analyze`; may be given several times",
    requires: &["out"],
    elsewhere: &[(Door::Python, "SweepPlan.spec_of")],
    ..COLUMN
};
pub(super) const PARETO: [Row; 9] = [
    DATASET,
    MINIMIZE,
    MAXIMIZE,
    WHERE,
    out(
        "Folder for report.html, pareto.csv, pareto.parquet, results.json and the figure; its other files are left alone",
        IfAbsent::Nothing,
    ),
    OVERWRITE_OUT,
    SPEC_ROW,
    JSON,
    DATE_OF_OUT,
];
