//! End forces under sines, step by step: what the modes answer steadily turns with each sine, and the few modes near one are carried along
//! from rest; neither asks for a sine at each step.
//!
//! Next door: the free motion beside it (`march`), the same answers at any time (`closed`), the stream that adds both up (`stream`).

use num_complex::Complex64;

use super::Motion;
use super::closed::{Closed, Drive, Near};
use super::march::March;
use super::oscillator::{Oscillator, exponential};
use crate::excitation::{EndInput, Sine};

/// Steps from one evaluation at the time itself to the next: products between the two lose so many roundings at most, 3e-14, and what they
/// lose is gone then.
const RENEWED: u64 = 256;

/// Modes closer than this share of their frequency to a sine are carried along; the steady answer of the rest loses at most its inverse, a
/// factor 100, of rounding. Less than in the closed solution, for each costs time at every step, and the highest modes lie close together.
const NEAR: f64 = 0.01;

const I: Complex64 = Complex64::new(0.0, 1.0);

/// Sines that go on, at steps h.
#[derive(Debug, Clone)]
pub(super) struct Sines {
    step: f64,
    turning: Vec<Turning>,
}

/// One sine.
#[derive(Debug, Clone)]
struct Turning {
    sine: Sine,
    /// e^(i(Ωt + φ)) now, and e^(iΩh) − 1.
    phasor: Complex64,
    turn: Complex64,
    /// Of F_i and F_o: Im(force · phasor) is what a spring without mass, the modes left out, and the steady modes give.
    forces: [Complex64; 2],
    near: Vec<NearStep>,
}

/// A mode near the sine, at rest at t = 0.
#[derive(Debug, Clone)]
struct NearStep {
    near: Near,
    /// q and q̇ now.
    state: [f64; 2],
    /// What a step adds to them by itself ([`Oscillator::increment`]) …
    increment: [f64; 4],
    /// … and by the sine: Re(pull · phasor) with the phasor of its begin.
    pulls: [Complex64; 2],
    /// Forces \[N\] at each end for q and for q̇.
    weights: [[f64; 2]; 2],
}

impl Motion {
    /// The march of everything but the sines that go on, and these sines; `None` for the latter where there are none, or where a mode is so
    /// nearly critical that it has no closed solution: then the march does it all.
    pub(super) fn march_and_sines(&self, step: f64) -> (March, Option<Sines>) {
        let each = self.modes.frequencies().iter().zip(&self.ratios);
        let oscillators: Vec<Oscillator> = each.map(|(&natural, &ratio)| Oscillator { natural, ratio }).collect();
        let swings = |input: &EndInput| matches!(input, EndInput::Harmonics(sines) if !sines.is_empty());
        if !self.inputs().into_iter().any(swings) || oscillators.iter().any(Oscillator::is_nearly_critical) {
            return (self.march(step), None);
        }
        let drives = Closed::drives(&oscillators, &self.modes, self.inputs().map(only_sines), NEAR);
        let mut start = self.start.clone();
        drives.iter().for_each(|drive| drive.take_off_from(&mut start));
        let march = March::new(&self.modes, &self.ratios, start, self.inputs().map(without_sines), step);
        let turning = drives.into_iter().map(|drive| self.turning(&drive, &oscillators, step)).collect();
        (march, Some(Sines { step, turning }))
    }

    /// The inputs but for those sines.
    pub(super) fn inputs_beside(&self, sines: Option<&Sines>) -> [&EndInput; 2] {
        if sines.is_some() { self.inputs().map(without_sines) } else { self.inputs() }
    }

    fn turning(&self, drive: &Drive, oscillators: &[Oscillator], step: f64) -> Turning {
        let (scale, dashpot) = (self.force_scale(), self.mount.damping().dashpot_time());
        let (root, weights) = (I * drive.sine.angular, self.modes.weights());
        let force = |end: usize| {
            let steady: Complex64 = drive.gains.iter().zip(weights[end]).map(|(gain, weight)| gain * weight).sum();
            scale * steady * (1.0 + dashpot * root) + self.straight_gain(drive, end)
        };
        let near_step = |near: &Near| NearStep {
            near: *near,
            state: [0.0; 2],
            increment: oscillators[near.mode].increment(step),
            // The coefficient has e^(iφ) in it, and so has the phasor.
            pulls: near.pulls(drive.sine.angular, step).map(|pull| pull * (-I * drive.sine.phase).exp()),
            weights: weights.map(|weights| [1.0, dashpot].map(|part| part * scale * weights[near.mode])),
        };
        let angle = drive.sine.angular * step;
        let half = (0.5 * angle).sin();
        Turning {
            phasor: exponential(I * drive.sine.phase),
            // Less one: the rounding of a number near one would add up, always the same way.
            turn: Complex64::new(-2.0 * half * half, angle.sin()),
            forces: [0, 1].map(force),
            near: drive.near.iter().map(near_step).collect(),
            sine: drive.sine,
        }
    }
}

impl Sines {
    /// Goes on to sample `sample`, which follows the one before, and gives both forces \[N\] there.
    #[inline]
    pub(super) fn step_to(&mut self, sample: u64) -> [f64; 2] {
        let is_renewed = sample.is_multiple_of(RENEWED);
        let mut forces = [0.0; 2];
        for turning in &mut self.turning {
            if is_renewed {
                turning.renew(sample as f64 * self.step);
            } else {
                turning.advance();
            }
            turning.add_to(&mut forces);
        }
        forces
    }
}

impl Turning {
    /// By one step, in products.
    #[inline]
    fn advance(&mut self) {
        for near in &mut self.near {
            let ([q, rate], [r11, r12, r21, r22]) = (near.state, near.increment);
            let [of_q, of_rate] = near.pulls.map(|pull| pull.re * self.phasor.re - pull.im * self.phasor.im);
            near.state = [q + (r11 * q + r12 * rate + of_q), rate + (r21 * q + r22 * rate + of_rate)];
        }
        self.phasor += self.turn * self.phasor;
    }

    /// To a time, in closed form.
    #[cold]
    fn renew(&mut self, time: f64) {
        let sine = self.sine;
        self.phasor = exponential(I * (sine.angular * time + sine.phase));
        for near in &mut self.near {
            near.state = near.near.pulls(sine.angular, time).map(|pull| pull.re);
        }
    }

    #[inline]
    fn add_to(&self, forces: &mut [f64; 2]) {
        for (force, gain) in forces.iter_mut().zip(self.forces) {
            *force += gain.re * self.phasor.im + gain.im * self.phasor.re;
        }
        for NearStep { state: [q, rate], weights, .. } in &self.near {
            for (force, [of_q, of_rate]) in forces.iter_mut().zip(weights) {
                *force += of_q * q + of_rate * rate;
            }
        }
    }
}

/// Only the sines that go on.
fn only_sines(input: &EndInput) -> &EndInput {
    if matches!(input, EndInput::Harmonics(_)) { input } else { &EndInput::Held }
}

/// Everything but these.
fn without_sines(input: &EndInput) -> &EndInput {
    if matches!(input, EndInput::Harmonics(_)) { &EndInput::Held } else { input }
}
