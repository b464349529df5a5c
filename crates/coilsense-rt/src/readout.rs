//! What an instrument makes of a quantity, step by step: low-pass ► delay ► averaging ► sampling ► noise ► resolution.
//!
//! Next door: the ring of past samples (`delay`), the mean (`boxcar`), random numbers (`noise`), where the numbers come from
//! (`coilsense::sensors`).

use crate::boxcar::{Boxcar, BoxcarState};
use crate::delay::{Delay, Ring};
use crate::noise::normal;
use crate::real::Real;

/// A pole of a low-pass, or a pair of conjugate ones, over a step.
///
/// d' = D d − Δ E, d how far it is behind, Δ by how much the input grows; the output gains Re(g d'). Each has a real and an imaginary part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReadoutPole<T> {
    /// D \[1\].
    pub decay: [T; 2],
    /// E \[1\].
    pub drag: [T; 2],
    /// g \[1\].
    pub share: [T; 2],
}

/// A mean over n + φ steps before now, of what is straight between samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReadoutMean<T> {
    /// n.
    pub whole: usize,
    /// Of what lies n steps back, n + 1 steps back, and of a whole step: φ(1 − φ/2)/(n + φ), φ²/2(n + φ), 1/(n + φ).
    pub weights: [T; 3],
}

/// An instrument in steps of one length, its low-pass of `POLES` poles: plain numbers that the host finds.
///
/// The quantity is taken as straight between samples, and what was before the first as the first.
///
/// Source:   `coilsense::sensors::Readout`, whose series it steps through.
/// Valid:    steps of the length for which it was made.
/// Accuracy: without noise 1e-12 of the largest value in `f64` beside that series, 1e-5 in `f32` (`coilsense`, `tests/readout_steps.rs`); noise has other numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Readout<T, const POLES: usize> {
    /// Of the low-pass; none lets all through.
    pub poles: [ReadoutPole<T>; POLES],
    /// By how many steps it comes late.
    pub delay: Delay<T>,
    /// Over which time it averages; none takes the moment.
    pub mean: Option<ReadoutMean<T>>,
    /// How many of its samples a step has; none follows every step.
    pub samples: Option<f64>,
    /// σ in the quantity's unit: a normal number for each of its samples, or for each step where it has none.
    pub noise: T,
    /// q in the quantity's unit, above zero; none does not round.
    pub resolution: Option<T>,
    /// Of the noise: the same seed gives the same numbers.
    pub seed: u64,
}

/// What a [`Readout`] remembers: `SLOTS` past samples, at least two more than its delay and its mean have steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReadoutState<T, const POLES: usize, const SLOTS: usize> {
    behind: [[T; 2]; POLES],
    before: T,
    late: Ring<T, SLOTS>,
    meant: BoxcarState<T, SLOTS>,
    last: T,
    held: T,
    steps: u64,
    taken: u64,
}

/// A time that rounds to just before a sample still means that sample \[samples\].
const NEARLY: f64 = 1e-6;

impl<T: Real, const POLES: usize> Readout<T, POLES> {
    /// The state of an instrument that has seen `x` for ever; its first sample is taken in the next step, at time zero.
    pub fn settled<const SLOTS: usize>(&self, x: T) -> ReadoutState<T, POLES, SLOTS> {
        ReadoutState {
            behind: [[T::ZERO; 2]; POLES],
            before: x,
            late: Ring::filled(x),
            meant: self.boxcar().settled(x),
            last: x,
            held: x,
            steps: 0,
            taken: 0,
        }
    }

    /// Takes the quantity at this step and gives the reading.
    #[inline]
    pub fn step<const SLOTS: usize>(&self, state: &mut ReadoutState<T, POLES, SLOTS>, x: T) -> T {
        let passed = self.passed(state, x);
        state.late.push(passed);
        let meant = self.meant(state, state.late.delayed(&self.delay));
        let steps = state.steps;
        state.steps = state.steps.wrapping_add(1);
        match self.samples {
            None => {
                state.held = self.read(meant, steps);
            }
            Some(rate) => {
                let now = steps as f64 * rate;
                let sample = (now + NEARLY) as u64;
                if steps == 0 || sample != state.taken {
                    state.taken = sample;
                    let since = (now - sample as f64) / rate;
                    let since = T::nearest(if since > 0.0 { since } else { 0.0 });
                    state.held = self.read(meant + since * (state.last - meant), sample);
                }
            }
        }
        state.last = meant;
        state.held
    }

    /// The low-pass.
    #[inline]
    fn passed<const SLOTS: usize>(&self, state: &mut ReadoutState<T, POLES, SLOTS>, x: T) -> T {
        let gain = x - state.before;
        state.before = x;
        let mut output = x;
        for (pole, behind) in self.poles.iter().zip(&mut state.behind) {
            let ([dr, di], [er, ei], [gr, gi]) = (pole.decay, pole.drag, pole.share);
            let [re, im] = *behind;
            *behind = [(dr * re - di * im) - gain * er, (dr * im + di * re) - gain * ei];
            output = output + (gr * behind[0] - gi * behind[1]);
        }
        output
    }

    /// The mean, of what is straight between samples: trapezia over whole steps, and the part of one before them.
    #[inline]
    fn meant<const SLOTS: usize>(&self, state: &mut ReadoutState<T, POLES, SLOTS>, x: T) -> T {
        let Some(ReadoutMean { whole, weights: [part, before, step] }) = self.mean else { return x };
        let rows = self.boxcar().weighted_sum(&mut state.meant, x);
        let (far, farther) = (state.meant.back(whole), state.meant.back(whole.saturating_add(1)));
        let mut sum = part * far + before * farther;
        if whole > 0 {
            sum = sum + step * (rows + T::nearest(0.5) * (far - x));
        }
        sum
    }

    #[inline]
    fn boxcar(&self) -> Boxcar<T> {
        let whole = self.mean.map_or(0, |mean| mean.whole);
        Boxcar { whole, fraction: T::ZERO, scale: T::ONE }
    }

    /// Noise and resolution.
    #[inline]
    fn read(&self, value: T, sample: u64) -> T {
        let mut reading = value;
        if self.noise > T::ZERO {
            reading = reading + self.noise * T::nearest(normal(self.seed, sample));
        }
        if let Some(step) = self.resolution {
            reading = rounded(reading, step);
        }
        reading
    }
}

/// The multiple of a step nearest to a value, halves to the even one; a value of so many steps that it has no digits left stays.
#[inline]
fn rounded<T: Real>(value: T, step: T) -> T {
    let steps = value / step;
    let size = if steps < T::ZERO { -steps } else { steps };
    if size < T::HALF_WHOLE { step * ((steps + T::ROUNDS) - T::ROUNDS) } else { value }
}
