//! One way of doing something about it: where it comes from, and what it is to be.
//!
//! Next door: how it runs (`start`), which there are (`candidates`), how they are judged (`judge`).

use coilsense_rt::Measured;

use super::export::Settings;
use super::start::Start;

/// A candidate that cannot be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftOut {
    /// In words.
    pub name: String,
    /// Why.
    pub reason: String,
}

/// What a candidate's force is to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Truth {
    /// k (u2 − u1 − l0), the force of a spring without mass: filters of F_i.
    Static,
    /// F_o, the force at end 2: estimators.
    Output,
}

impl Truth {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Static => "k·Δl",
            Self::Output => "F_o",
        }
    }
}

/// Where a candidate comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// Nothing done.
    Raw,
    /// What one tries first, from a textbook.
    Textbook,
    /// Designed for the noise, the shocks and the tolerances at hand.
    Fitted,
}

impl Origin {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Raw => "raw",
            Self::Textbook => "textbook",
            Self::Fitted => "fitted",
        }
    }
}

/// A way of doing something about ringing.
pub struct Candidate {
    /// In words.
    pub name: String,
    /// Where it comes from.
    pub origin: Origin,
    /// What its force is to be.
    pub truth: Truth,
    pub(super) start: Box<dyn Start>,
}

impl Candidate {
    pub(super) fn new(name: impl Into<String>, origin: Origin, truth: Truth, start: impl Start + 'static) -> Self {
        Self { name: name.into(), origin, truth, start: Box::new(start) }
    }

    /// What it makes of samples one after the other \[N\], started on a spring that rests as it is at the first of them.
    pub fn run(&self, measured: &[Measured<f64>]) -> Vec<f64> {
        let Some(first) = measured.first() else { return Vec::new() };
        let mut running = self.start.start(first);
        measured.iter().map(running.as_mut()).collect()
    }

    /// What a controller takes of it; nothing for what is measured as it is.
    pub fn settings(&self) -> Option<&dyn Settings> {
        self.start.settings()
    }
}
