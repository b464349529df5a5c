//! The whole wire between its ends at one frequency, put together from equal pieces by doubling.
//!
//! Next door: one piece (`segment`), what is read from the whole (`modes`, `mode`, `response`).

use super::block::{Block, Number, Square, eliminate};
use super::ends::{Arm, Ends, release};
use super::segment::Segment;
use super::state::Helix;

/// The wire's pieces and its ends.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    pub segment: Segment,
    pub arms: [Arm; 2],
    pub ends: Ends,
}

impl Chain {
    /// So many pieces per winding, and more where λ asks for them; `None` where it asks for too many.
    pub fn new(helix: &Helix, ends: &Ends, per_winding: f64, lambda: f64) -> Option<Self> {
        let force = helix.scaled.force;
        let arms = [
            Arm::new(helix, 0.0, -force, ends.end1.direction()),
            Arm::new(helix, helix.swept(), force, ends.end2.direction()),
        ];
        Some(Self { segment: Segment::new(helix, per_winding, lambda)?, arms, ends: *ends })
    }

    /// Both parts, five and three eighths of the wire. Were they halves, every second mode would have a node where they meet.
    pub fn parts<T: Number>(&self, lambda: T) -> [Block<T>; 2] {
        let mut eighth = self.segment.at(lambda);
        for _ in 3..self.segment.doublings() {
            eighth = eighth.then(&eighth);
        }
        let quarter = eighth.then(&eighth);
        [quarter.then(&quarter).then(&eighth), quarter.then(&eighth)]
    }

    /// The stiffness at the section where both parts meet, and how many modes lie below λ with that section held.
    pub fn section<T: Number>(&self, lambda: T) -> (usize, Square<T, 6>) {
        let [mut one, mut two] = self.parts(lambda);
        let mut below = one.below + two.below;
        for (part, arm, holding, first) in
            [(&mut one, &self.arms[0], &self.ends.end1, 0), (&mut two, &self.arms[1], &self.ends.end2, 6)]
        {
            if !holding.is_clamped() {
                arm.apply(&mut part.stiffness, first);
                below += release(&mut part.stiffness, holding, first);
            }
        }
        let sum = std::array::from_fn(|i| std::array::from_fn(|j| one.stiffness[6 + i][6 + j] + two.stiffness[i][j]));
        (below, sum)
    }

    /// How many modes lie below λ.
    pub fn count(&self, lambda: f64) -> usize {
        let (held, mut middle) = self.section(lambda);
        held + eliminate(&mut middle, &[0, 1, 2, 3, 4, 5])
    }

    /// The stiffness between both points on the axis, nothing released.
    pub fn between_ends<T: Number>(&self, lambda: T) -> Square<T, 12> {
        let [one, two] = self.parts(lambda);
        let mut stiffness = one.then(&two).stiffness;
        self.arms[0].apply(&mut stiffness, 0);
        self.arms[1].apply(&mut stiffness, 6);
        stiffness
    }
}
