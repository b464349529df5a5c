//! The forces at both ends over time.
//!
//! Next door: the modal coordinates behind them (`closed`, `march`), many times at once (`phasor_sum`).

use num_complex::Complex64;

use super::closed::{Closed, Drive, ModalState};
use super::panel::CountOn;
use super::phasor_sum::{Function, Grid, Target, Term, add};
use super::stride::Sums;
use super::truncated::Remainder;
use super::{Motion, check_times, in_order, step_of};
use crate::error::Error;
use crate::excitation::{EndInput, Sine};
use crate::modes::end_sign;
use crate::mount::FarEnd;
use crate::simd::dispatch;

/// The forces at both ends, each of shape `samples`, \[N\], tension positive.
#[derive(Debug, Clone, PartialEq)]
pub struct EndForces {
    /// F_i, at end 1.
    pub input: Vec<f64>,
    /// F_o, at end 2.
    pub output: Vec<f64>,
}

/// From so many equidistant times on they are processed together.
const FEWEST_TOGETHER: usize = 32;

const I: Complex64 = Complex64::new(0.0, 1.0);

impl Motion {
    /// Forces at both ends \[N\], tension positive.
    ///
    /// F_i = F_s + 2Nk Σ_j a_j (q_j + β q̇_j), F_o = F_s + 2Nk Σ_j b_j (q_j + β q̇_j), F_s that of a spring without mass,
    /// a_j = φ_j(1), b_j = ψ_j − φ_j(N), β the time of stiffness-proportional damping
    ///
    /// - `times`: t \[s\], shape `samples`, in any order, none below zero; equidistant ones in order are fastest
    ///
    /// Source:   `[Weijde2017]` eq. 7, modal form.
    /// Valid:    as [`Motion`].
    /// Accuracy: 1e-12 of the peak, as [`Motion`].
    ///
    /// # Errors
    /// [`Error::Count`] for no times; [`Error::Value`] for the first that is not finite or below zero.
    pub fn end_forces(&self, times: &[f64]) -> Result<EndForces, Error> {
        if let Some(closed) = self.closed.as_ref().filter(|_| is_equidistant(times)) {
            return Ok(self.together(closed, self.inputs(), times));
        }
        if self.closed.is_none()
            && let Some(forces) = self.under_recordings(times)
        {
            return Ok(forces);
        }
        check_times(times)?;
        let mut forces = EndForces::zero(times.len());
        match &self.closed {
            Some(closed) => {
                let mut state = ModalState::zero(self.modes.count());
                for (sample, &time) in times.iter().enumerate() {
                    closed.state_into(time, &mut state);
                    self.set(&mut forces, sample, self.sums(&state.coordinates, &state.rates));
                }
            }
            None => {
                let mut march = self.march(step_of(times));
                for sample in in_order(times) {
                    march.advance_to(times[sample]);
                    self.set(&mut forces, sample, march.sums());
                }
            }
        }
        let [first, second] = self.inputs().map(|input| input.displacements(times));
        for (sample, inputs) in first.into_iter().zip(second).enumerate() {
            let [input, output] = self.remaining_forces(self.inputs(), times[sample]);
            let static_force = self.static_force_of(inputs.into());
            forces.input[sample] += static_force + input;
            forces.output[sample] += static_force + output;
        }
        Ok(forces)
    }

    /// Both forces less those of the kept modes \[N\], under all or some of the inputs: of a spring without mass, and of what modes left out
    /// do at rest.
    pub(super) fn slow_forces_under(&self, inputs: [&EndInput; 2], time: f64) -> [f64; 2] {
        let static_force = self.static_force_of(inputs.map(|input| input.displacement(time)));
        self.remaining_forces(inputs, time).map(|force| static_force + force)
    }

    /// What modes left out do at rest \[N\].
    fn remaining_forces(&self, inputs: [&EndInput; 2], time: f64) -> [f64; 2] {
        if self.remainder == Remainder::NONE {
            return [0.0; 2];
        }
        let Remainder { per_acceleration, per_snap, .. } = &self.remainder;
        let (accelerations, snaps) =
            (inputs.map(|input| input.acceleration(time)), inputs.map(|input| input.snap(time)));
        let of = |per: &[f64; 2], values: [f64; 2]| per[0] * values[0] + per[1] * values[1];
        [0, 1].map(|end| of(&per_acceleration[end], accelerations) + of(&per_snap[end], snaps))
    }

