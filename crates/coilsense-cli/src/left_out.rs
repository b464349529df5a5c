//! What a build without the feature `files` says in place of the commands that need it.
//!
//! Next door: the feature (`Cargo.toml`), files that the laboratory refuses (`coilsense_lab::recording`).

use anyhow::bail;
use coilsense_lab::request::Given;

/// Where a whole build comes from.
pub const WHOLE_BUILD: &str =
    "this build leaves them out (`cargo quick`, or no default features); `cargo run --release --` has them";

/// Refuses a command whose rows are Parquet.
pub fn run(_: &Given) -> anyhow::Result<()> {
    bail!("a sweep's rows are Parquet files, and {WHOLE_BUILD}")
}
