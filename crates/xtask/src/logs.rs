//! `cargo xtask bench --logs`: how long `coilsense import` takes on a log, and how much memory.
//!
//! Next door: other jobs (`bench`).

use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, bail};

use crate::{commands, root};

/// Rate of the made logs \[Hz\].
const RATE: f64 = 2500.0;
/// Rows of a minute, and bytes of the large log.
const MINUTE: u64 = 150_000;
const LARGE: u64 = 2_000_000_000;
/// What a minute may take at most \[s\], and the large log in memory \[MB\].
const LONGEST: f64 = 0.3;
const MOST_MEMORY: f64 = 100.0;

/// Makes a log of a minute and one of 2 GB, imports them, prints time and peak memory.
pub fn run() -> anyhow::Result<()> {
    let executable = commands::executable()?;
    let place = root().join("target/bench-logs");
    std::fs::create_dir_all(&place)?;
    println!("{:34} {:>9} {:>14} {:>9}", "job", "time [s]", "peak RSS [MB]", "MB/s");
    let minute = made(&place, "minute.csv", |rows, _| rows == MINUTE)?;
    for out in ["minute-out.csv", "minute-out.parquet"] {
        let mut runs =
            (0..5).map(|_| measured(&executable, &minute, &place.join(out))).collect::<anyhow::Result<Vec<_>>>()?;
        runs.sort_by(|a, b| a.0.total_cmp(&b.0));
        told("60 s, 5 channels, 2.5 kHz", &minute, out, runs[2], runs[2].0 <= LONGEST)?;
    }
    let large = made(&place, "large.csv", |_, bytes| bytes >= LARGE)?;
    for out in ["large-out.csv", "large-out.parquet"] {
        let run = measured(&executable, &large, &place.join(out))?;
        told("2 GB", &large, out, run, run.1 <= MOST_MEMORY)?;
        std::fs::remove_file(place.join(out))?;
    }
    std::fs::remove_file(&large)?;
    Ok(())
}

/// One line of the table; a goal that is missed is said.
fn told(job: &str, log: &Path, out: &str, (seconds, memory): (f64, f64), met: bool) -> anyhow::Result<()> {
    let ending = out.rsplit('.').next().unwrap_or_default();
    let speed = std::fs::metadata(log)?.len() as f64 / 1e6 / seconds;
    let verdict = if met { "" } else { "  MISSED" };
    println!("{:34} {seconds:9.3} {memory:14.1} {speed:9.1}{verdict}", format!("{job} to {ending}"));
    Ok(())
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

/// Wall time \[s\] and peak memory \[MB\] of an import.
fn measured(executable: &Path, log: &Path, out: &Path) -> anyhow::Result<(f64, f64)> {
    let mut command = Command::new(executable);
    command.arg("import").arg(log).arg("--out").arg(out).stdout(Stdio::null());
    let begun = Instant::now();
    let mut child = command.spawn().context("the release build of coilsense cannot be started")?;
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
        bail!("coilsense import failed");
    }
    Ok((begun.elapsed().as_secs_f64(), peak))
}

/// `VmHWM` of a process \[MB\]; none where there is no `/proc`.
fn high_water(status: &str) -> Option<f64> {
    let text = std::fs::read_to_string(status).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok()? * 1024.0 / 1e6)
}
