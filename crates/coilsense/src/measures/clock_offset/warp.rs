//! A series between its samples, at places that run a little faster or slower than these.
//!
//! Next door: the places that are asked for (`drift`).

use std::f64::consts::{PI, TAU};

/// Samples to either side that a value between samples is made of.
pub(super) const REACH: usize = 32;
/// Places between two samples of the table; a straight line between them leaves π²/8/PHASES² = 3e-7 of a sine.
const PHASES: usize = 2048;

/// sin(πx)/πx under a Blackman–Harris window: exact to 1e-4 up to 0.45 cycles a sample, to 1e-6 up to 0.4.
pub(super) struct Sinc {
    weights: Vec<[f64; 2 * REACH]>,
}

impl Sinc {
    pub fn new() -> Self {
        let row = |phase: usize| {
            let mut row = [0.0; 2 * REACH];
            for (tap, weight) in row.iter_mut().enumerate() {
                *weight = kernel(phase as f64 / PHASES as f64 - (tap as f64 + 1.0 - REACH as f64));
            }
            row
        };
        Self { weights: (0..=PHASES).map(row).collect() }
    }

    /// Value at `place` \[samples\]; beyond its ends the series is zero.
    pub fn at(&self, series: &[f64], place: f64) -> f64 {
        let whole = place.floor();
        let phase = (place - whole) * PHASES as f64;
        let row = (phase as usize).min(PHASES - 1);
        let part = phase - row as f64;
        let first = whole as i64 + 1 - REACH as i64;
        let taps = self.weights[row].iter().zip(&self.weights[row + 1]).enumerate();
        taps.map(|(tap, (low, high))| {
            let value = usize::try_from(first + tap as i64).ok().and_then(|index| series.get(index));
            value.map_or(0.0, |value| value * (low + part * (high - low)))
        })
        .sum()
    }
}

/// At `x` samples from a sample.
fn kernel(x: f64) -> f64 {
    let turn = TAU * x / (2 * REACH) as f64;
    let window = 0.35875 + 0.48829 * turn.cos() + 0.14128 * (2.0 * turn).cos() + 0.01168 * (3.0 * turn).cos();
    let sinc = if x == 0.0 { 1.0 } else { (PI * x).sin() / (PI * x) };
    if x.abs() < REACH as f64 { sinc * window } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_is_met_between_its_samples() {
        let sinc = Sinc::new();
        for (cycles, most) in [(0.01, 1e-6), (0.2, 1e-6), (0.4, 2e-6), (0.45, 2e-3)] {
            let series: Vec<f64> = (0..400).map(|n| (TAU * cycles * f64::from(n)).sin()).collect();
            let worst = (0..1000).map(|n| 150.0 + 0.0973 * f64::from(n));
            let worst = worst.map(|at| (sinc.at(&series, at) - (TAU * cycles * at).sin()).abs()).fold(0.0, f64::max);
            assert!(worst < most, "{cycles}: {worst:e}");
        }
    }
}