    /// F_s \[N\] under inputs counted from their means.
    pub(super) fn static_force_of(&self, [first, second]: [f64; 2]) -> f64 {
        let [first, second] = self.line_of([first, second]);
        self.spring.open_force(second - first)
    }

    /// What a unit of an input adds to F_s.
    pub(super) fn static_force_per(&self, end: usize) -> f64 {
        match (end, self.mount.far_end()) {
            (0, FarEnd::Position) => -self.spring.stiffness(),
            (0, _) => 0.0,
            (_, FarEnd::Position) => self.spring.stiffness(),
            _ => 1.0,
        }
    }

    /// Amplitude of the force at an end under a sine, less the kept modes \[N\].
    pub(super) fn straight_gain(&self, drive: &Drive, end: usize) -> f64 {
        let Sine { amplitude, angular, .. } = drive.sine;
        let Remainder { per_acceleration, per_snap, .. } = &self.remainder;
        let remainder = per_acceleration[end][drive.end] - per_snap[end][drive.end] * angular * angular;
        amplitude * (self.static_force_per(drive.end) - remainder * angular * angular)
    }

    fn sums(&self, coordinates: &[f64], rates: &[f64]) -> Sums {
        let dot = |values: &[f64], weights: &[f64]| values.iter().zip(weights).map(|(v, w)| v * w).sum();
        let [input, output] = self.modes.weights();
        Sums {
            coordinates: [dot(coordinates, input), dot(coordinates, output)],
            rates: [dot(rates, input), dot(rates, output)],
        }
    }

    /// Forces less the static one \[N\], from sums over the modes.
    pub(super) fn surge_forces(&self, sums: Sums) -> [f64; 2] {
        let (scale, dashpot) = (self.force_scale(), self.mount.damping().dashpot_time());
        [0, 1].map(|end| scale * (sums.coordinates[end] + dashpot * sums.rates[end]))
    }

    fn set(&self, forces: &mut EndForces, sample: usize, sums: Sums) {
        [forces.input[sample], forces.output[sample]] = self.surge_forces(sums);
    }

    /// Force \[N\] that a mode's weight stands for, by its coordinate; of the chain 2Nk, the stiffness of an end segment \[N/m\].
    pub(super) fn force_scale(&self) -> f64 {
        self.modes.segment()
    }

    /// All equidistant times together, jump by jump, under inputs that `closed` is the solution of.
    pub(super) fn together(&self, closed: &Closed, inputs: [&EndInput; 2], times: &[f64]) -> EndForces {
        let constant = self.straight_part(inputs, 0.0).constant;
        let mut forces = EndForces { input: vec![constant; times.len()], output: vec![constant; times.len()] };
        for (index, samples) in closed.stretches(times) {
            let segment = &closed.segments[index];
            let grid =
                Grid { first: times[samples.start] - segment.from, step: step_of(times), samples: samples.len() };
            let [input, output] = [&mut forces.input[samples.clone()], &mut forces.output[samples]];
            let straight = self.straight_part(inputs, segment.from);
            for forces in [&mut *input, &mut *output] {
                straight.add_to(forces, constant, grid);
            }
            self.add_segment(closed, index, grid, [input, output]);
        }
        forces
    }

    /// With both positions prescribed, odd modes pull alike at both ends and even ones against each other: the sums over odd and
    /// over even modes give both ends at the price of one.
    fn add_segment(&self, closed: &Closed, segment: usize, grid: Grid, [input, output]: [&mut [f64]; 2]) {
        let terms = |weights: &[f64], share| self.terms(closed, segment, weights, share);
        let [weights, output_weights] = self.modes.weights();
        if !self.modes.is_mirrored() {
            // F_s is in the first line of each: the share of the straight part that both ends have.
            add(&terms(weights, [1.0, 0.0]), grid, &mut [Target { values: input, sign: 1.0 }]);
            add(&terms(output_weights, [0.0, 1.0]), grid, &mut [Target { values: output, sign: 1.0 }]);
            return;
        }
        // Odd modes pull both ends' windings the same way: F_i up, F_o down; even ones both up.
        for parity in [1.0, -1.0] {
            let each = weights.iter().enumerate();
            let of_parity: Vec<f64> =
                each.map(|(index, weight)| if end_sign(index + 1) == parity { *weight } else { 0.0 }).collect();
            let targets = [Target { values: &mut *input, sign: 1.0 }, Target { values: &mut *output, sign: -parity }];
            add(&terms(&of_parity, [0.5, -0.5 * parity]), grid, &mut { targets });
        }
    }

