//! An input that changes: an end may jump, or its speed.
//!
//! Next door: the run (`run`), what happens by itself (`events`).

use super::book::energy;
use super::course::GivenUp;
use super::meet::go_along;
use super::polynomial::value;
use super::run::Run;

/// Two pieces of a path meet to rounding: what is this close \[m, m/s\] is the same.
const PIECES_APART: f64 = 1e-10;

impl Run<'_> {
    /// A follower on its cam goes with it from piece to piece, which rounding parts.
    fn stand_on_cam(&mut self) {
        let Some(cam) = self.system.chain.cam().filter(|cam| self.now.closed[*cam]) else { return };
        if self.gap(cam).abs() <= PIECES_APART {
            self.now.places[1] = self.now.places[0];
        }
        if (self.now.speeds[1] - self.now.speeds[0]).abs() <= PIECES_APART {
            self.now.speeds[1] = self.now.speeds[0];
        }
    }

    /// An input changes: an end may jump, or its speed.
    pub(super) fn pass_knot(&mut self) -> Result<(), GivenUp> {
        let chain = self.system.chain;
        let last = chain.lumps() + 1;
        let before = [self.now.places[0], self.now.places[last]];
        let speeds = [self.now.speeds[0], self.now.speeds[last]];
        let force = |run: &Self, time: f64| run.system.drives[1].series(time, 1.0)[0];
        let old_force = if chain.is_open() { value(&self.series.force, 1.0) } else { 0.0 };
        let energy_before = energy(self.system, &self.now);
        self.drive_ends();
        self.stand_on_cam();
        let faster = (self.now.speeds[0] - speeds[0]).abs().max((self.now.speeds[last] - speeds[1]).abs());
        if faster <= PIECES_APART && self.system.elastic.is_none() {
            // What lies on an end goes on with it: its pieces meet to rounding, which would let go what it holds.
            go_along(chain, &mut self.now);
        }
        let cam_jumps = self.now.places[0] - before[0];
        // A follower stays where it is when its cam jumps.
        let first = if chain.base() > 0 { 0.0 } else { cam_jumps };
        let second = if chain.is_open() {
            first + (force(self, self.now.time) - old_force) / chain.stiffness()
        } else {
            self.now.places[last] - before[1]
        };
        let small = 1e-15 * (before[0].abs() + before[1].abs() + 1e-3);
        let jumps = cam_jumps.abs() > small || second.abs() > small;
        if jumps {
            for number in 0..self.rest.len() {
                if self.now.closed[number] && self.gap(number) > PIECES_APART {
                    self.now.closed[number] = false;
                    self.book.parted(number, self.now.time);
                }
            }
        }
        if jumps && !self.system.damper.is_none() {
            let mut relative: Vec<f64> =
                chain.shares().iter().map(|share| -(first + share * (second - first))).collect();
            (relative[0], relative[last]) = (0.0, 0.0);
            relative[chain.base()] = 0.0;
            let mut impulses = vec![0.0; chain.lumps()];
            self.system.brake(self.now.attached, &relative, &mut impulses);
            for ((speed, impulse), inverse) in
                self.now.speeds[1..].iter_mut().zip(impulses).zip(&chain.inverse_masses()[1..])
            {
                *speed += impulse * inverse;
            }
        }
        self.book.put_in(energy(self.system, &self.now) - energy_before);
        let hard = self.system.elastic.is_none();
        let overlaps = (0..self.rest.len()).any(|number| self.gap(number) < -1e-9);
        if hard && overlaps {
            return Err(GivenUp::Solid);
        }
        let meets = |run: &mut Self, number: usize| {
            let is_open = !run.now.closed[number] && run.gap(number) <= 0.0;
            is_open && (jumps && !hard || !run.pressed[number] && run.closes(number))
        };
        let meeting: Vec<usize> = (0..self.rest.len()).filter(|&number| meets(self, number)).collect();
        let held = hard && self.now.closed.iter().any(|closed| *closed);
        if held || !meeting.is_empty() { self.meets(&meeting, true) } else { Ok(()) }
    }
}
