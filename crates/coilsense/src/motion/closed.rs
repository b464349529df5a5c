//! The modal coordinates in closed form: free motion between jumps, and the answer to each sine.
//!
//! Next door: one mode (`oscillator`), many times at once (`phasor_sum`), inputs without an elementary solution (`march`).

use num_complex::Complex64;

use super::oscillator::{Oscillator, Roots, divided_exponential, exponential};
use super::phasor_sum::{Function, Term};
use crate::excitation::{EndInput, Kick, Sine};
use crate::modes::ModalModel;

/// Modes closer than this share of their frequency to a sine take [`divided_exponential`]; the rest share one sine per drive and
/// lose at most its inverse, a factor 20, of rounding.
const NEAR: f64 = 0.05;

/// More jumps than this are followed step by step instead: each costs as much as a start.
const MOST_JUMPS: usize = 64;

const I: Complex64 = Complex64::new(0.0, 1.0);

/// A moment's modal coordinates and their rates, shape `count` each.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ModalState {
    pub coordinates: Vec<f64>,
    pub rates: Vec<f64>,
}

impl ModalState {
    pub(super) fn zero(count: usize) -> Self {
        Self { coordinates: vec![0.0; count], rates: vec![0.0; count] }
    }
}

/// Everything that the closed solution is made of.
#[derive(Debug, Clone)]
pub(super) struct Closed {
    pub oscillators: Vec<Oscillator>,
    /// Free motion from each jump on, in order of time.
    pub segments: Vec<Segment>,
    pub drives: Vec<Drive>,
}

/// The free motion from a time on: `q_j = Re Σ K e^(λ(t − from))` over the exponentials of mode j.
#[derive(Debug, Clone)]
pub(super) struct Segment {
    pub from: f64,
    pub exponentials: Vec<Exponential>,
}

/// One exponential of one mode.
#[derive(Debug, Clone, Copy)]
pub(super) struct Exponential {
    pub mode: usize,
    pub root: Complex64,
    pub coefficient: Complex64,
}

/// The answer to one sine: steady on the modes far from it, from rest on the modes near it.
#[derive(Debug, Clone)]
pub(super) struct Drive {
    /// 0 for the input of end 1, 1 for that of end 2.
    pub end: usize,
    pub sine: Sine,
    /// `q_j = Im(gain e^(i(ω(t − since) + φ)))`, zero for modes near the drive; shape `count`.
    pub gains: Vec<Complex64>,
    pub near: Vec<Near>,
}

/// A mode near a sine: `q = Re(coefficient [E(λ, iω, t) − E(λ*, iω, t)])`, E the divided exponential.
#[derive(Debug, Clone, Copy)]
pub(super) struct Near {
    pub mode: usize,
    pub root: Complex64,
    pub coefficient: Complex64,
}

impl Closed {
    /// The closed solution, or `None` where there is none worth having: a chirp, very many jumps, a mode damped just critically.
    pub(super) fn new(modes: &ModalModel, ratios: &[f64], start: ModalState, inputs: [&EndInput; 2]) -> Option<Self> {
        let jumps: usize = inputs.iter().map(|input| input.most_kicks()).sum();
        if jumps > MOST_JUMPS || inputs.iter().any(|input| input.is_chirp()) {
            return None;
        }
        let each = modes.frequencies().iter().zip(ratios);
        let oscillators: Vec<Oscillator> = each.map(|(&natural, &ratio)| Oscillator { natural, ratio }).collect();
        if oscillators.iter().any(Oscillator::is_nearly_critical) {
            return None;
        }
        let drives = Self::drives(&oscillators, modes, inputs, NEAR);
        let mut closed = Self { oscillators, segments: Vec::new(), drives };
        closed.begin(start);
        for (end, kick) in EndInput::kicks_of_both(inputs) {
            closed.jump(modes.participations()[end], kick);
        }
        Some(closed)
    }

    /// The answer to each sine of both inputs; modes closer to one than the share `near` of their frequency are taken apart.
    pub(super) fn drives(
        oscillators: &[Oscillator],
        modes: &ModalModel,
        inputs: [&EndInput; 2],
        near: f64,
    ) -> Vec<Drive> {
        let mut drives = Vec::new();
        for (end, (input, participations)) in inputs.into_iter().zip(modes.participations()).enumerate() {
            let of_sine = |sine| Drive::new(oscillators, end, sine, participations, near);
            drives.extend(input.sines().map(of_sine));
        }
        drives
    }

