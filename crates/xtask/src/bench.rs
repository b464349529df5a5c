//! `cargo xtask bench`: coilsense and its peers on the same jobs in one run; medians, for single runs vary by a third.
//!
//! Next door: the jobs and the peers (`bench/README.md`), the goals (`goals`), what is measured from Python (`from_python`).

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

use anyhow::{Context, bail};
use serde::{Deserialize, Serialize};

use crate::python::{self, Environment};
use crate::{cargo, commands, root};

/// What to measure.
#[derive(clap::Args)]
pub struct Arguments {
    /// Only coilsense, without the peers: half a minute, and nothing to set up but the jobs
    #[arg(long)]
    ours: bool,
    /// Only the import of logs: a minute of five channels, and 2 GB (which it makes in target/bench-logs and removes again)
    #[arg(long)]
    logs: bool,
    /// Only sweeps: designs a second on one core and on two
    #[arg(long)]
    sweep: bool,
    /// With --sweep: a million designs, and the most memory that takes
    #[arg(long, requires = "sweep")]
    million: bool,
    /// Only calls from Python: what one costs, and a motion's end forces beside the same from Rust
    #[arg(long)]
    python: bool,
    /// Only a sweep on Dask: how much faster two workers are than one, over a minute of work
    #[arg(long)]
    dask: bool,
    /// End with an error where a goal that was measured is missed
    #[arg(long, conflicts_with_all = ["logs", "sweep", "python", "dask"])]
    check: bool,
    /// Keep what is measured in book/measured, and write the tables of README and book that are made of it
    #[arg(long, conflicts_with_all = ["ours", "logs", "python", "dask", "million"])]
    keep: bool,
}

/// How often the whole command is run; the median counts.
const RUNS: usize = 11;

/// A measurement as the programs print it.
#[derive(Deserialize)]
pub struct Measurement {
    job: String,
    system: String,
    pub setting: String,
    pub median_ms: Option<f64>,
    max_rel_error: Option<f64>,
    #[serde(default)]
    pub note: String,
}

/// One row of `target/bench.json`.
#[derive(Serialize, Deserialize)]
pub struct Row {
    pub job: String,
    pub system: String,
    pub setting: String,
    pub median_ms: Option<f64>,
    pub max_rel_error: Option<f64>,
    /// This system's median over coilsense's on the same job.
    pub ratio: Option<f64>,
    pub note: String,
}

/// Measures, prints, writes `target/bench.json`.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    if arguments.logs {
        return crate::logs::run();
    }
    if arguments.sweep {
        return crate::sweep::run(arguments.million, arguments.keep);
    }
    if arguments.python {
        return crate::from_python::calls();
    }
    if arguments.dask {
        return crate::from_python::cluster();
    }
    let jobs = root().join("target/bench-jobs");
    let environment = python::environment("bench/.venv", "bench/python/requirements.txt")?;
    make_jobs(&environment, &jobs)?;
    let mut measurements = whole_commands()?;
    let mut ours = cargo(&["bench", "--quiet", "--package", "coilsense", "--bench", "jobs", "--"]);
    ours.arg(&jobs);
    measurements.extend(measure("coilsense", ours)?);
    if !arguments.ours {
        measurements.extend(measure("the Rust peers", rust_peers(&jobs)?)?);
        let mut peers = environment.python();
        peers.arg("bench/python/peers.py").arg(&jobs);
        measurements.extend(measure("the Python peers", peers)?);
    }
    let rows = with_ratios(measurements);
    print(&rows);
    let all_met = crate::goals::print(&rows);
    let path = root().join("target/bench.json");
    std::fs::write(&path, serde_json::to_string_pretty(&rows)? + "\n")
        .with_context(|| format!("{} cannot be written", path.display()))?;
    println!("\n{} rows in target/bench.json", rows.len());
    if arguments.keep {
        crate::tables::keep(crate::tables::BENCH, &rows)?;
    }
    if arguments.check && !all_met {
        bail!("a goal is missed");
    }
    Ok(())
}

fn make_jobs(environment: &Environment, jobs: &Path) -> anyhow::Result<()> {
    eprintln!("== jobs and their references");
    let mut command = environment.python();
    command.arg("bench/python/make_jobs.py").arg(jobs).stdout(Stdio::null());
    if !command.status()?.success() {
        bail!("bench/python/make_jobs.py failed");
    }
    Ok(())
}

/// Builds the Rust peers, which are no part of the workspace.
fn rust_peers(jobs: &Path) -> anyhow::Result<Command> {
    eprintln!("== building the Rust peers (minutes, the first time)");
    let target = root().join("bench/peers/target");
    let mut build = cargo(&["build", "--release", "--locked", "--quiet", "--manifest-path", "bench/peers/Cargo.toml"]);
    build.arg("--target-dir").arg(&target);
    if !build.status()?.success() {
        bail!("the Rust peers do not build");
    }
    let mut command = Command::new(target.join("release/peers"));
    command.arg(jobs).current_dir(root());
    Ok(command)
}

/// Runs a program that prints one measurement per line.
pub fn measure(name: &str, mut command: Command) -> anyhow::Result<Vec<Measurement>> {
    eprintln!("== measuring {name}");
    let output = command.stderr(Stdio::inherit()).output().with_context(|| format!("cannot start {command:?}"))?;
    if !output.status.success() {
        bail!("{name} failed");
    }
    let text = String::from_utf8(output.stdout).context("a measurement that is not UTF-8")?;
    let lines = text.lines().filter(|line| line.starts_with('{'));
    lines.map(|line| serde_json::from_str(line).with_context(|| format!("not a measurement: {line}"))).collect()
}

