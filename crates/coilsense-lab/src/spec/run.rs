//! One `[[run]]` of an `experiment.toml`.
//!
//! Next door: the rest of the file (`experiment`).

use std::path::{Path, PathBuf};

use super::SpecError;
use super::section::Section;
use crate::quantity::Dimension;

/// One recorded run.
#[derive(Debug, Clone, PartialEq)]
pub struct RunSpec {
    /// What happens in it.
    pub kind: RunKind,
    /// What people call it.
    pub name: String,
    /// Of the sine \[Hz\]; zero where there is none.
    pub frequency: f64,
    /// Of the sine \[m\], where it is told.
    pub amplitude: Option<f64>,
    /// The log of load cell and position.
    pub fast: Option<PathBuf>,
    /// The log of the LCR meter.
    pub slow: Option<PathBuf>,
}

/// What happens in a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunKind {
    /// At rest at position after position.
    Calibration,
    /// At rest.
    Preload,
    /// A sine.
    Harmonic,
    /// Hits.
    Hit,
}

impl RunKind {
    const WORDS: [(&'static str, Self); 4] = [
        ("calibration", Self::Calibration),
        ("preload", Self::Preload),
        ("harmonic", Self::Harmonic),
        ("hit", Self::Hit),
    ];

    /// As the file calls it.
    pub fn word(self) -> &'static str {
        Self::WORDS.into_iter().find(|(_, kind)| *kind == self).map_or("", |(word, _)| word)
    }
}

impl RunSpec {
    pub(super) fn of(section: &Section<'_>, index: usize, beside: &Path) -> Result<Self, SpecError> {
        let word = section.word("kind", &RunKind::WORDS.map(|(word, _)| word))?;
        let kind = RunKind::WORDS.into_iter().find(|(known, _)| *known == word).map_or(RunKind::Hit, |(_, kind)| kind);
        section.only_of(word, &format!("a run of kind \"{word}\""))?;
        let file = |key| section.optional_text(key);
        let (fast, slow) = (file("fast")?, file("slow")?);
        match kind {
            RunKind::Preload | RunKind::Harmonic if fast.is_none() => {
                return Err(section.missing("fast", "the name of a log with F_o and F_x, u1 or u2"));
            }
            RunKind::Calibration if slow.is_none() => {
                return Err(section.missing("slow", "the name of a log with L, F_o, and u1 or u2"));
            }
            _ => {}
        }
        let frequency = match kind {
            RunKind::Harmonic => section.positive("frequency", Dimension::Frequency)?,
            _ => 0.0,
        };
        let amplitude = section.above_zero("amplitude", Dimension::Length)?;
        let shown = [&fast, &slow].into_iter().flatten().next().map(|name| run_name(name));
        let name = section.optional_text("name")?.or(shown).unwrap_or_else(|| format!("run {}", index + 1));
        let path = |name: Option<String>| name.map(|name| beside.join(name));
        Ok(Self { kind, name, frequency, amplitude, fast: path(fast), slow: path(slow) })
    }
}

/// What two files of a run have in common: `harmonic-12` of `harmonic-12-fast.csv`.
fn run_name(file: &str) -> String {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let stem = stem.strip_suffix("-fast").or_else(|| stem.strip_suffix("-slow")).unwrap_or(stem);
    if stem.is_empty() { name.to_owned() } else { stem.to_owned() }
}
