//! What is run, and when.
//!
//! Next door: how the spring moves in a run (`course`), what is recorded of it (`log`).

use crate::spec::RigSpec;

/// What happens in a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The actuator rests at position after position.
    Calibration,
    /// It rests at the preload.
    Preload,
    /// It swings as a sine.
    Harmonic,
    /// Its end of the spring is hit and then rests.
    Hit,
}

impl Kind {
    /// Its word in `experiment.toml`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Calibration => "calibration",
            Self::Preload => "preload",
            Self::Harmonic => "harmonic",
            Self::Hit => "hit",
        }
    }
}

/// One recorded run.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// What happens.
    pub kind: Kind,
    /// Its name, which its files carry.
    pub name: String,
    /// When its recording begins, counted from that of the first \[s\].
    pub begin: f64,
    /// How long it is recorded \[s\].
    pub duration: f64,
    /// Of the sine \[Hz\]; zero where there is none.
    pub frequency: f64,
}

/// Time from position to position \[s\], slow enough that the spring does not ring: see `course`.
pub(super) const MOVING: f64 = 1.0;
/// Rest before the first reading at a position \[s\].
pub(super) const RESTING: f64 = 0.5;
/// Readings of the LCR meter at each position.
pub(super) const READINGS: usize = 3;

/// From one position of the calibration to the next \[s\].
pub(super) fn calibration_step(settings: &RigSpec) -> f64 {
    MOVING + RESTING + READINGS as f64 * reading_interval(settings)
}

/// From one reading of the LCR meter to the next \[s\].
pub(super) fn reading_interval(settings: &RigSpec) -> f64 {
    settings.duration / settings.readings as f64
}

/// W: averaging window of the LCR meter \[s\].
pub(super) fn averaging(settings: &RigSpec) -> f64 {
    settings.meter.readout.averaging.unwrap_or_default()
}

/// Calibration, preload, sines by rising frequency, preload again, hits.
pub(super) fn of(settings: &RigSpec) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut add = |kind, name: String, duration: f64, frequency: f64| {
        let begin = runs.last().map_or(0.0, |last| last.begin + last.duration + settings.pause);
        runs.push(Run { kind, name, begin, duration, frequency });
    };
    let calibration = calibration_step(settings) * settings.calibration_positions as f64;
    add(Kind::Calibration, "calibration".into(), calibration, 0.0);
    add(Kind::Preload, "preload-first".into(), settings.duration, 0.0);
    for number in 1..=settings.frequencies {
        let frequency = number as f64 / averaging(settings);
        add(Kind::Harmonic, format!("harmonic-{number:02}"), settings.duration, frequency);
    }
    add(Kind::Preload, "preload-last".into(), settings.duration, 0.0);
    for number in 1..=settings.hits {
        add(Kind::Hit, format!("hit-{number}"), settings.duration, 0.0);
    }
    runs
}
