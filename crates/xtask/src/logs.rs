//! `cargo xtask bench --logs`: how long `coilsense import` and `identify` take on a log, and how much memory; import beside polars.
//!
//! Next door: other jobs (`bench`).

use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, bail};

use crate::{commands, python, root};

/// Rate of the made logs \[Hz\].
const RATE: f64 = 2500.0;
/// Rows of a minute, and bytes of the large log.
const MINUTE: u64 = 150_000;
const LARGE: u64 = 2_000_000_000;
/// Rows of the log that is converted beside polars, and identified.
const MANY: u64 = 10_000_000;
/// What a minute may take at most \[s\], and a large log in memory \[MB\].
const LONGEST: f64 = 0.3;
const MOST_MEMORY: f64 = 100.0;
/// What many rows may take at most: over polars with as many threads, and to be identified \[MB\].
const MOST_OVER_POLARS: f64 = 2.0;
const MOST_TO_IDENTIFY: f64 = 700.0;

/// Makes logs of a minute, of ten million rows and of 2 GB, imports them, prints time and peak memory.
pub fn run() -> anyhow::Result<()> {
    let executable = commands::with_every_format()?;
    let place = root().join("target/bench-logs");
    std::fs::create_dir_all(&place)?;
    println!("{:46} {:>9} {:>14} {:>9}", "job", "time [s]", "peak RSS [MB]", "MB/s");
    let import = |log: &Path, out: &Path| {
        let mut command = Command::new(&executable);
        command.arg("import").arg(log).arg("--overwrite").arg("--out").arg(out);
        command
    };
    let minute = made(&place, "minute.csv", |rows, _| rows == MINUTE)?;
    for out in ["minute-out.csv", "minute-out.parquet"] {
        let run = median(5, || measured(import(&minute, &place.join(out))))?;
        told(&format!("60 s, 5 channels, 2.5 kHz to {}", ending(out)), &minute, run, run.0 <= LONGEST)?;
    }
    many(&executable, &import, &place)?;
    let large = made(&place, "large.csv", |_, bytes| bytes >= LARGE)?;
    for out in ["large-out.csv", "large-out.parquet"] {
        let run = measured(import(&large, &place.join(out)))?;
        told(&format!("2 GB to {}", ending(out)), &large, run, run.1 <= MOST_MEMORY)?;
        std::fs::remove_file(place.join(out))?;
    }
    std::fs::remove_file(&large)?;
    Ok(())
}

/// Ten million rows to Parquet, by turns with polars on one thread as ours; then identified.
fn many(executable: &Path, import: &dyn Fn(&Path, &Path) -> Command, place: &Path) -> anyhow::Result<()> {
    let polars = python::environment("target/bench-polars", "bench/logs/requirements.txt")?;
    let log = made(place, "many.csv", |rows, _| rows == MANY)?;
    let (ours, theirs) = (place.join("many-out.parquet"), place.join("many-polars.parquet"));
    let mut runs = [Vec::new(), Vec::new(), Vec::new()];
    for _ in 0..3 {
        runs[0].push(measured(import(&log, &ours))?);
        for (way, runs) in ["whole", "streamed"].into_iter().zip(&mut runs[1..]) {
            let mut command = polars.python();
            command.arg("bench/logs/convert.py").arg(way).arg(&log).arg(&theirs).env("POLARS_MAX_THREADS", "1");
            runs.push(measured(command)?);
        }
    }
    let [ours_run, whole, streamed] = runs.map(middle);
    let ratio = ours_run.0 / whole.0.min(streamed.0);
    told("10 million rows to parquet", &log, ours_run, ratio <= MOST_OVER_POLARS && ours_run.1 <= MOST_MEMORY)?;
    told("the same, polars, one thread, whole", &log, whole, true)?;
    told("the same, polars, one thread, streamed", &log, streamed, true)?;
    println!("  {ratio:.2} times the quicker of them (goal at most {MOST_OVER_POLARS})");
    for file in [&log, &ours] {
        let mut command = Command::new(executable);
        command.arg("identify").arg(file);
        let run = measured(command)?;
        let job = format!("10 million rows of {} identified", ending(&file.to_string_lossy()));
        told(&job, file, run, run.1 <= MOST_TO_IDENTIFY)?;
    }
    [&log, &ours, &theirs].into_iter().try_for_each(std::fs::remove_file)?;
    Ok(())
}

