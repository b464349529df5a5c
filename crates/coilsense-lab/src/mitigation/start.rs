//! How each kind of settings is started and run on a study's samples.
//!
//! Next door: the candidates that hold them (`candidate`).

use coilsense_rt::{Bank, Boxcar, Cascade, Comb, DelayLineObserver, DoubleBoxcar, Measured, ModalKalman, Window};

use super::export::Settings;

/// A running candidate: takes what is measured, gives a force \[N\].
pub(super) type Running<'a> = Box<dyn FnMut(&Measured<f64>) -> f64 + 'a>;

/// What can be started on a spring at rest on which something is measured.
pub(super) trait Start: Send + Sync {
    /// A running copy.
    fn start(&self, at_rest: &Measured<f64>) -> Running<'_>;
    /// What can be exported of it.
    fn settings(&self) -> Option<&dyn Settings>;
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
