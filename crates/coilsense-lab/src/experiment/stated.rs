//! Whether a run moves at the frequency that it states: a slip of the pen, or two files that changed places.
//!
//! Next door: the frequency of a motion (`coilsense::measures::Sinusoid`), a run's log (`fast`).

use coilsense::measures::{Sinusoid, alias_of};

use super::{Experiment, ExperimentError, Run};
use crate::quantity::digits;

/// The least share of a motion that a line must have for its run to be refused by it.
const CLEAR: f64 = 0.5;
/// How far a stated frequency may be off: people round.
const ROUNDED: f64 = 0.01;
/// Periods by which a record and what it states may part over its length.
const SLIP: f64 = 0.25;
/// Half-widths of the interval beyond which a difference is real.
const SURE: f64 = 3.0;

impl Run {
    /// The line that a sine's motion mostly is.
    fn line(&self) -> Option<&Sinusoid> {
        self.fast.moves.as_ref().filter(|line| line.share >= CLEAR)
    }

    /// Where a frequency shows in this run's log.
    fn shown(&self, frequency: f64) -> f64 {
        alias_of(frequency, self.fast.sample_rate)
    }

    /// Whether it moves at `frequency`, or at a harmonic of it.
    fn moves_at(&self, frequency: f64) -> bool {
        let near = |line: &Sinusoid| {
            let most = (ROUNDED * frequency).max(SURE * line.half_width).max(SLIP / self.fast.duration);
            [line.frequency, line.fundamental()].into_iter().any(|found| (found - self.shown(frequency)).abs() <= most)
        };
        self.line().is_some_and(near)
    }

    /// Whether a clear line of its motion is another than the stated.
    fn is_off(&self) -> bool {
        self.line().is_some() && !self.moves_at(self.spec.frequency)
    }

    fn file(&self) -> String {
        self.fast.account.file.display().to_string()
    }
}

impl Experiment {
    /// Refuses runs whose motion is another than they state.
    pub(super) fn check_frequencies(&self) -> Result<(), ExperimentError> {
        let off: Vec<&Run> = self.harmonics().map(|(_, run)| run).filter(|run| run.is_off()).collect();
        let Some(run) = off.first() else { return Ok(()) };
        let Some(line) = run.line() else { return Ok(()) };
        let (name, stated) = (&run.spec.name, plain(run.spec.frequency));
        let moves = frequency(line);
        let mut others = off.iter().skip(1);
        let swapped = others.find(|other| run.moves_at(other.spec.frequency) && other.moves_at(run.spec.frequency));
        let like = self.harmonics().map(|(_, other)| other).find(|other| run.moves_at(other.spec.frequency));
        let (message, told) = match (swapped, like) {
            (Some(other), _) => {
                let file = other.file();
                (
                    format!(
                        "moves at {moves}, as {} states, and {file} as {name} does: the two files are swapped",
                        other.spec.name
                    ),
                    2,
                )
            }
            (None, Some(other)) => {
                (format!("moves at {moves}, as {} states, not at the {stated} Hz of {name}", other.spec.name), 1)
            }
            (None, None) => (format!("moves at {moves}, not at the {stated} Hz that {name} states"), 1),
        };
        let folded = self.folded(run).map_or(String::new(), |text| format!(" ({text})"));
        let more = match off.len() - told {
            0 => String::new(),
            1 => "; one more run does not move as it states".to_owned(),
            more => format!("; {more} more runs do not move as they state"),
        };
        Err(ExperimentError::Refused { file: run.file(), message: message + &folded + &more })
    }

    /// What is to be said of the stated frequencies.
    pub(super) fn frequencies(&self) -> Vec<String> {
        let runs: Vec<&Run> = self.harmonics().map(|(_, run)| run).collect();
        let unclear: Vec<&str> =
            runs.iter().filter(|run| run.line().is_none()).map(|run| run.spec.name.as_str()).collect();
        let mut lines = Vec::new();
        if !unclear.is_empty() {
            lines.push(format!(
                "No one frequency stands out of the motion of {}: the stated one is not checked there.",
                unclear.join(", ")
            ));
        }
        for run in runs {
            let Some(line) = run.line() else { continue };
            if let Some(text) = self.folded(run) {
                lines.push(format!("{}: {text}; the motion fits that.", run.spec.name));
                continue;
            }
            let apart = (line.fundamental() - run.spec.frequency).abs();
            if line.harmonic == 1 && apart * run.fast.duration > SLIP && apart > SURE * line.half_width {
                lines.push(format!(
                    "{} states {} Hz and moves at {}; whole periods are those of the stated frequency.",
                    run.spec.name,
                    plain(run.spec.frequency),
                    frequency(line)
                ));
            }
        }
        lines
    }

    /// Where a stated frequency above half the sampling rate shows.
    fn folded(&self, run: &Run) -> Option<String> {
        let (stated, rate) = (run.spec.frequency, run.fast.sample_rate);
        (2.0 * stated > rate).then(|| {
            let shown = digits(run.shown(stated));
            format!("sampled at {} Hz, {} Hz shows as {shown} Hz", digits(rate), plain(stated))
        })
    }
}

/// As a person has set it.
fn plain(frequency: f64) -> String {
    format!("{}", (1e9 * frequency).round() / 1e9)
}

/// With its interval, to its last digit that counts.
fn frequency(line: &Sinusoid) -> String {
    let half_width = line.half_width.max(1e-4);
    let decimals = (1.0 - half_width.log10()).floor().clamp(0.0, 4.0) as usize;
    format!("{:.decimals$} ± {half_width:.decimals$} Hz", line.frequency)
}
