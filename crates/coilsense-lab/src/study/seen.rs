//! What of a run a sensor sees, and what counts as true beside it.
//!
//! Next door: the run (`simulation`), how a sensor is judged (`crate::analysis`).

use coilsense::Signals;
use coilsense::sensors::ReadoutParameters;

use crate::spec::{Goal, SensorSpec};

/// The signals of a run as sensors see them, as far as that is something else than the forces at the ends.
#[derive(Debug, Clone, Default)]
pub struct Seen {
    /// By load cells out of line with a helix.
    pub(super) by_cells: Option<Signals>,
    /// With what seats got in an instant, spread over a sample each.
    pub(super) with_blows: Option<Signals>,
}

impl Seen {
    /// What a sensor sees. A blow has no limit at all frequencies: it is there for those that let only some of them through, by themselves or by
    /// the bandwidth of the goal.
    pub fn by<'a>(&'a self, signals: &'a Signals, sensor: &SensorSpec, goal: &Goal) -> &'a Signals {
        let is_slow = goal.bandwidth.is_some() || has_limit(&sensor.readout);
        let struck = self.with_blows.as_ref().filter(|_| is_slow);
        self.by_cells.as_ref().or(struck).unwrap_or(signals)
    }

    /// What counts as true: with the blows where only a band counts.
    pub fn truth<'a>(&'a self, signals: &'a Signals, goal: &Goal) -> &'a Signals {
        self.with_blows.as_ref().filter(|_| goal.bandwidth.is_some()).unwrap_or(signals)
    }
}

fn has_limit(readout: &ReadoutParameters) -> bool {
    readout.bandwidth.is_some() || readout.averaging.is_some()
}