    /// What the mean length and straight inputs give a spring without mass, from a jump on.
    fn straight_part(&self, inputs: [&EndInput; 2], from: f64) -> Straight {
        let [first, second] = inputs.map(|input| input.straight_part(from));
        let constant = self.static_force_of([first.0, second.0]);
        Straight { constant, rate: self.static_force_of([first.1, second.1]) - self.static_force_of([0.0; 2]) }
    }

    /// What is summed for an end, counted from the segment's begin: weights w_j give `2Nk Σ_j w_j (q_j + β q̇_j)`, to which comes a
    /// share of F_i and of F_o, less the kept modes, that sines give.
    fn terms(&self, closed: &Closed, segment: usize, weights: &[f64], share: [f64; 2]) -> Vec<Term> {
        let (scale, dashpot) = (self.force_scale(), self.mount.damping().dashpot_time());
        let straight =
            |drive: &Drive| share[0] * self.straight_gain(drive, 0) + share[1] * self.straight_gain(drive, 1);
        modal_terms(closed, segment, weights, [scale, dashpot], straight)
    }
}

/// Terms of `scale Σ_j w_j (q_j + β q̇_j)` and of `straight` times each sine, counted from a segment's begin.
///
/// - `scale`, and β of the rates, `dashpot` \[s\]
pub(super) fn modal_terms(
    closed: &Closed,
    segment: usize,
    weights: &[f64],
    [scale, dashpot]: [f64; 2],
    straight: impl Fn(&Drive) -> f64,
) -> Vec<Term> {
    let segment = &closed.segments[segment];
    // Of a function e^(λt), value and dashpot together are 1 + βλ times it.
    let mut terms = Vec::with_capacity(weights.len() + 4);
    for exponential in &segment.exponentials {
        let weight = weights[exponential.mode];
        if weight != 0.0 && exponential.coefficient != Complex64::default() {
            let coefficient = scale * weight * exponential.coefficient * (1.0 + dashpot * exponential.root);
            terms.push(Term { coefficient, function: Function::Exponential(exponential.root) });
        }
    }
    for drive in closed.drives.iter().filter(|drive| drive.sine.acts_at(segment.from)) {
        let root = I * drive.sine.angular;
        let elapsed = segment.from - drive.sine.since;
        let steady: Complex64 = drive.gains.iter().zip(weights).map(|(gain, weight)| gain * weight).sum();
        let phasor = (I * drive.sine.phase + root * elapsed).exp();
        let mut shared = -I * phasor * (scale * steady * (1.0 + dashpot * root) + straight(drive));
        for near in drive.near.iter().filter(|near| weights[near.mode] != 0.0) {
            let coefficient = scale * weights[near.mode] * near.coefficient;
            shared += near.push_terms(&mut terms, coefficient, root, elapsed, dashpot);
        }
        if shared != Complex64::default() {
            terms.push(Term { coefficient: shared, function: Function::Exponential(root) });
        }
    }
    terms
}

impl EndForces {
    fn zero(samples: usize) -> Self {
        Self { input: vec![0.0; samples], output: vec![0.0; samples] }
    }
}

/// A force that runs straight.
struct Straight {
    constant: f64,
    rate: f64,
}

impl Straight {
    /// Adds it to forces that already hold `constant`.
    fn add_to(&self, forces: &mut [f64], constant: f64, grid: Grid) {
        let rest = self.constant - constant;
        if rest != 0.0 || self.rate != 0.0 {
            for (sample, force) in forces.iter_mut().enumerate() {
                *force += rest + self.rate * (grid.first + sample as f64 * grid.step);
            }
        }
    }
}

/// Whether times are equidistant to rounding, in order, not before the start, and worth working off together.
pub(super) fn is_equidistant(times: &[f64]) -> bool {
    if times.len() < FEWEST_TOGETHER {
        return false;
    }
    let (first, last, step) = (times[0], times[times.len() - 1], step_of(times));
    let tolerance = 4.0 * f64::EPSILON * last;
    let on = dispatch(CountOn { times, first, step, tolerance });
    first >= 0.0 && last > first && last.is_finite() && on == times.len() as u64
}
