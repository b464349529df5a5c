//! What inputs are made of: jumps, and sines that begin at a time.
//!
//! Next door: the inputs (`input`, `sampled`).

/// A jump of an input and of its rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Kick {
    pub time: f64,
    pub displacement: f64,
    pub velocity: f64,
}

/// A sine that begins at a time: amplitude · sin(angular (t − since) + phase) from there on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sine {
    pub amplitude: f64,
    pub angular: f64,
    pub phase: f64,
    pub since: f64,
}

impl Sine {
    pub(super) fn velocity(&self, time: f64) -> f64 {
        let angle = self.angular * (time - self.since) + self.phase;
        if time < self.since { 0.0 } else { self.amplitude * self.angular * angle.cos() }
    }

    pub(super) fn displacement(&self, time: f64) -> f64 {
        let angle = self.angular * (time - self.since) + self.phase;
        if time < self.since { 0.0 } else { self.amplitude * angle.sin() }
    }
}
