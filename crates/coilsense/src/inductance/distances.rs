//! Which distances of turns occur over some samples.
//!
//! Next door: the samples (`turn_block`), polynomials that are good for such distances (`lag_polynomials`).

use super::turn_block::TurnBlock;

/// Room left about the distances at hand, as a share of their spread, so that the next samples mostly need no new polynomials.
const MARGIN: f64 = 0.06;

/// Distances that occur.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Distances {
    /// Of neighbours \[m\].
    pub(super) spacings: [f64; 2],
    /// Of uniform neighbours \[m\].
    pub(super) pitches: [f64; 2],
    /// The largest change of any distance from that of uniform turns \[m\].
    pub(super) reach: f64,
}

impl Distances {
    /// Of a block.
    pub(super) fn of(block: &TurnBlock) -> Self {
        Self { spacings: block.spacing_range(), pitches: block.pitch_range(), reach: block.reach() }
    }

    /// Whether all of the others are within.
    pub(super) fn holds(&self, other: &Self) -> bool {
        let within = |ours: [f64; 2], theirs: [f64; 2]| ours[0] <= theirs[0] && theirs[1] <= ours[1];
        within(self.spacings, other.spacings) && within(self.pitches, other.pitches) && other.reach <= self.reach
    }

    /// Both together.
    pub(super) fn union(&self, other: &Self) -> Self {
        let both = |ours: [f64; 2], theirs: [f64; 2]| [ours[0].min(theirs[0]), ours[1].max(theirs[1])];
        Self {
            spacings: both(self.spacings, other.spacings),
            pitches: both(self.pitches, other.pitches),
            reach: self.reach.max(other.reach),
        }
    }

    /// Spread of the neighbours' distances relative to their middle.
    pub(super) fn width(&self) -> f64 {
        2.0 * (self.spacings[1] - self.spacings[0]) / (self.spacings[1] + self.spacings[0])
    }

    /// A little wider.
    pub(super) fn widened(&self) -> Self {
        let wider = |[least, largest]: [f64; 2]| {
            let room = MARGIN * (largest - least);
            [least - room, largest + room]
        };
        Self { spacings: wider(self.spacings), pitches: wider(self.pitches), reach: self.reach * (1.0 + MARGIN) }
    }
}
