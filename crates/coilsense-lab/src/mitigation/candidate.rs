//! One way of doing something about it: its settings, and how it runs.
//!
//! Next door: which there are (`candidates`), how they are judged (`judge`).

use coilsense_rt::{Bank, Boxcar, Cascade, Comb, DelayLineObserver, DoubleBoxcar, Measured, ModalKalman, Window};

use super::export::Settings;

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
    FirstTry,
    /// Designed for the noise, the shocks and the tolerances at hand.
    Fitted,
}

impl Origin {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Raw => "raw",
            Self::FirstTry => "first try",
            Self::Fitted => "fitted",
        }
    }
}

/// A running candidate: takes what is measured, gives a force \[N\].
pub(super) type Running<'a> = Box<dyn FnMut(&Measured<f64>) -> f64 + 'a>;

/// What can be started on a spring at rest on which something is measured.
pub(super) trait Start: Send + Sync {
    /// A running copy.
    fn start(&self, at_rest: &Measured<f64>) -> Running<'_>;
    /// What can be exported of it.
    fn settings(&self) -> Option<&dyn Settings>;
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

    /// What a controller takes of it; nothing for what is measured as it is.
    pub fn settings(&self) -> Option<&dyn Settings> {
        self.start.settings()
    }
}

/// F_i as it is.
pub(super) struct Plain;

impl Start for Plain {
    fn start(&self, _: &Measured<f64>) -> Running<'_> {
        Box::new(|measured| measured.force)
    }
    fn settings(&self) -> Option<&dyn Settings> {
        None
    }
}

/// k (u2 − u1 − l0) of the nominal spring.
pub(super) struct Deflection(pub coilsense::Spring);

impl Start for Deflection {
    fn start(&self, _: &Measured<f64>) -> Running<'_> {
        Box::new(|measured| self.0.static_force(measured.ends[1] - measured.ends[0]))
    }
    fn settings(&self) -> Option<&dyn Settings> {
        None
    }
}

/// Samples that rings hold here; longer ones are left out of a study.
pub(super) const RING: usize = 2048;

impl<const SECTIONS: usize> Start for Cascade<f64, SECTIONS> {
    fn start(&self, at_rest: &Measured<f64>) -> Running<'_> {
        let mut state = self.settled(at_rest.force);
        Box::new(move |measured| self.step(&mut state, measured.force))
    }
    fn settings(&self) -> Option<&dyn Settings> {
        Some(self)
    }
}

impl Start for Boxcar<f64> {
    fn start(&self, at_rest: &Measured<f64>) -> Running<'_> {
        let mut state = self.settled::<RING>(at_rest.force);
        Box::new(move |measured| self.step(&mut state, measured.force))
    }
    fn settings(&self) -> Option<&dyn Settings> {
        Some(self)
    }
}

impl Start for DoubleBoxcar<f64> {
    fn start(&self, at_rest: &Measured<f64>) -> Running<'_> {
        let mut state = self.settled::<RING>(at_rest.force);
        Box::new(move |measured| self.step(&mut state, measured.force))
    }
    fn settings(&self) -> Option<&dyn Settings> {
        Some(self)
    }
}

impl Start for Comb<f64> {
    fn start(&self, at_rest: &Measured<f64>) -> Running<'_> {
        let mut state = self.settled::<RING>(at_rest.force);
        Box::new(move |measured| self.step(&mut state, measured.force))
    }
    fn settings(&self) -> Option<&dyn Settings> {
        Some(self)
    }
}

impl<const TAPS: usize> Start for Window<f64, TAPS> {
    fn start(&self, at_rest: &Measured<f64>) -> Running<'_> {
        let mut state = self.settled(at_rest.force);
        Box::new(move |measured| self.step(&mut state, measured.force))
    }
    fn settings(&self) -> Option<&dyn Settings> {
        Some(self)
    }
}

impl Start for DelayLineObserver<f64> {
    fn start(&self, at_rest: &Measured<f64>) -> Running<'_> {
        let mut state = self.settled::<RING>(at_rest);
        Box::new(move |measured| self.step(&mut state, measured))
    }
    fn settings(&self) -> Option<&dyn Settings> {
        Some(self)
    }
}

impl<const MODES: usize> Start for ModalKalman<f64, MODES> {
    fn start(&self, at_rest: &Measured<f64>) -> Running<'_> {
        let mut state = self.settled(at_rest);
        Box::new(move |measured| self.step(&mut state, measured).output)
    }
    fn settings(&self) -> Option<&dyn Settings> {
        Some(self)
    }
}

impl<const MODES: usize, const MEMBERS: usize> Start for Bank<f64, MODES, MEMBERS> {
    fn start(&self, at_rest: &Measured<f64>) -> Running<'_> {
        let mut state = self.settled(at_rest);
        Box::new(move |measured| self.step(&mut state, measured).output)
    }
    fn settings(&self) -> Option<&dyn Settings> {
        Some(self)
    }
}
