//! The first answer of a clone, by `cargo quick`: that it is there, that its digits are those of a whole build, and that what is left out is refused by name.
//!
//! Next door: the other commands that are typed (`commands`), the build of the packed crates (`packed`).

use std::path::Path;
use std::process::{Command, Output};
use std::time::Instant;

use anyhow::{Context, bail};

use crate::{cargo, commands, root};

/// What README asks first.
const QUESTION: [&str; 2] = ["analyze", "examples/sea-ankle.toml"];
/// A day for both answers.
const DATE: [&str; 2] = ["--date", "2026-01-01"];

/// Builds, asks, and compares; whether all hold.
pub fn steps() -> anyhow::Result<bool> {
    let place = tempfile::tempdir()?;
    let [quick, whole] = ["quick", "whole"].map(|name| place.path().join(name));
    let begun = Instant::now();
    let answer = quick_build(&[&QUESTION[..], &["--out", &quick.display().to_string()], &DATE].concat())?;
    if !answer.status.success() {
        eprintln!("cargo quick {}: {}", QUESTION.join(" "), String::from_utf8_lossy(&answer.stderr));
        return Ok(false);
    }
    println!(
        "first answer after {:.0} s (of a clean target folder only where nothing was built)",
        begun.elapsed().as_secs_f64()
    );
    let mut same = Command::new(commands::as_tested()?);
    same.args(QUESTION).arg("--out").arg(&whole).args(DATE).current_dir(root());
    if !same.output()?.status.success() {
        bail!("the whole command cannot answer");
    }
    let read = |folder: &Path| std::fs::read(folder.join("results.json")).with_context(|| folder.display().to_string());
    if read(&quick)? != read(&whole)? {
        bail!("the quick build answers with other digits than the whole one");
    }
    if !quick.join("signals.csv").is_file() {
        bail!("the quick build writes no signals.csv");
    }
    let log = place.path().join("run.parquet");
    std::fs::write(&log, b"PAR1")?;
    let log = log.display().to_string();
    for (arguments, said) in [
        (["sweep", QUESTION[1], "--over", "k=1..2", "--out", "sweep"].as_slice(), "cargo run --release"),
        (&["pareto", "sweep", "--minimize", "mass"], "cargo run --release"),
        (&["sensitivity", "sweep"], "cargo run --release"),
        (&["identify", &log], "--features files"),
    ] {
        let refused = quick_build(arguments)?;
        let text = String::from_utf8_lossy(&refused.stderr);
        if refused.status.code() != Some(2) || !text.contains(said) {
            bail!("cargo quick {}: {text}", arguments.join(" "));
        }
    }
    Ok(true)
}

/// Asks as a newcomer does.
fn quick_build(arguments: &[&str]) -> anyhow::Result<Output> {
    cargo(&["quick"]).args(arguments).output().context("cargo cannot be started")
}