/// The run of median time among several.
fn median(count: usize, run: impl Fn() -> anyhow::Result<(f64, f64)>) -> anyhow::Result<(f64, f64)> {
    Ok(middle((0..count).map(|_| run()).collect::<anyhow::Result<Vec<_>>>()?))
}

fn middle(mut runs: Vec<(f64, f64)>) -> (f64, f64) {
    runs.sort_by(|a, b| a.0.total_cmp(&b.0));
    runs[runs.len() / 2]
}

fn ending(file: &str) -> &str {
    file.rsplit('.').next().unwrap_or_default()
}

/// One line of the table; a goal that is missed is said.
fn told(job: &str, log: &Path, (seconds, memory): (f64, f64), met: bool) -> anyhow::Result<()> {
    let speed = std::fs::metadata(log)?.len() as f64 / 1e6 / seconds;
    let verdict = if met { "" } else { "  MISSED" };
    println!("{job:46} {seconds:9.3} {memory:14.1} {speed:9.1}{verdict}");
    Ok(())
}

/// A log of a minute, and the folder that it is in for as long as that is kept.
pub fn a_minute() -> anyhow::Result<(PathBuf, tempfile::TempDir)> {
    let place = tempfile::tempdir()?;
    Ok((made(place.path(), "minute.csv", |rows, _| rows == MINUTE)?, place))
}

/// A log of five channels that ring, of which each number has the digits that an instrument gives.
fn made(place: &Path, name: &str, enough: impl Fn(u64, u64) -> bool) -> anyhow::Result<PathBuf> {
    let path = place.join(name);
    let mut file = BufWriter::new(std::fs::File::create(&path).with_context(|| format!("{name} cannot be made"))?);
    writeln!(file, "time [s],u1 [mm],u2 [mm],F_i [N],F_o [N],L [uH]")?;
    let (mut rows, mut bytes) = (0, 0);
    let mut line = Vec::new();
    while !enough(rows, bytes) {
        let time = rows as f64 / RATE;
        let ringing = (340.0 * time).sin();
        line.clear();
        writeln!(
            line,
            "{time:.4},{:.5},{:.5},{:.4},{:.4},{:.6}",
            0.01 * ringing,
            126.0 + (7.0 * time).sin(),
            95.0 + 3.0 * ringing,
            95.0 - 2.9 * ringing,
            3.3 + 0.02 * ringing
        )?;
        file.write_all(&line)?;
        bytes += line.len() as u64;
        rows += 1;
    }
    file.flush()?;
    Ok(path)
}

/// Wall time \[s\] and peak memory \[MB\] of a command.
fn measured(mut command: Command) -> anyhow::Result<(f64, f64)> {
    command.stdout(Stdio::null());
    let begun = Instant::now();
    let mut child =
        command.spawn().with_context(|| format!("{} cannot be started", command.get_program().display()))?;
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0.0_f64;
    let ended = loop {
        // The kernel's own high-water mark: what is missed between two looks is in the next.
        peak = peak.max(high_water(&status).unwrap_or(0.0));
        if let Some(ended) = child.try_wait()? {
            break ended;
        }
        std::thread::sleep(Duration::from_millis(1));
    };
    if !ended.success() {
        bail!("{} failed", command.get_program().display());
    }
    Ok((begun.elapsed().as_secs_f64(), peak))
}

/// `VmHWM` of a process \[MB\]; none where there is no `/proc`.
fn high_water(status: &str) -> Option<f64> {
    let text = std::fs::read_to_string(status).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok()? * 1024.0 / 1e6)
}