    /// The first segment, from t = 0.
    fn begin(&mut self, mut state: ModalState) {
        self.take_off_steady(&mut state, 0.0);
        self.push(0.0, &state);
    }

    /// A new segment after a jump of an input: winding positions stay, the straight line jumps under them, and damping, which acts on
    /// velocities relative to it, gives each mode an impulse ([`Oscillator::impulse`]).
    fn jump(&mut self, participation: &[f64], kick: Kick) {
        let mut state = ModalState::zero(self.oscillators.len());
        self.free_state(kick.time, &mut state);
        // What a sine that ends now has driven goes on freely.
        if self.segments.last().is_some_and(|last| last.from < kick.time) {
            for drive in self.drives.iter().filter(|drive| drive.sine.until == kick.time) {
                drive.add_to(kick.time, &mut state);
            }
        }
        for (mode, (participation, oscillator)) in participation.iter().zip(&self.oscillators).enumerate() {
            state.coordinates[mode] -= participation * kick.displacement;
            state.rates[mode] -= participation * (kick.velocity - oscillator.impulse() * kick.displacement);
        }
        self.take_off_steady(&mut state, kick.time);
        self.push(kick.time, &state);
    }

    /// A sine that begins now has a steady answer that does not begin from rest: the free motion takes off what it starts with.
    fn take_off_steady(&self, state: &mut ModalState, time: f64) {
        for drive in self.drives.iter().filter(|drive| drive.sine.since == time) {
            if time > 0.0 && self.segments.iter().any(|segment| segment.from == time) {
                continue; // taken off by an earlier jump at the same moment
            }
            drive.take_off_from(state);
        }
    }

    fn push(&mut self, from: f64, state: &ModalState) {
        let mut exponentials = Vec::with_capacity(self.oscillators.len());
        for (mode, oscillator) in self.oscillators.iter().enumerate() {
            let (q, v) = (state.coordinates[mode], state.rates[mode]);
            match oscillator.roots() {
                Roots::Pair(root) => {
                    let coefficient = Complex64::new(q, (q * root.re - v) / root.im);
                    exponentials.push(Exponential { mode, root, coefficient });
                }
                Roots::Real(slow, fast) => {
                    let first = (v - fast * q) / (slow - fast);
                    for (root, coefficient) in [(slow, first), (fast, q - first)] {
                        exponentials.push(Exponential { mode, root: root.into(), coefficient: coefficient.into() });
                    }
                }
            }
        }
        self.segments.push(Segment { from, exponentials });
    }

    /// The segment in force at a time.
    pub(super) fn segment_at(&self, time: f64) -> &Segment {
        let next = self.segments.partition_point(|segment| segment.from <= time);
        &self.segments[next.max(1) - 1]
    }

    /// The numbers of the segments that times in order fall into, each with its samples.
    pub(super) fn stretches(&self, times: &[f64]) -> impl Iterator<Item = (usize, std::ops::Range<usize>)> {
        let mut first = 0;
        let samples = self.segments.iter().enumerate().map(move |(index, _)| {
            let until = self.segments.get(index + 1).map_or(f64::INFINITY, |next| next.from);
            let samples = first..first + times[first..].partition_point(|&time| time < until);
            first = samples.end;
            (index, samples)
        });
        samples.filter(|(_, samples)| !samples.is_empty())
    }

    fn free_state(&self, time: f64, state: &mut ModalState) {
        state.coordinates.fill(0.0);
        state.rates.fill(0.0);
        let segment = self.segment_at(time);
        for part in segment.exponentials.iter().filter(|part| part.coefficient != Complex64::default()) {
            let value = part.coefficient * exponential(part.root * (time - segment.from));
            state.coordinates[part.mode] += value.re;
            state.rates[part.mode] += (value * part.root).re;
        }
    }

    /// q_j and q̇_j at a time, into a state of as many modes.
    pub(super) fn state_into(&self, time: f64, state: &mut ModalState) {
        self.free_state(time, state);
        for drive in self.drives.iter().filter(|drive| drive.sine.acts_at(time)) {
            drive.add_to(time, state);
        }
    }
}

