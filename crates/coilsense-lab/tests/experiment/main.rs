//! Experiments processed: series whose measures are closed forms (`closed`), a stored calibration (`stored`), files that are wrong (`hostile`), frequencies that do not fit (`stated`), the virtual rig (`rig`).
//!
//! Here: a folder with an experiment in it, made of known sines.

mod closed;
mod hostile;
mod keys;
mod rig;
mod stated;
mod stored;

use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use coilsense_lab::experiment::{Experiment, ExperimentError};
use coilsense_lab::recording::Cleaning;
use tempfile::TempDir;

/// Spring and curve of the made-up experiments.
const STIFFNESS: f64 = 760.0;
const REST_LENGTH: f64 = 0.104;
const LENGTH: f64 = 0.138;
const ALPHA: f64 = 1.6e6;
const BETA: f64 = 0.3;
/// Samples a second, and how many a run has.
const RATE: f64 = 2000.0;
const SAMPLES: usize = 8000;

/// Sine of the position and of the force at the load cell, and what is added to the latter and to the force by inductance \[N\].
#[derive(Clone, Copy, Default)]
struct Sines {
    frequency: f64,
    by_position: f64,
    at_load_cell: f64,
    output_offset: f64,
    inductance_offset: f64,
}

/// F_p \[N\].
fn preload() -> f64 {
    STIFFNESS * (LENGTH - REST_LENGTH)
}

/// L \[H\] from which the curve reads the length of a force \[N\].
fn inductance(force: f64) -> f64 {
    (1.0 / (REST_LENGTH + force / STIFFNESS) - BETA) / ALPHA
}

impl Sines {
    fn fast(self) -> String {
        let row = |index: usize| {
            let time = index as f64 / RATE;
            let sine = (TAU * self.frequency * time).sin();
            let output = preload() + self.output_offset + self.at_load_cell * sine;
            format!("{time},{output},{}\n", -1e3 * self.by_position * sine / STIFFNESS)
        };
        "time [s],F_o [N],u1 [mm]\n".to_owned() + &(0..SAMPLES).map(row).collect::<String>()
    }

    fn slow(self) -> String {
        // Readings that scatter by ±1 mN about their mean.
        let row = |index: usize| {
            let scatter = if index.is_multiple_of(2) { 1e-3 } else { -1e-3 };
            format!("{},{}\n", 0.5 * index as f64, inductance(preload() + self.inductance_offset + scatter))
        };
        "time [s],L [H]\n".to_owned() + &(0..16).map(row).collect::<String>()
    }
}

/// What `experiment.toml` says of all runs.
const TOP: &str = "nominal_force = \"100 N\"\nlength_at_zero_force = \"104 mm\"\n";
/// The spring as given.
const GIVEN: &str =
    "stiffness = \"760 N/m\"\nlength_at_zero = \"138 mm\"\ninverse_length = { alpha = 1.6e6, beta = 0.3 }\n";

/// A folder with preload, sines and preload; `top` goes before the runs.
fn folder(top: &str, runs: &[Sines]) -> TempDir {
    let place = tempfile::tempdir().unwrap();
    let mut text = top.to_owned();
    for (index, run) in runs.iter().enumerate() {
        let kind = if run.frequency > 0.0 { "harmonic" } else { "preload" };
        text.push_str(&format!(
            "\n[[run]]\nkind = \"{kind}\"\nfast = \"{index}-fast.csv\"\nslow = \"{index}-slow.csv\"\n"
        ));
        if run.frequency > 0.0 {
            text.push_str(&format!("frequency = \"{} Hz\"\n", run.frequency));
        }
        write(place.path(), &format!("{index}-fast.csv"), &run.fast());
        write(place.path(), &format!("{index}-slow.csv"), &run.slow());
    }
    write(place.path(), "experiment.toml", &text);
    place
}

fn write(place: &Path, name: &str, text: &str) {
    fs::write(place.join(name), text).unwrap();
}

fn read(place: &TempDir) -> Result<Experiment, ExperimentError> {
    Experiment::read(place.path(), &Cleaning::default())
}

/// Preload, four sines of which the third is a resonance, preload.
fn usual() -> Vec<Sines> {
    let sine = |frequency, at_load_cell| Sines { frequency, by_position: 0.7, at_load_cell, ..Sines::default() };
    vec![Sines::default(), sine(5.0, 0.7), sine(10.0, 0.8), sine(20.0, 3.1), sine(25.0, 1.0), Sines::default()]
}
