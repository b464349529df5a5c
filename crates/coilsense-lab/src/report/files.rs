//! What commands say to machines that mostly write files.
//!
//! Next door: what other verbs find (`*/json.rs`), the form of all of them (`outcome`).

use std::path::Path;
#[cfg(feature = "parquet")]
use std::path::PathBuf;

use serde::Serialize;

use super::outcome::Outcome;

/// The files that `coilsense simulate` wrote.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct SimulationOutcome<'a> {
    /// The spec.
    pub spec_file: &'a str,
    /// The files.
    pub files: Vec<String>,
    /// Conditions times dampings.
    pub runs: usize,
    /// Of all runs together.
    pub samples: usize,
    /// Where what was simulated is not what the spring would do.
    pub warnings: Vec<String>,
}

impl Outcome for SimulationOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/simulation/1";
}

/// The plant that `coilsense export` wrote.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct ExportOutcome<'a> {
    /// The spec.
    pub spec_file: &'a str,
    /// What was written.
    pub file: &'a Path,
    /// As what: c, rust, state-space or fmu.
    pub r#as: &'a str,
    /// What damps it.
    pub damping: &'a str,
    /// The length about which inputs count.
    pub mean_length_m: f64,
    /// F_i = F_o = F_x there.
    pub mean_force_n: f64,
    /// Modes of the plant, those that stand for all others among them.
    pub modes: usize,
    /// The spring's own among them …
    pub kept_modes: usize,
    /// … of so many.
    pub available_modes: usize,
    /// Up to where the error is told; null where that was not asked for.
    pub bandwidth_hz: Option<f64>,
    /// Of F_i, F_o and F_x, and F_L where that is asked for, over k times the motion of an end or over the force at end 2; null where that was not asked for, or where modes of the
    /// band are left out.
    pub error: Option<f64>,
    /// What is not in the file though it could be, and why: an FMU's binary, where this machine has no C compiler; else null.
    pub left_out: Option<&'a str>,
    /// What a reader must know of it, each in a line.
    pub warnings: &'a [String],
}

impl Outcome for ExportOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/export/1";
}

/// The file that `coilsense import` wrote.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct ImportOutcome<'a> {
    /// The log.
    pub file: &'a Path,
    /// What was written.
    pub out: &'a Path,
    /// How the log is written.
    pub format: &'a str,
    /// Rows that were read.
    pub read: u64,
    /// Rows that were written.
    pub rows: u64,
    /// Rows that were left out.
    pub left_out: u64,
    /// First and last time; null without a row.
    pub span_s: Option<[f64; 2]>,
    /// What became of the log's rows, line by line.
    pub account: Vec<String>,
    /// What a stored calibration made of the log's inductance, a sentence each; empty without one.
    pub calibration: Vec<String>,
}

impl Outcome for ImportOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/import/1";
}

/// The runs that `coilsense rig` recorded.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct RigOutcome<'a> {
    /// Where they are.
    pub folder: &'a Path,
    /// How many files.
    pub files: usize,
    /// How many runs.
    pub runs: usize,
    /// Rows of all files together.
    pub rows: u64,
    /// Of noise, of each instrument's own errors and of hits.
    pub seed: u64,
    /// What is doubtful, a sentence each.
    pub warnings: Vec<String>,
}

impl Outcome for RigOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/rig/1";
}

/// The text that `coilsense init` made.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct InitOutcome<'a> {
    /// Where it was written; null where it was not.
    pub file: Option<&'a Path>,
    /// A spec, or the sensor catalogue where that was asked for.
    pub text: &'a str,
}

impl Outcome for InitOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/init/1";
}

/// What became of a sweep's designs.
#[cfg(feature = "parquet")]
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct SweepOutcome<'a> {
    /// Where they are.
    pub folder: &'a Path,
    /// Of all that decides what the designs are.
    pub digest: String,
    /// Designs that are there.
    pub rows: u64,
    /// Of these, those that were judged.
    pub ok: u64,
    /// Those whose windings touch.
    pub clash: u64,
    /// Those that are no spring, or cannot be judged.
    pub refused: u64,
    /// Why designs were refused, the most frequent first.
    pub reasons: Vec<ReasonRow<'a>>,
    /// What a reader of the results must know.
    pub note: Option<String>,
    /// Files of the dataset.
    pub chunks: u64,
    /// Files that were there and not as they had been written, so that this run made them anew.
    pub recomputed: &'a [RecomputedRow],
    /// Rows that this run has made.
    pub made: u64,
    /// How long it took.
    pub seconds: f64,
    /// Over that time.
    pub designs_per_second: f64,
    /// Null where the system does not say it.
    pub peak_memory_kb: Option<u64>,
}

#[cfg(feature = "parquet")]
impl Outcome for SweepOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/sweep-summary/1";
}

/// A file of a sweep that was not as it had been written.
#[cfg(feature = "parquet")]
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct RecomputedRow {
    /// The file.
    pub file: PathBuf,
    /// How that showed.
    pub because: String,
}

/// Why designs were refused.
#[cfg(feature = "parquet")]
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct ReasonRow<'a> {
    /// How many designs.
    pub count: u64,
    /// One of their reasons.
    pub such_as: &'a str,
}
