//! Where the windings start, in modal coordinates.
//!
//! Next door: how they go on (`closed`, `march`).

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::Motion;
use super::closed::ModalState;
use super::oscillator::Oscillator;
use crate::error::{Error, called, check, count};
use crate::excitation::{Start, VelocityProfile};

impl Motion {
    /// The start relative to the straight line between the ends. What is affine along the coil is projected in closed form.
    ///
    /// An end mass starts as a winding at end 2 would; with a start given winding by winding, at its mean and at rest.
    pub(super) fn relative_start(&self) -> Result<ModalState, Error> {
        let mean = self.excitation.mean_length();
        let [first, second] = self.line(0.0);
        let (u, v) = ([first, second - mean], self.line_velocity(0.0));
        let lines = |displacement, velocity| ModalState {
            coordinates: self.modes.project_line(displacement),
            rates: self.modes.project_line(velocity),
        };
        let mut state = match self.excitation.start() {
            // It has followed a step at t = 0 already.
            Start::Massless => return Ok(lines([0.0; 2], [0.0; 2])),
            Start::Rest => lines([-u[0], -u[1]], [-v[0], -v[1]]),
            Start::Steady => self.steady_start()?,
            Start::Moving { velocity, profile } => {
                let at_end_1 = match profile {
                    VelocityProfile::Uniform => *velocity,
                    VelocityProfile::Linear => 0.0,
                };
                lines([-u[0], -u[1]], [at_end_1 - v[0], velocity - v[1]])
            }
            Start::Windings { positions, velocities } => {
                count(called("positions", "start positions"), positions.len(), self.modes.masses())?;
                let each = positions.iter().enumerate();
                let evenly: Vec<f64> =
                    each.map(|(index, position)| position - self.modes.offset_at(index + 1)).collect();
                ModalState {
                    coordinates: self.modes.project(&self.less_line(&evenly, [u[0], mean + u[1]]), -u[1]),
                    rates: self.modes.project(&self.less_line(velocities, v), -v[1]),
                }
            }
        };
        self.add_impulses(&mut state.rates);
        Ok(state)
    }

    /// Adds what damping makes of a step at t = 0 ([`Oscillator::impulse`]): the windings start as they do, then the line jumps.
    fn add_impulses(&self, rates: &mut [f64]) {
        for (input, participations) in self.inputs().into_iter().zip(self.modes.participations()) {
            let height = input.step_at_start();
            if height == 0.0 {
                continue;
            }
            let modes = self.modes.frequencies().iter().zip(&self.ratios).zip(participations);
            for (rate, ((&natural, &ratio), participation)) in rates.iter_mut().zip(modes) {
                *rate += participation * height * Oscillator { natural, ratio }.impulse();
            }
        }
    }

    /// Where forced motion has led when all free motion has died.
    ///
    /// q_j = Im Σ g e^(iφ), q̇_j = Im Σ iω g e^(iφ) with g = c_j a ω² / (ω_j² − ω² + 2iζ_jω_jω), over the sines a sin(ωt + φ) of both ends
    ///
    /// Source:   the particular solution of the modes' equation ([`Motion`]).
    /// Valid:    no mode undamped and driven exactly at its frequency.
    /// Accuracy: 2e-16 of ω_j² relative in the denominator.
    ///
    /// # Errors
    /// [`Error::Value`] for an undamped mode driven at its very frequency, which has no steady state.
    fn steady_start(&self) -> Result<ModalState, Error> {
        let mut state = ModalState::zero(self.modes.count());
        for (input, participations) in self.inputs().into_iter().zip(self.modes.participations()) {
            for sine in input.sines() {
                let (omega, phasor) = (sine.angular, Complex64::cis(sine.phase));
                let modes = self.modes.frequencies().iter().zip(&self.ratios).zip(participations);
                for (mode, ((&natural, &ratio), participation)) in modes.enumerate() {
                    let detuning = Complex64::new((natural - omega) * (natural + omega), 2.0 * ratio * natural * omega);
                    let quantity = format!("frequency of a sine at the undamped mode {}", mode + 1);
                    let settles = detuning != Complex64::default() || *participation == 0.0;
                    check(
                        settles,
                        quantity,
                        omega / TAU,
                        "Hz",
                        "off that mode's, or the mode damped, for a steady start",
                    )?;
                    if *participation != 0.0 {
                        let swing = participation * sine.amplitude * omega * omega / detuning * phasor;
                        state.coordinates[mode] += swing.im;
                        state.rates[mode] += omega * swing.re;
                    }
                }
            }
        }
        Ok(state)
    }

    /// `values` less the straight line from `line[0]` at end 1 to `line[1]` at end 2.
    fn less_line(&self, values: &[f64], line: [f64; 2]) -> Vec<f64> {
        let each = values.iter().enumerate();
        each.map(|(index, value)| value - (line[0] + self.modes.place_at(index + 1) * (line[1] - line[0]))).collect()
    }
}
