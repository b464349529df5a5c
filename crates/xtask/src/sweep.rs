//! `cargo xtask bench --sweep`: designs a second, on one core and on two, against the goals; a million of them on demand.
//!
//! The designs are those of examples/sea-ankle.toml without damping: S_T, 52 windings, the paper's five conditions at 10 kHz, 0.75 to 1 s, its
//! stiffness and mass varied by normal distributions. F_L's second-order form holds within 1e-6 of L in three of the five; so it is measured
//! apart on motions of a tenth of the size, where it holds in all, and the exact sum on motions ten times the size.
//!
//! Next door: single jobs and peers (`bench`).

use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Context, bail};
use serde::Deserialize;

use crate::{commands, root};

/// What to measure: a name, how much larger the motions are, columns, rows, and how many a second are wanted.
struct Case {
    name: &'static str,
    scale: f64,
    columns: &'static str,
    rows: u64,
    wanted: f64,
}

const CASES: [Case; 4] = [
    Case { name: "F_i, F_o, F_x", scale: 1.0, columns: "F_i.rmsd,F_o.rmsd,F_x.rmsd", rows: 20_000, wanted: 5000.0 },
    Case { name: "F_L, second order", scale: 0.1, columns: "F_L.rmsd,F_L.method", rows: 1500, wanted: 300.0 },
    Case { name: "F_L, exact", scale: 10.0, columns: "F_L.rmsd,F_L.method", rows: 300, wanted: 60.0 },
    Case { name: "F_L, as in the paper", scale: 1.0, columns: "F_L.rmsd,F_L.method", rows: 600, wanted: 60.0 },
];

/// How often each is run; the fastest counts, for whatever else runs only slows it down.
const RUNS: usize = 3;

/// The gain of a second core that is wanted.
const WANTED_GAIN: f64 = 1.8;

/// What `coilsense sweep --json` prints.
#[derive(Deserialize)]
struct Summary {
    rows: u64,
    ok: u64,
    clash: u64,
    refused: u64,
    seconds: f64,
    designs_per_second: f64,
    peak_memory_kb: Option<u64>,
}

/// Measures and prints.
pub fn run(million: bool) -> anyhow::Result<()> {
    let executable = commands::executable()?;
    let place = tempfile::tempdir()?;
    println!("{:22} {:>7} {:>5} {:>12} {:>9}  goal", "designs", "rows", "cores", "designs/s", "peak MB");
    for case in CASES {
        let spec = place.path().join("spec.toml");
        std::fs::write(&spec, scaled(case.scale)?)?;
        let best = |jobs: u64| -> anyhow::Result<Summary> {
            let runs = (0..RUNS).map(|_| once(&executable, &spec, &case, case.rows, jobs));
            let runs = runs.collect::<anyhow::Result<Vec<Summary>>>()?;
            runs.into_iter().min_by(|a, b| a.seconds.total_cmp(&b.seconds)).context("no run")
        };
        let one = best(1)?;
        show(case.name, 1, &one, &format!("{} wanted: {}", case.wanted, met(one.designs_per_second >= case.wanted)));
        let two = best(2)?;
        let gain = two.designs_per_second / one.designs_per_second;
        show(case.name, 2, &two, &format!("{gain:.2} times, {WANTED_GAIN} wanted: {}", met(gain >= WANTED_GAIN)));
    }
    if million {
        let spec = place.path().join("spec.toml");
        std::fs::write(&spec, scaled(1.0)?)?;
        let all = once(&executable, &spec, &CASES[0], 1_000_000, 2)?;
        show("a million of the first", 2, &all, &format!("{:.0} s", all.seconds));
    }
    Ok(())
}

fn met(holds: bool) -> &'static str {
    if holds { "met" } else { "MISSED" }
}

fn show(name: &str, cores: u64, summary: &Summary, goal: &str) {
    let peak = summary.peak_memory_kb.map_or_else(|| "–".to_owned(), |kb| (kb / 1000).to_string());
    println!("{name:22} {:>7} {cores:>5} {:>12.0} {peak:>9}  {goal}", summary.rows, summary.designs_per_second);
    if summary.ok + summary.clash < summary.rows {
        println!("  {} refused", summary.refused);
    }
}

/// The example without damping, its velocities and amplitudes larger by a factor.
fn scaled(factor: f64) -> anyhow::Result<String> {
    let text = std::fs::read_to_string(root().join("examples/sea-ankle.toml")).context("the example cannot be read")?;
    let text = text.replace("end2 = \"held\"", "damping_ratio = 0\nend2 = \"held\"");
    let number = |value: f64, unit: &str| format!("\"{} {unit}\"", factor * value);
    let text = text
        .replace("\"0.25 m/s\"", &number(0.25, "m/s"))
        .replace("\"1 %\"               # of the range", &number(1.0, "%"));
    // End stops have the speed that traverses the range in 1 s: 68 mm.
    let speed = format!("kind = \"end-stop\"\nvelocity = {}", number(68.0, "mm/s"));
    let text = text.replace("\"0.1 %\"             # 68", &format!("{} # 68", number(0.1, "%")));
    Ok(text.replace("kind = \"end-stop\"", &speed))
}

fn once(executable: &Path, spec: &Path, case: &Case, rows: u64, jobs: u64) -> anyhow::Result<Summary> {
    let place = tempfile::tempdir()?;
    let mut command = Command::new(executable);
    command.arg("sweep").arg(spec).args(["--over", "spring.stiffness=normal(760 N/m, 5 %)"]);
    command.args(["--over", "spring.mass=normal(65 g, 5 %)", "--json", "--columns", case.columns]);
    command.args(["--rows", &rows.to_string(), "--jobs", &jobs.to_string(), "--out"]).arg(place.path().join("out"));
    let output = command.stderr(Stdio::inherit()).output().context("the release build cannot be started")?;
    if !output.status.success() {
        bail!("coilsense sweep failed");
    }
    serde_json::from_slice(&output.stdout).context("the summary is no JSON")
}
