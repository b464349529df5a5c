//! `coilsense import`.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::Context;
use coilsense_lab::series::{self, Format, Run};

use crate::init::write_one;
use crate::log::LogArguments;

/// Options of `coilsense import`.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    log: LogArguments,
    /// File for time and channels in SI units; its ending says the format: csv, json or parquet
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let begun = Instant::now();
    let known = Format::ALL.iter().map(|(ending, _)| *ending).collect::<Vec<_>>().join(", ");
    let ending = arguments.out.extension().and_then(std::ffi::OsStr::to_str).unwrap_or_default();
    let wrong = || format!("{}: must end in one of {known}", arguments.out.display());
    let format = Format::of_ending(ending).with_context(wrong)?;
    let recording = arguments.log.recording()?;
    let run = Run::of("log", "unknown", recording.signals());
    write_one(&arguments.out, |file| series::write(std::slice::from_ref(&run), format, file))?;
    // A reader that closes the pipe early has all it wants: the file is written.
    let mut out = anstream::stdout().lock();
    let _ = writeln!(out, "{}", recording.account());
    let _ = writeln!(out, "{} in {:.2} s", arguments.out.display(), begun.elapsed().as_secs_f64());
    Ok(())
}
