//! A record that begins with ringing: what struck the spring came before its first sample.
//!
//! Next door: hits within a record (`hits`).

use super::hits::{Hit, first_looked_at, lasting};
use super::ringing::Series;
use super::sampling::Sampling;

/// How many times its noise the ringing has to be.
const CLEAR: f64 = 10.0;
/// How many times as large it has to be in the first quarter of the record as in the last.
const FALL: f64 = 1.2;

/// The beginning as a hit, where the record rings most there and then less and less.
pub(super) fn of(series: &[Series], sampling: &Sampling) -> Option<Hit> {
    let square = |index: usize| series.iter().map(|one| one.flat[index].powi(2)).sum::<f64>();
    let squares: Vec<f64> = (0..sampling.samples).map(square).collect();
    let opening = first_looked_at(sampling).min(sampling.samples / 4);
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    let (first, all) = (largest(&squares[..opening]), largest(&squares));
    let noise: f64 = series.iter().map(|one| one.noise * one.noise).sum();
    let quarter = sampling.samples / 4;
    let power = |number: usize| squares[number * quarter..(number + 1) * quarter].iter().sum::<f64>();
    let dies_out = power(0) > power(1) && power(0) >= FALL * FALL * power(3);
    let struck = first > CLEAR * CLEAR * noise && first >= all && dies_out;
    let after = lasting(sampling).min(sampling.samples - 1);
    struck.then(|| Hit { time: sampling.time(0), after, onset: 0, strength: first / noise })
}
