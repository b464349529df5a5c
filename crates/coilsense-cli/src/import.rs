//! `coilsense import`.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, bail};
use coilsense_lab::analysis::AnalysisError;
use coilsense_lab::output::Output;
use coilsense_lab::recording::{Account, ImportError, import, write_recording};
use coilsense_lab::report::{ImportOutcome, to_json};
use coilsense_lab::series::Format;

use crate::log::LogArguments;
use crate::progress::Watch;

/// Options of `coilsense import`.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    log: LogArguments,
    /// File for time and channels in SI units; its ending says the format: csv, json or parquet
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let begun = Instant::now();
    let known = Format::ALL.iter().map(|(ending, _)| *ending).collect::<Vec<_>>().join(", ");
    let ending = arguments.out.extension().and_then(std::ffi::OsStr::to_str).unwrap_or_default();
    let wrong = || format!("{}: must end in one of {known}", arguments.out.display());
    let format = Format::of_ending(ending).with_context(wrong)?;
    let Some(name) = arguments.out.file_name().and_then(std::ffi::OsStr::to_str) else {
        bail!("{}: is no name of a file", arguments.out.display());
    };
    let (mapping, repairs) = (arguments.log.mapping()?, arguments.log.repairs());
    // Before anything is on disk, so that nothing is left there.
    let watch = Watch::begin("reading")?;
    let folder = arguments.out.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut output = Output::begin(folder)?;
    let tell = |done: u64, of: u64| watch.tell(done as usize, of as usize);
    let imported = match arguments.log.has_second() {
        true => write_recording(&arguments.log.recording()?, format, name, &mut output),
        false => import(&arguments.log.log, &mapping, &repairs, &tell, format, name, &mut output),
    };
    watch.end();
    let account = imported.map_err(|error| match error {
        ImportError::Interrupted => AnalysisError::Interrupted.into(),
        other => anyhow::Error::from(other),
    })?;
    output.commit()?;
    // A reader that closes the pipe early has all it wants: the file is written.
    let mut out = anstream::stdout().lock();
    if arguments.json {
        let _ = write!(out, "{}", to_json(outcome(&account, &arguments.out))?);
        return Ok(());
    }
    let _ = writeln!(out, "{account}");
    let _ = writeln!(out, "wrote {} in {:.2} s", arguments.out.display(), begun.elapsed().as_secs_f64());
    Ok(())
}

fn outcome<'a>(account: &'a Account, out: &'a Path) -> ImportOutcome<'a> {
    ImportOutcome {
        file: &account.file,
        out,
        format: &account.description,
        read: account.read,
        rows: account.rows,
        left_out: account.left_out(),
        span_s: account.span,
        account: account.lines(),
    }
}
