//! What may be asked of a sweep: the options of `coilsense sweep` and of Python's `SweepPlan`.
//!
//! Next door: what a row says (`crate::request`), what comes of them (`plan`).

use super::Sampling;
use crate::request::{Allowed, Door, IfAbsent, Row, Takes};

/// The options, in the order in which they are told.
pub const OPTIONS: [Row; 8] = [OVER, CATALOGUE, SAMPLING, ROWS, SEED, COLUMNS, CHUNK, JOBS];

/// What is varied.
pub const OVER: Row = Row {
    name: "over",
    takes: Takes::Text("KEY=VALUES"),
    meaning: "What is varied, may be given several times: spring.stiffness=\"600..900 N/m\", mount.damping_ratio=\"log 1e-3..5e-2\"; see below",
    repeated: true,
    ..Row::PLAIN
};
/// A table of designs.
pub const CATALOGUE: Row = Row {
    name: "catalogue",
    takes: Takes::File("FILE"),
    meaning: "A table whose titles are keys, such as \"spring.stiffness [N/m]\", and whose rows are designs: CSV or Parquet. With --over, every row of it meets every row of the sampling",
    ..Row::PLAIN
};
/// How rows are laid.
pub const SAMPLING: Row = Row {
    name: "sampling",
    takes: Takes::Form("WORD", |text| Sampling::named(text).map(|_| ()).ok_or_else(known)),
    if_absent: IfAbsent::Found("a grid where all variables have points, else lhs"),
    meaning: "How rows are laid: grid, lhs (Latin hypercube), monte-carlo, sobol, or saltelli for `coilsense sensitivity`",
    ..Row::PLAIN
};
/// How many rows.
pub const ROWS: Row =
    Row { name: "rows", takes: Takes::Count, meaning: "How many rows; a grid has its own number", ..Row::PLAIN };
/// Of all randomness.
pub const SEED: Row = Row {
    name: "seed",
    takes: Takes::Count,
    if_absent: IfAbsent::Value("0"),
    meaning: "Of all randomness: row k is a function of this seed and k alone",
    ..Row::PLAIN
};
/// What is recorded.
pub const COLUMNS: Row = Row {
    name: "columns",
    takes: Takes::Text("WORDS"),
    meaning: "What is recorded, with commas between: mass, F_o.rmsd, F_o.max[heel strike], F_L.bias, worst, clearance, laser.combined; see book/src/guide/sweep.md",
    ..Row::PLAIN
};
/// Rows of a file.
pub const CHUNK: Row = Row {
    name: "chunk",
    takes: Takes::Count,
    if_absent: IfAbsent::Found("by how long a row takes"),
    meaning: "Rows of a file",
    ..Row::PLAIN
};
/// Threads.
pub const JOBS: Row = Row {
    name: "jobs",
    takes: Takes::Count,
    allowed: Allowed::Within(1.0, 1024.0),
    if_absent: IfAbsent::Found("as many as there are cores"),
    meaning: "Threads",
    elsewhere: &[(Door::Python, "sweep(jobs=)")],
    ..Row::PLAIN
};

/// How values are written.
pub const GRAMMAR: &str = "\
KEY is a key of the spec: spring.mass, spring.section.2.pitch, condition.\"heel strike\".velocity or condition.1.velocity, sensor.laser.delay, goal.error.

VALUES are one of
  600..900 N/m               a range, uniform
  600..900 N/m : 11          eleven points of it, as a grid needs
  log 1e-3..5e-2             a range, uniform in the logarithm
  600, 700, 800 N/m          a list; \"hooks\", \"open\" of texts
  normal(760 N/m, 5 %)       mean and standard deviation, in its unit or in % of the mean
  lognormal(760 N/m, 5 %)    median and standard deviation of the logarithm
  triangular(600, 760, 900 N/m), uniform(600, 900 N/m)
with the units that the spec takes for the key.";

fn known() -> String {
    format!("must be one of {}", Sampling::ALL.map(|(word, _)| word).join(", "))
}
