//! What inputs are made of: jumps, and sines that begin at a time and may end.
//!
//! Next door: the inputs (`input`, `sampled`).

/// A jump of an input and of its rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Kick {
    pub time: f64,
    pub displacement: f64,
    pub velocity: f64,
}

/// A sine that begins at a time and may end: amplitude · sin(angular (t − since) + phase) for since ≤ t < until.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sine {
    pub amplitude: f64,
    pub angular: f64,
    pub phase: f64,
    pub since: f64,
    /// Infinite for a sine that goes on.
    pub until: f64,
}

impl Sine {
    /// Whether it is under way at a time.
    pub(crate) fn acts_at(&self, time: f64) -> bool {
        (self.since..self.until).contains(&time)
    }

    pub(super) fn velocity(&self, time: f64) -> f64 {
        let angle = self.angular * (time - self.since) + self.phase;
        if self.acts_at(time) { self.amplitude * self.angular * angle.cos() } else { 0.0 }
    }

    pub(super) fn displacement(&self, time: f64) -> f64 {
        let angle = self.angular * (time - self.since) + self.phase;
        if self.acts_at(time) { self.amplitude * angle.sin() } else { 0.0 }
    }
}