/// Whole commands: `coilsense reproduce`, `coilsense identify`, and `coilsense analyze` on every example, `rig` on those of a rig, `speed` on those of a cam,
/// `simulate` on those of several springs.
fn whole_commands() -> anyhow::Result<Vec<Measurement>> {
    let executable = commands::with_every_format()?;
    let (log, _log) = crate::logs::a_minute()?;
    let log = log.display().to_string();
    let mut all =
        vec![whole(&executable, "reproduce", &["reproduce"])?, whole(&executable, IDENTIFY, &["identify", &log])?];
    for spec in commands::examples()? {
        let name = spec.file_stem().and_then(std::ffi::OsStr::to_str).unwrap_or_default();
        let path = spec.display().to_string();
        if commands::is_cam(&spec)? {
            let [command, options @ ..] = &commands::SPEED;
            let arguments = [&[*command, &path], &options[..]].concat();
            all.push(whole(&executable, &format!("speed {name}"), &arguments)?);
            continue;
        }
        let (job, command) = match (commands::is_rig(&spec)?, commands::has_several_springs(&spec)?) {
            (true, _) => ("rig ", "rig"),
            (_, true) => ("simulate ", SIMULATE),
            _ => (ANALYZE, "analyze"),
        };
        all.push(whole(&executable, &format!("{job}{name}"), &[command, &path])?);
    }
    Ok(all)
}

/// How whole commands are told from parts of them.
pub const WHOLE: &str = "whole command";
/// The job of a log of a minute and 150 000 rows.
pub const IDENTIFY: &str = "identify minute";
/// The job of an example's analysis begins so.
pub const ANALYZE: &str = "analyze ";

/// The command that writes one file.
const SIMULATE: &str = "simulate";

/// Median time of a command that writes a folder or a file.
fn whole(executable: &Path, job: &str, arguments: &[&str]) -> anyhow::Result<Measurement> {
    eprintln!("== measuring coilsense {job}");
    let mut times = (0..RUNS).map(|_| once(executable, arguments)).collect::<anyhow::Result<Vec<f64>>>()?;
    times.sort_by(f64::total_cmp);
    Ok(Measurement {
        job: job.to_owned(),
        system: "coilsense".to_owned(),
        setting: format!("{WHOLE}, {} threads", std::thread::available_parallelism()?),
        median_ms: Some(times[times.len() / 2]),
        max_rel_error: None,
        note: format!("{RUNS} runs; all figures and files"),
    })
}

/// One run \[ms\].
fn once(executable: &Path, arguments: &[&str]) -> anyhow::Result<f64> {
    let place = tempfile::tempdir()?;
    let mut command = Command::new(executable);
    let out = if arguments.first() == Some(&SIMULATE) { "out.parquet" } else { "out" };
    command.args(arguments).arg("--out").arg(place.path().join(out)).stdout(Stdio::null());
    let begun = Instant::now();
    let status = command.status().context("the release build of coilsense cannot be started")?;
    let elapsed = begun.elapsed();
    if !status.success() {
        bail!("coilsense {} failed", arguments.join(" "));
    }
    Ok(1e3 * elapsed.as_secs_f64())
}

/// Rows job by job; the first of coilsense on a job is 1.
fn with_ratios(measurements: Vec<Measurement>) -> Vec<Row> {
    let mut jobs: Vec<String> = measurements.iter().map(|measurement| measurement.job.clone()).collect();
    let mut seen = Vec::new();
    jobs.retain(|job| {
        !seen.contains(job) && {
            seen.push(job.clone());
            true
        }
    });
    let ours =
        |job: &str| measurements.iter().find(|m| m.job == job && m.system == "coilsense").and_then(|m| m.median_ms);
    let bases: Vec<Option<f64>> = jobs.iter().map(|job| ours(job)).collect();
    let place = |job: &str| jobs.iter().position(|other| other == job).unwrap_or(jobs.len());
    let mut rows: Vec<Row> = measurements
        .into_iter()
        .map(|m| Row {
            ratio: m.median_ms.zip(bases[place(&m.job)]).map(|(median, base)| median / base),
            job: m.job,
            system: m.system,
            setting: m.setting,
            median_ms: m.median_ms,
            max_rel_error: m.max_rel_error,
            note: m.note,
        })
        .collect();
    rows.sort_by_key(|row| place(&row.job));
    rows
}

fn print(rows: &[Row]) {
    println!("{:14} {:24} {:34} {:>11} {:>9} {:>9}", "job", "system", "setting", "median [ms]", "error", "ratio");
    let mut last = "";
    for row in rows {
        if row.job != last {
            println!();
        }
        last = &row.job;
        let shown = |value: Option<f64>, show: fn(f64) -> String| value.map_or_else(|| "–".to_owned(), show);
        println!(
            "{:14} {:24} {:34} {:>11} {:>9} {:>9}{}",
            row.job,
            row.system,
            row.setting,
            shown(row.median_ms, |ms| format!("{ms:.3}")),
            shown(row.max_rel_error, |error| format!("{error:.1e}")),
            shown(row.ratio, |ratio| if ratio < 10.0 { format!("{ratio:.2}") } else { format!("{ratio:.0}") }),
            if row.median_ms.is_none() { format!("  {}", row.note) } else { String::new() },
        );
    }
}
