//! Where the ends are over time, and the force that a sensor of their distance reads.
//!
//! Next door: the windings between them (`windings`), the forces at them (`forces`).

use num_complex::Complex64;

use super::closed::{Closed, ModalState};
use super::forces::{is_equidistant, modal_terms};
use super::modal_rows::{WIDTH, row_of};
use super::phasor_sum::{Function, Grid, Target, Term, add};
use super::{Motion, check_times, in_order, step_of};
use crate::error::Error;
use crate::excitation::EndInput;
use crate::mount::FarEnd;

impl Motion {
    /// u1 and u2 \[m\] at each time, shape `samples × 2`; end 1 has its mean at 0.
    ///
    /// # Errors
    /// [`Error::Count`] for no times; [`Error::Value`] for the first that is not finite or below zero.
    pub fn ends(&self, times: &[f64]) -> Result<Vec<[f64; 2]>, Error> {
        let [first, second] = self.end_positions(times)?;
        Ok(first.into_iter().zip(second).map(<[f64; 2]>::from).collect())
    }

    /// F_x \[N\]: force of a spring without mass between the ends where they are; shape `samples`.
    ///
    /// F_x = k (u2 − u1 − l0)
    ///
    /// - `times`: t \[s\], shape `samples`, in any order, none below zero; equidistant ones in order are fastest
    ///
    /// Source:   `[Weijde2017]` section III-C; [`crate::sensors::deflection_force`] of [`Self::ends`].
    /// Valid:    an ideal sensor; no initial tension.
    /// Accuracy: rounding of the difference of lengths.
    ///
    /// # Errors
    /// As [`Self::ends`].
    pub fn deflection_forces(&self, times: &[f64]) -> Result<Vec<f64>, Error> {
        let [mut first, second] = self.end_positions(times)?;
        for (u1, u2) in first.iter_mut().zip(&second) {
            *u1 = self.spring.static_force(u2 - *u1);
        }
        Ok(first)
    }

    /// u1 and u2 \[m\], each of shape `samples`.
    pub(super) fn end_positions(&self, times: &[f64]) -> Result<[Vec<f64>; 2], Error> {
        if !is_equidistant(times) {
            check_times(times)?;
        }
        let [first, mut second] = self.lines(times);
        if self.mount.far_end() == FarEnd::Position {
            return Ok([first, second]);
        }
        if let Some(closed) = self.closed.as_ref().filter(|_| is_equidistant(times)) {
            self.add_swing(closed, times, &mut second);
            return Ok([first, second]);
        }
        let shapes = self.modes.end_shapes();
        self.for_each_block(times, |block| {
            for (mode, shape) in shapes.iter().enumerate() {
                let row = &block.coordinates[row_of(mode, shapes.len()) * WIDTH..][..WIDTH];
                block.samples.iter().zip(row).for_each(|(&sample, q)| second[sample] += shape * q);
            }
        })?;
        Ok([first, second])
    }

    /// The ends of the straight line from which the modes count, u1 and û2 \[m\], each of shape `samples`; times are trusted.
    pub(super) fn lines(&self, times: &[f64]) -> [Vec<f64>; 2] {
        let equidistant = is_equidistant(times);
        let [first, mut second] = self.inputs().map(|input| displacements(input, times, equidistant));
        if self.mount.far_end() == FarEnd::Position {
            let mean = self.excitation.mean_length();
            second.iter_mut().for_each(|u2| *u2 += mean);
        } else {
            for (u1, u2) in first.iter().zip(&mut second) {
                *u2 = self.line_of([*u1, *u2])[1];
            }
        }
        [first, second]
    }

    /// Σ_j w_j (q_j + β q̇_j) at each time for several series of weights, β as in [`Self::end_forces`]; shape `series × samples`.
    ///
    /// # Errors
    /// As [`Self::ends`].
    pub(crate) fn modal_sums(&self, times: &[f64], weights: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, Error> {
        let dashpot = self.mount.damping().dashpot_time();
        let mut sums = vec![vec![0.0; times.len()]; weights.len()];
        if let Some(closed) = self.closed.as_ref().filter(|_| is_equidistant(times)) {
            for (weights, sums) in weights.iter().zip(&mut sums) {
                self.add_modal_sum(closed, times, weights, dashpot, sums);
            }
            return Ok(sums);
        }
        check_times(times)?;
        let mut set = |sample: usize, state: &ModalState| {
            for (weights, sums) in weights.iter().zip(&mut sums) {
                let each = weights.iter().zip(state.coordinates.iter().zip(&state.rates));
                sums[sample] = each.map(|(weight, (q, rate))| weight * (q + dashpot * rate)).sum();
            }
        };
        if let Some(closed) = &self.closed {
            let mut state = ModalState::zero(self.modes.count());
            for (sample, &time) in times.iter().enumerate() {
                closed.state_into(time, &mut state);
                set(sample, &state);
            }
        } else {
            let mut march = self.march(step_of(times));
            for sample in in_order(times) {
                march.advance_to(times[sample]);
                set(sample, &march.state());
            }
        }
        Ok(sums)
    }

    /// Adds `Σ_j ψ_j q_j`, how far end 2 is from where a spring without mass would end, at equidistant times.
    fn add_swing(&self, closed: &Closed, times: &[f64], second: &mut [f64]) {
        self.add_modal_sum(closed, times, self.modes.end_shapes(), 0.0, second);
    }

    /// Adds `Σ_j w_j (q_j + β q̇_j)` at equidistant times.
    fn add_modal_sum(&self, closed: &Closed, times: &[f64], weights: &[f64], dashpot: f64, sums: &mut [f64]) {
        for (segment, samples) in closed.stretches(times) {
            let first = times[samples.start] - closed.segments[segment].from;
            let grid = Grid { first, step: step_of(times), samples: samples.len() };
            let terms = modal_terms(closed, segment, weights, [1.0, dashpot], |_| 0.0);
            add(&terms, grid, &mut [Target { values: &mut sums[samples], sign: 1.0 }]);
        }
    }
}

/// An input's displacements at each time \[m or N\]; sines at equidistant times are processed together.
fn displacements(input: &EndInput, times: &[f64], equidistant: bool) -> Vec<f64> {
    if !equidistant || !matches!(input, EndInput::Harmonics(_) | EndInput::HalfSine { .. }) {
        return input.displacements(times);
    }
    let mut displacements = vec![0.0; times.len()];
    for sine in input.sines() {
        let begin = times.partition_point(|&time| time < sine.since);
        let samples = begin..times.partition_point(|&time| time < sine.until).max(begin);
        if samples.is_empty() {
            continue;
        }
        let grid = Grid { first: times[begin] - sine.since, step: step_of(times), samples: samples.len() };
        // a sin(ωt + φ) = Re(−i a e^(iφ) e^(iωt))
        let coefficient = Complex64::new(0.0, -sine.amplitude) * Complex64::cis(sine.phase);
        let function = Function::Exponential(Complex64::new(0.0, sine.angular));
        add(&[Term { coefficient, function }], grid, &mut [Target { values: &mut displacements[samples], sign: 1.0 }]);
    }
    displacements
}
