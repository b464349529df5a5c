//! Harmonics of a cam across the lines of a spring and its neighbours, over the speed of the engine.
//!
//! Next door: what the spring does at each speed (the parent).

use coilsense::modes::ModalModel;

use super::Range;
use crate::data_sheet::DataSheet;
use crate::spec::{CamSpec, Spec};

/// A line that does not move with the speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// `f1`, `torsional`, `lateral`.
    pub name: String,
    /// \[Hz\].
    pub frequency: f64,
}

impl Line {
    /// Whether it is one of the chain's surge frequencies.
    pub fn is_surge(&self) -> bool {
        self.name.starts_with('f')
    }
}

/// Where a harmonic of the cam has the first surge frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// Which harmonic of the camshaft.
    pub harmonic: usize,
    /// Of the engine \[Hz\].
    pub speed: f64,
    /// Amplitude of that harmonic of the lift \[m\].
    pub amplitude: f64,
}

/// The map of lines.
#[derive(Debug, Clone, PartialEq)]
pub struct Campbell {
    /// Surge lines of the chain, and the first of each other kind of the coil as a helix.
    pub lines: Vec<Line>,
    /// Crossings within the range, by rising speed.
    pub crossings: Vec<Crossing>,
    /// How many harmonics are drawn.
    pub harmonics: usize,
}

/// Surge lines that are drawn.
const SURGES: usize = 3;
/// Most harmonics that are looked at, and the least of the largest amplitude that counts.
const MOST_HARMONICS: usize = 40;
const LEAST: f64 = 1e-4;
/// Most harmonics that are drawn.
const MOST_DRAWN: usize = 16;
/// Samples of a turn for the harmonics.
const SAMPLES: usize = 2048;

impl Campbell {
    pub(super) fn of(spec: &Spec, cam: &CamSpec, range: &Range) -> Self {
        let modes = ModalModel::chain(&spec.spring.spring, spec.mount.far_end());
        let surges = modes.frequencies().iter().take(SURGES).enumerate();
        let mut lines: Vec<Line> = surges
            .map(|(index, angular)| Line {
                name: format!("f{}", index + 1),
                frequency: angular / std::f64::consts::TAU,
            })
            .collect();
        lines.extend(neighbours(spec));
        let first = lines.first().map_or(0.0, |line| line.frequency);
        let amplitudes = amplitudes(cam);
        let largest = amplitudes.iter().copied().fold(0.0, f64::max);
        let crossing = |harmonic: usize| Crossing {
            harmonic,
            speed: first / (harmonic as f64 * range.ratio),
            amplitude: amplitudes[harmonic - 1],
        };
        let counts = |crossing: &Crossing| {
            (range.from..=range.to).contains(&crossing.speed) && crossing.amplitude > LEAST * largest
        };
        let mut crossings: Vec<Crossing> = (1..=MOST_HARMONICS).map(crossing).filter(counts).collect();
        crossings.reverse();
        let harmonics = crossings.first().map_or(MOST_DRAWN, |lowest| (lowest.harmonic + 2).min(MOST_DRAWN));
        Self { lines, crossings, harmonics }
    }
}

/// The first torsional and the first lateral line of the coil as a helix, about the middle of its range and as the data sheet has it.
fn neighbours(spec: &Spec) -> Vec<Line> {
    let Ok(sheet) = DataSheet::of(spec) else { return Vec::new() };
    let Some(way) = sheet.modes_at.get(sheet.modes_at.len() / 2).and_then(|at| at.ways().next()) else {
        return Vec::new();
    };
    let first_of = |kind: &str| {
        let mode = way.modes.iter().find(|mode| mode.kind == kind)?;
        Some(Line { name: kind.to_owned(), frequency: mode.frequency_hz })
    };
    ["torsional", "lateral"].into_iter().filter_map(first_of).collect()
}

/// Amplitudes of the harmonics of the lift \[m\].
fn amplitudes(cam: &CamSpec) -> Vec<f64> {
    let lifts: Vec<f64> = (0..SAMPLES).map(|sample| cam.lift_at(sample as f64 / SAMPLES as f64)).collect();
    let of = |harmonic: usize| {
        let angle = |sample: usize| std::f64::consts::TAU * (harmonic * sample % SAMPLES) as f64 / SAMPLES as f64;
        let cosine: f64 = lifts.iter().enumerate().map(|(sample, lift)| lift * angle(sample).cos()).sum();
        let sine: f64 = lifts.iter().enumerate().map(|(sample, lift)| lift * angle(sample).sin()).sum();
        2.0 / SAMPLES as f64 * cosine.hypot(sine)
    };
    (1..=MOST_HARMONICS).map(of).collect()
}
