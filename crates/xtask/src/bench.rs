//! `cargo xtask bench`: what a user waits for, measured; medians, for single runs vary by a third.

use std::process::Stdio;
use std::time::Instant;

use anyhow::{Context, bail};
use serde::Serialize;

use crate::{cargo, root};

/// How often each job is run; the median counts.
const RUNS: usize = 11;

/// One row of `target/bench.json`.
#[derive(Serialize)]
struct Row {
    job: &'static str,
    system: &'static str,
    setting: String,
    median_ms: f64,
    max_rel_error: Option<f64>,
    ratio: f64,
}

/// Measures, prints, writes `target/bench.json`.
pub fn run() -> anyhow::Result<()> {
    let build = cargo(&["build", "--release", "--package", "coilsense-cli"]).status()?;
    if !build.success() {
        bail!("the release build failed");
    }
    let threads = std::thread::available_parallelism()?;
    let rows = [Row {
        job: "reproduce: all tables, figures and files of the paper",
        system: "coilsense",
        setting: format!("whole command, {threads} threads"),
        median_ms: median((0..RUNS).map(|_| reproduce()).collect::<Result<_, _>>()?),
        max_rel_error: None,
        ratio: 1.0,
    }];
    for row in &rows {
        println!("{:56} {:12} {:26} {:8.1} ms", row.job, row.system, row.setting, row.median_ms);
    }
    let path = root().join("target/bench.json");
    std::fs::write(&path, serde_json::to_string_pretty(&rows)? + "\n")
        .with_context(|| format!("{} cannot be written", path.display()))
}

/// One run of `coilsense reproduce` \[ms\].
fn reproduce() -> anyhow::Result<f64> {
    let place = tempfile::tempdir()?;
    let mut command = std::process::Command::new(root().join("target/release/coilsense"));
    command.args(["reproduce", "--out"]).arg(place.path().join("paper")).stdout(Stdio::null());
    let begun = Instant::now();
    let status = command.status().context("target/release/coilsense cannot be started")?;
    let elapsed = begun.elapsed();
    if !status.success() {
        bail!("coilsense reproduce failed");
    }
    Ok(1e3 * elapsed.as_secs_f64())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
