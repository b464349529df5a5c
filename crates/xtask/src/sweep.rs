//! `cargo xtask bench --sweep`: designs a second, on one core and on two, against the goals; a million of them on demand.
//!
//! The designs are those of examples/sea-ankle.toml without damping: S_T, 52 windings, the paper's five conditions at 10 kHz, 0.75 to 1 s, its
//! stiffness and mass varied by normal distributions. F_L's second-order form does not hold within 1e-6 of L in all of the five, where the exact
//! sum is taken; so it is measured by itself on motions of a tenth of the size, where it does.
//!
//! Next door: single jobs and peers (`bench`).

use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Context, bail};
use serde::{Deserialize, Serialize};

use crate::{commands, root};

/// What to measure: a name, how much larger the motions are, columns, rows, and how many a second are wanted.
struct Case {
    name: &'static str,
    scale: f64,
    columns: &'static str,
    rows: u64,
    wanted: f64,
}

const CASES: [Case; 3] = [
    Case { name: "F_i, F_o, F_x", scale: 1.0, columns: "F_i.rmsd,F_o.rmsd,F_x.rmsd", rows: 20_000, wanted: 5000.0 },
    Case { name: "F_L, second order", scale: 0.1, columns: "F_L.rmsd,F_L.method", rows: 1500, wanted: 300.0 },
    Case { name: "F_L, exact where due", scale: 1.0, columns: "F_L.rmsd,F_L.method", rows: 600, wanted: 60.0 },
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

/// Designs a second with some columns.
#[derive(Serialize, Deserialize)]
pub struct Designs {
    pub columns: String,
    pub one_core: f64,
    pub two_cores: f64,
    pub wanted: f64,
}

/// Measures and prints; keeps it where that is asked for.
pub fn run(million: bool, keep: bool) -> anyhow::Result<()> {
    let executable = commands::with_every_format()?;
    println!("{:22} {:>7} {:>5} {:>12} {:>9}  goal", "designs", "rows", "cores", "designs/s", "peak MB");
    let mut rows = Vec::new();
    for case in CASES {
        let best = |jobs: u64| -> anyhow::Result<Summary> {
            let runs = (0..RUNS).map(|_| once(&executable, &case, case.rows, jobs));
            let runs = runs.collect::<anyhow::Result<Vec<Summary>>>()?;
            runs.into_iter().min_by(|a, b| a.seconds.total_cmp(&b.seconds)).context("no run")
        };
        let one = best(1)?;
        show(case.name, 1, &one, &format!("{} wanted: {}", case.wanted, met(one.designs_per_second >= case.wanted)));
        let two = best(2)?;
        let gain = two.designs_per_second / one.designs_per_second;
        show(case.name, 2, &two, &format!("{gain:.2} times, {WANTED_GAIN} wanted: {}", met(gain >= WANTED_GAIN)));
        rows.push(Designs {
            columns: case.name.to_owned(),
            one_core: one.designs_per_second,
            two_cores: two.designs_per_second,
            wanted: case.wanted,
        });
    }
    if keep {
        crate::tables::keep(crate::tables::DESIGNS, &rows)?;
    }
    if million {
        let all = once(&executable, &CASES[0], 1_000_000, 2)?;
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

/// What makes of the example the designs of a case: no damping, velocities and amplitudes larger by a factor (those of end stops are the
/// range in a second, 68 mm/s), and a spring that varies.
fn over(scale: f64) -> Vec<String> {
    let motions = [
        ("condition.1.velocity", 250.0, "mm/s"),
        ("condition.2.velocity", 68.0, "mm/s"),
        ("condition.3.velocity", 68.0, "mm/s"),
        ("condition.4.amplitude", 1.0, "%"),
        ("condition.5.amplitude", 0.1, "%"),
    ];
    let mut over: Vec<String> = motions.map(|(key, size, unit)| format!("{key}={} {unit}", scale * size)).into();
    let others = ["mount.damping_ratio=0", "spring.stiffness=normal(760 N/m, 5 %)", "spring.mass=normal(65 g, 5 %)"];
    over.extend(others.map(str::to_owned));
    over
}

fn once(executable: &Path, case: &Case, rows: u64, jobs: u64) -> anyhow::Result<Summary> {
    let place = tempfile::tempdir()?;
    let mut command = Command::new(executable);
    command.arg("sweep").arg(root().join("examples/sea-ankle.toml")).args(["--json", "--columns", case.columns]);
    for over in over(case.scale) {
        command.args(["--over", &over]);
    }
    command.args(["--rows", &rows.to_string(), "--jobs", &jobs.to_string(), "--out"]).arg(place.path().join("out"));
    let output = command.stderr(Stdio::inherit()).output().context("the release build cannot be started")?;
    if !output.status.success() {
        bail!("coilsense sweep failed");
    }
    serde_json::from_slice(&output.stdout).context("the summary is no JSON")
}
