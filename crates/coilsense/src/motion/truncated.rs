//! A motion of its first modes only, with what the others do at rest kept.
//!
//! Next door: the full motion (the parent), the forces (`forces`).

use super::Motion;
use super::closed::{Closed, ModalState};
use super::oscillator::Oscillator;
use crate::error::{Error, check};
use crate::excitation::{EndInput, Kick, Sine};
use crate::modes::{LeftOut, ModalModel};

/// What is left of the modes that a truncated motion leaves out.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Remainder {
    /// Force at each end per acceleration of each input, `[end][input]`: a mode far above its drive follows as `q = −c ẅ/ω²`.
    pub per_acceleration: [[f64; 2]; 2],
    /// The next term of the same, per fourth derivative of each input: kept of a wire, whose modes never end.
    pub per_snap: [[f64; 2]; 2],
    /// Bound on what is still missing of F_i and F_o \[N\].
    pub bound: [f64; 2],
}

impl Remainder {
    /// Of a motion with all its modes: nothing.
    pub(super) const NONE: Self = Self { per_acceleration: [[0.0; 2]; 2], per_snap: [[0.0; 2]; 2], bound: [0.0; 2] };

    /// Of a motion with all the modes of a model.
    pub(super) fn of(modes: &ModalModel) -> Self {
        let mut remainder = Self::NONE;
        remainder.set(modes.left_out());
        remainder
    }

    fn set(&mut self, left_out: Option<LeftOut>) {
        if let Some(LeftOut { per_acceleration, per_snap }) = left_out {
            (self.per_acceleration, self.per_snap) = (per_acceleration, per_snap);
        }
    }
}

impl Motion {
    /// The same motion with its first `modes` modes only. Those left out keep their static answer to curved inputs in the end forces
    /// (windings hold the kept modes alone); what they ring is missing, by at most [`Self::truncation_bound`].
    ///
    /// F += −2Nk Σ_{j>n} a_j (c1_j ẅ1 + c2_j ẅ2)/ω_j²; of a helix ([`crate::helix::Surge`]) the next term, −w⁗/ω_j⁴, too
    ///
    /// Source:   mode-acceleration method; any text on structural dynamics.
    /// Valid:    inputs slow against the first mode that is left out; jumps and impacts excite all modes alike.
    /// Accuracy: within [`Self::truncation_bound`].
    ///
    /// # Errors
    /// [`Error::Value`] for no modes, or more than there are.
    ///
    /// ```
    /// # use coilsense::{EndInput, Excitation, Motion, Start};
    /// # let spring = coilsense::paper::s_t();
    /// let input = EndInput::harmonic(1e-3, 10.0, 0.0);
    /// let motion = Motion::new(&spring, &Excitation::new(0.23, input, EndInput::Held, Start::Massless)?)?;
    /// let three = motion.truncated(3)?;
    /// let off = three.end_forces(&[0.37])?.input[0] - motion.end_forces(&[0.37])?.input[0];
    /// assert!(off.abs() <= three.truncation_bound()[0] && three.truncation_bound()[0] < 0.1);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn truncated(&self, modes: usize) -> Result<Self, Error> {
        let all = self.modes.count();
        check((1..=all).contains(&modes), "modes", modes as f64, "", format!("from 1 to {all}"))?;
        let mut motion = self.clone();
        motion.modes = self.modes.first(modes);
        motion.ratios.truncate(modes);
        motion.start.coordinates.truncate(modes);
        motion.start.rates.truncate(modes);
        motion.closed = Closed::new(&motion.modes, &motion.ratios, motion.start.clone(), motion.inputs());
        for mode in modes..all {
            self.leave_out(mode, &mut motion.remainder);
        }
        motion.remainder.set(motion.modes.left_out());
        Ok(motion)
    }

    /// How far F_i and F_o of a truncated motion can be from those of all modes \[N\]; zero where none is left out. Modes that the model
    /// does not have, as those of a helix beyond [`crate::helix::Surge::reach`], are not in it.
    ///
    /// Σ_{j>n} 2Nk |a_j| (1 + βω_j) √(q² + (q̇/ω_j)²): a mode's ringing never exceeds the sum of what start, jumps and sines give it;
    /// of a step |a_j c_j Δu| (1 + βω_j √(1 + 4ζ_j²)), as it leaves `q = −c_j Δu ġ`, g the answer to a unit impulse, ġ² + (ω_j g)² ≤ 1
    ///
    /// Source:   the energy of a mode without input does not grow.
    /// Valid:    any damping; for a chirp it grows with its duration, and at a resonance of a mode left out without damping it is infinite.
    /// Accuracy: a bound; several times the error where modes do not peak together.
    pub fn truncation_bound(&self) -> [f64; 2] {
        self.remainder.bound
    }

    /// Adds what is left of one mode.
    fn leave_out(&self, mode: usize, remainder: &mut Remainder) {
        let scale = self.force_scale();
        let natural = self.modes.frequencies()[mode];
        let dashpot = self.mount.damping().dashpot_time() * natural;
        let oscillator = Oscillator { natural, ratio: self.ratios[mode] };
        let ModalState { coordinates, rates } = &self.start;
        let mut ringing = (1.0 + dashpot) * coordinates[mode].hypot(rates[mode] / natural);
        let terms = if self.modes.left_out().is_some() { 2 } else { 1 };
        for (end, input) in self.inputs().into_iter().enumerate() {
            let rings = ringing_under(input, &oscillator, dashpot, terms);
            ringing += self.modes.participations()[end][mode].abs() * rings;
        }
        for (end, weights) in self.modes.weights().into_iter().enumerate() {
            for (input, participations) in self.modes.participations().into_iter().enumerate() {
                let follows = scale * weights[mode] * participations[mode] / (natural * natural);
                remainder.per_acceleration[end][input] -= follows;
            }
            remainder.bound[end] += scale * weights[mode].abs() * ringing;
        }
    }
}

/// Bound on how far q + βq̇ of a mode goes beyond its static answer under an input \[m\], at a participation of one.
///
/// - `dashpot`: βω; `terms`: of the answer in powers of (Ω/ω)², that are kept, 1 or 2
fn ringing_under(input: &EndInput, oscillator: &Oscillator, dashpot: f64, terms: u8) -> f64 {
    let natural = oscillator.natural;
    let (both, after_step) = (1.0 + dashpot, 1.0 + dashpot * f64::hypot(1.0, 2.0 * oscillator.ratio));
    let of_kick = |kick: &Kick| after_step * kick.displacement.abs() + both * kick.velocity.abs() / natural;
    let jumps: f64 = input.kicks().iter().map(of_kick).sum();
    let of_sine = |sine: Sine| {
        let acceleration = sine.amplitude.abs() * sine.angular * sine.angular;
        let second = if terms == 2 { (sine.angular / natural).powi(2) } else { 0.0 };
        let (gain, follows) = (oscillator.steady_gain(sine.angular), (1.0 + second) / (natural * natural));
        // Beyond the static answer once steady, and the free motion that makes it begin from rest; its dashpot is left out whole.
        let rings = (gain - follows).norm() + gain.norm() * (1.0 + sine.angular / natural) + follows;
        // At a resonance without damping the gain is no number: the ringing grows without bound.
        if rings.is_finite() { acceleration * rings } else { f64::INFINITY }
    };
    // A sine that ends frees what it drove: as much again.
    let times = |sine: &Sine| if sine.until.is_finite() { 2.0 } else { 1.0 };
    let sines: f64 = input.sines().map(|sine| times(&sine) * of_sine(sine)).sum();
    let chirp = input.chirp_impulse() / natural;
    jumps + both * (sines + chirp)
}
