//! A plant from sample to sample, its command held or straight in between.
//!
//! Next door: its poles (`poles`), the loop around it (`over_time`).

use std::sync::Arc;

use num_complex::Complex64;

use super::matrices::OUTPUTS;
use super::poles::Poles;

/// What a command does between its samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hold {
    /// It stays.
    Zero,
    /// It goes straight to the next.
    First,
}

/// A plant that is stepped, one complex number for each pole.
///
/// x⁺ = e^(ph) x + g0 c + g1 c⁺; held g0 = h φ1(ph), g1 = 0; straight g0 = h (φ1 − φ2), g1 = h φ2; φ1(z) = (e^z − 1)/z, φ2(z) = (φ1 − 1)/z
///
/// Source:   `[Franklin1998]` section 6.3.
/// Valid:    as [`Poles`].
/// Accuracy: that of the poles; nothing is lost from sample to sample.
#[derive(Debug, Clone)]
pub(super) struct Stepped {
    poles: Arc<Poles>,
    state: Vec<Complex64>,
    turn: Vec<Complex64>,
    gains: [Vec<Complex64>; 2],
    hold: Hold,
    /// What is felt at once of the present command.
    at_once: [f64; OUTPUTS],
    /// The command that stands.
    command: f64,
}

impl Stepped {
    /// At rest, to be stepped by h \[s\].
    pub fn new(poles: Arc<Poles>, step: f64, hold: Hold) -> Self {
        let angles: Vec<Complex64> = poles.values().map(|pole| pole * step).collect();
        let gains = |pick: fn([Complex64; 2]) -> Complex64| angles.iter().map(|z| step * pick(phi(*z))).collect();
        let gains: [Vec<Complex64>; 2] = match hold {
            Hold::Zero => [gains(|[first, _]| first), vec![Complex64::ZERO; angles.len()]],
            Hold::First => [gains(|[first, second]| first - second), gains(|[_, second]| second)],
        };
        let mut stepped = Self {
            state: vec![Complex64::ZERO; angles.len()],
            turn: angles.iter().map(|z| z.exp()).collect(),
            gains,
            hold,
            at_once: [0.0; OUTPUTS],
            command: 0.0,
            poles,
        };
        if hold == Hold::First {
            stepped.at_once = stepped.poles.outputs(&stepped.gains[1]);
            stepped.at_once.iter_mut().zip(stepped.poles.direct()).for_each(|(sum, direct)| *sum += direct);
        }
        stepped
    }

    /// The plant's poles.
    pub fn poles(&self) -> &Arc<Poles> {
        &self.poles
    }

    /// What its command does between samples.
    pub fn hold(&self) -> Hold {
        self.hold
    }

    /// How much of the present command each output feels at once, per command: nothing where it is held.
    pub fn at_once(&self) -> [f64; OUTPUTS] {
        self.at_once
    }

    /// Forces \[N\] and stroke \[m\] at this sample. Where the command is straight, less what [`Self::take`] will add of it.
    pub fn outputs(&self) -> [f64; OUTPUTS] {
        let mut outputs = self.poles.outputs(&self.state);
        if self.hold == Hold::Zero {
            // Beside dashpots the force just before the command changes.
            outputs.iter_mut().zip(self.poles.direct()).for_each(|(sum, direct)| *sum += direct * self.command);
        }
        outputs
    }

    /// q_j \[m\] at this sample.
    pub fn modes(&self) -> Vec<f64> {
        self.poles.modes(&self.state)
    }

    /// Takes the command of this sample.
    pub fn take(&mut self, command: f64) {
        for (state, gain) in self.state.iter_mut().zip(&self.gains[1]) {
            *state += gain * command;
        }
        self.command = command;
    }

    /// Goes on to the next sample.
    pub fn advance(&mut self) {
        for ((state, turn), gain) in self.state.iter_mut().zip(&self.turn).zip(&self.gains[0]) {
            *state = *turn * *state + gain * self.command;
        }
    }
}

/// φ1 and φ2, by their series where differences would cancel.
fn phi(z: Complex64) -> [Complex64; 2] {
    if z.norm() < 0.5 {
        // Sixteen terms: 0.5^16/17! is far below rounding.
        let series = |first: u32| {
            let mut term = Complex64::ONE;
            let mut sum = Complex64::ZERO;
            for k in 1..=16 {
                term /= f64::from(k);
                if k >= first {
                    sum += term * z.powu(k - first);
                }
            }
            sum
        };
        return [series(1), series(2)];
    }
    let first = (z.exp() - 1.0) / z;
    [first, (first - 1.0) / z]
}