impl Drive {
    /// Takes off what its steady answer begins with.
    pub(super) fn take_off_from(&self, state: &mut ModalState) {
        let phasor = (I * self.sine.phase).exp();
        for (mode, gain) in self.gains.iter().enumerate() {
            let steady = gain * phasor;
            state.coordinates[mode] -= steady.im;
            state.rates[mode] -= self.sine.angular * steady.re;
        }
    }

    /// Adds its answer at a time.
    fn add_to(&self, time: f64, state: &mut ModalState) {
        let elapsed = time - self.sine.since;
        let phasor = exponential(I * (self.sine.angular * elapsed + self.sine.phase));
        for (mode, gain) in self.gains.iter().enumerate() {
            let steady = gain * phasor;
            state.coordinates[mode] += steady.im;
            state.rates[mode] += self.sine.angular * steady.re;
        }
        for near in &self.near {
            let [of_coordinate, of_rate] = near.pulls(self.sine.angular, elapsed);
            state.coordinates[near.mode] += of_coordinate.re;
            state.rates[near.mode] += of_rate.re;
        }
    }

    /// `q̈ + 2ζω_n q̇ + ω_n² q = c a ω² sin(ω(t − since) + φ)` for each mode.
    fn new(oscillators: &[Oscillator], end: usize, sine: Sine, participations: &[f64], near: f64) -> Self {
        let mut drive = Self { end, sine, gains: vec![Complex64::default(); oscillators.len()], near: Vec::new() };
        let omega = sine.angular;
        for (mode, (oscillator, participation)) in oscillators.iter().zip(participations).enumerate() {
            let acceleration = participation * sine.amplitude * omega * omega;
            match oscillator.roots() {
                Roots::Pair(root) if (oscillator.natural - omega).abs() < near * oscillator.natural => {
                    // Im(e^(iφ)/(2iω_d) […]) as a real part.
                    let coefficient = -acceleration * (I * sine.phase).exp() / (2.0 * root.im);
                    drive.near.push(Near { mode, root, coefficient });
                }
                _ => drive.gains[mode] = acceleration * oscillator.steady_gain(omega),
            }
        }
        drive
    }
}

impl Near {
    /// E(λ, iω, t) and E(λ*, iω, t), each with its rate but for the e^(iωt) that both share.
    fn parts(&self, drive: f64, time: f64) -> [(Complex64, Complex64); 2] {
        [self.root, self.root.conj()].map(|root| {
            let value = divided_exponential(root, I * drive, time);
            (value, root * value)
        })
    }

    /// q and q̇ a time after the drive began, as the real parts of these.
    pub(super) fn pulls(&self, drive: f64, time: f64) -> [Complex64; 2] {
        let [(first, first_rate), (second, second_rate)] = self.parts(drive, time);
        [self.coefficient * (first - second), self.coefficient * (first_rate - second_rate)]
    }

    /// The terms of `coefficient (E(λ) − E(λ*) + β d/dt of both)`, with time counted from `elapsed` after the drive began; returns the
    /// coefficient of e^(iωt), which others share.
    ///
    /// `E(t + s) = e^(λs) E(t) + E(s) e^(iωt)`, and `dE/dt = λE + e^(iωt)`, of which the last cancels between the two. λ* is far from iω,
    /// so that its part may be taken apart.
    pub(super) fn push_terms(
        &self,
        terms: &mut Vec<Term>,
        coefficient: Complex64,
        drive: Complex64,
        elapsed: f64,
        dashpot: f64,
    ) -> Complex64 {
        let factor = coefficient * (1.0 + dashpot * self.root);
        let carried = factor * (self.root * elapsed).exp();
        terms.push(Term { coefficient: carried, function: Function::Divided(self.root, drive) });
        let far = self.root.conj();
        let apart = -coefficient * (1.0 + dashpot * far) / (far - drive);
        let carried = apart * (far * elapsed).exp();
        terms.push(Term { coefficient: carried, function: Function::Exponential(far) });
        factor * divided_exponential(self.root, drive, elapsed) - apart * (drive * elapsed).exp()
    }
}
