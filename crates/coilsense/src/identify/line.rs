//! A line of a record: its numbers, and what it is.
//!
//! Next door: how lines are found (`lines`, `refine`) and named (`naming`).

use super::ringing::Part;
use super::value::Estimate;

/// What a line is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Meaning {
    /// Mode j of the spring on its mount.
    Mode(usize),
    /// A mode above half the sampling rate, folded.
    Alias {
        /// j.
        mode: usize,
        /// Where it is in truth \[Hz\].
        frequency: f64,
    },
    /// A multiple of the mains' frequency \[Hz\], steady.
    Mains {
        /// 50 or 60 \[Hz\].
        mains: f64,
        /// Which multiple.
        multiple: usize,
    },
    /// The force only follows the recorded motion of the ends, as it does in a spring without mass.
    Follows,
    /// The coil's torsion: no axial mode, but heard in the axial force.
    Torsional {
        /// The axial mode beside which it lies; none for quarter waves, where an end may turn.
        mode: Option<usize>,
    },
    /// One of a close pair, as sideways motion of a coil has.
    Lateral,
    /// None of these.
    Unknown,
}

/// One line.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Undamped frequency \[Hz\].
    pub frequency: Estimate,
    /// ζ \[1\] by the ring-down fit; none where there is no ring-down.
    pub ratio: Option<Estimate>,
    /// Whether it decays.
    pub decays: bool,
    /// Largest amplitude right after a hit \[N\], or that of a steady line.
    pub amplitude: f64,
    /// In which part of the forces it rings; none where in both alike.
    pub part: Option<Part>,
    /// How many hits its fit took.
    pub hits: usize,
    /// Power over that of the noise.
    pub strength: f64,
    /// What it is.
    pub meaning: Meaning,
    /// Why, in words.
    pub reason: String,
    /// ζ by the width at half power, or why the record cannot carry it.
    pub half_power: Result<Estimate, String>,
}

impl Line {
    /// j, where the line is a mode that is not folded.
    pub fn mode(&self) -> Option<usize> {
        match self.meaning {
            Meaning::Mode(mode) => Some(mode),
            _ => None,
        }
    }

    /// Width at half its power \[Hz\]; zero where it is not known.
    pub(super) fn width(&self) -> f64 {
        self.ratio.map_or(0.0, |ratio| 2.0 * ratio.value.abs() * self.frequency.value)
    }
}
