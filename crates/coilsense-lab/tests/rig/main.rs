//! The virtual rig: its numbers against closed forms with every instrument perfect, and against their statistics with the paper's.
//!
//! | ours | held against |
//! |---|---|
//! | F_o and u1 of a sine | the two-port, over whole windows (`perfect`) |
//! | L | a direct solve of the windings' equations, another set of instants (`perfect`) |
//! | calibration, hits, relaxation | k, ζ, the logarithm that were put in (`perfect`) |
//! | noise, gains, steps, seeds | what the spec says of them (`instruments`) |
//! | the findings of the paper's Fig. 6 | themselves (`findings`) |
//! | hits | ζ and f1 as `coilsense::identify` finds them (`identified`) |
//! | files, refusals | (`files`) |

mod files;
mod findings;
mod identified;
mod instruments;
mod perfect;

use coilsense_lab::rig::{Kind, Log, Rig};
use coilsense_lab::spec::Spec;

const S_T: &str = include_str!("../../data/springs/S_T.toml");

/// ζ of the tests.
const RATIO: f64 = 0.005;

/// Instruments without errors, and a spring that does not relax: 8.9 s hold twenty windows of 445 ms, and 22 250 samples.
const PERFECT: &str = r#"
[mount]
damping_ratio = 0.005
[[sensor]]
kind = "load-cell"
range = "110 N"
[[sensor]]
kind = "deflection"
range = "10 mm"
[[sensor]]
kind = "inductance"
averaging = "445 ms"
[rig]
duration = "8.9 s"
readings = 10
relaxation = "0 %"
"#;

/// The paper's instruments.
const PAPER: &str = "\n[mount]\ndamping_ratio = 0.005\n[rig]\n";

fn spec(tables: &str) -> Spec {
    let text = format!("{S_T}{tables}");
    Spec::parse("test.toml", &text, &|name| Err(format!("{name}: no files here"))).unwrap_or_else(|e| panic!("{e}"))
}

fn rig(tables: &str, seed: u64) -> Rig {
    Rig::new(&spec(tables), seed).unwrap_or_else(|error| panic!("{error}"))
}

/// The log of a run by its name.
fn log(rig: &Rig, name: &str) -> Log {
    let number = rig.runs().iter().position(|run| run.name == name).unwrap_or_else(|| panic!("no run {name}"));
    rig.log(number).unwrap_or_else(|error| panic!("{error}"))
}

/// F_o and u1 of a log.
fn ends(log: &Log) -> (&[f64], &[f64]) {
    (log.fast.values("F_o").unwrap(), log.fast.values("u1").unwrap())
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Standard deviation.
fn spread(values: &[f64]) -> f64 {
    let mean = mean(values);
    (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (values.len() - 1) as f64).sqrt()
}

fn harmonics(rig: &Rig) -> impl Iterator<Item = &coilsense_lab::rig::Run> {
    rig.runs().iter().filter(|run| run.kind == Kind::Harmonic)
}
