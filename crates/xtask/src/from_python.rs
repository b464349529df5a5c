//! What is measured from Python: single calls beside the same from Rust, and a sweep on workers of Dask.
//!
//! Next door: everything else that is measured (`bench`), the wheel (`package`).

use anyhow::{Context, bail};

use crate::bench::{Measurement, measure};
use crate::cargo;

/// Longest that a trivial call from Python may take \[ms\], and how much longer end forces may than from Rust.
const CALL_GOALS: (f64, f64) = (5e-3, 1.2);
/// Calls that hardly do anything but be called.
const TRIVIAL: [&str; 6] = [
    "Spring.static_force",
    "Spring.static_force of a text",
    "Spring.surge_frequency",
    "Spring.replace",
    "Calibration.length of 51",
    "Estimate times a number",
];
/// How often Rust and Python take turns; the medians of the turns count, for the machine is not always as fast.
const TURNS: usize = 5;
/// How much faster two workers have to be than one, on a sweep that takes one of them at least so long \[ms\].
const CLUSTER_GOALS: (f64, f64) = (1.6, 30e3);

/// Calls from Python, by turns with the same from Rust.
pub fn calls() -> anyhow::Result<()> {
    let environment = crate::package::installed()?;
    if !cargo(&["build", "--release", "--package", "coilsense", "--example", "end_forces"]).status()?.success() {
        bail!("the release build failed");
    }
    let mut measurements = Vec::new();
    for _ in 0..TURNS {
        measurements.extend(measure(
            "Rust",
            cargo(&["run", "--release", "--quiet", "-p", "coilsense", "--example", "end_forces"]),
        )?);
        let mut python = environment.python();
        python.arg("python/bench/calls.py");
        measurements.extend(measure("Python", python)?);
    }
    for setting in TRIVIAL {
        let call = median(&measurements, setting)?;
        println!("{}  {setting}: {:.3} us (goal {} us)", verdict(call <= CALL_GOALS.0), 1e3 * call, 1e3 * CALL_GOALS.0);
    }
    let (rust, python) = (median(&measurements, "Motion::end_forces")?, median(&measurements, "Motion.end_forces")?);
    let ratio = python / rust;
    println!(
        "{}  S_T, 1 s at 10 kHz, end forces: {python:.4} ms from Python, {rust:.4} ms from Rust: {ratio:.2}x (goal {}x)",
        verdict(ratio <= CALL_GOALS.1),
        CALL_GOALS.1
    );
    Ok(())
}

/// A sweep on one worker and on two.
pub fn cluster() -> anyhow::Result<()> {
    let environment = crate::package::installed()?;
    let mut sweeps = environment.python();
    sweeps.arg("bench/python/dask_sweep.py");
    let measurements = measure("a sweep on one worker of Dask and on two", sweeps)?;
    let (one, two) = (median(&measurements, "1 worker")?, median(&measurements, "2 workers")?);
    let note = measurements.first().map_or("", |first| first.note.as_str());
    println!(
        "{}  {note}: {:.1} s on one worker (goal {} s or more), {:.1} s on two: {:.2}x (goal {}x)",
        verdict(one >= CLUSTER_GOALS.1 && one / two >= CLUSTER_GOALS.0),
        1e-3 * one,
        1e-3 * CLUSTER_GOALS.1,
        1e-3 * two,
        one / two,
        CLUSTER_GOALS.0
    );
    Ok(())
}

/// The median over what was measured of a setting \[ms\].
fn median(measurements: &[Measurement], setting: &str) -> anyhow::Result<f64> {
    let of_setting = measurements.iter().filter(|each| each.setting == setting);
    let mut all: Vec<f64> = of_setting.filter_map(|each| each.median_ms).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().with_context(|| format!("{setting} was not measured"))
}

fn verdict(holds: bool) -> &'static str {
    if holds { "met   " } else { "MISSED" }
}
