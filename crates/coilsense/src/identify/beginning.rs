//! A record that begins with ringing: what struck the spring came before its first sample.
//!
//! Next door: hits within a record (`hits`).

use std::ops::Range;

use super::hits::{Hit, first_looked_at, lasting};
use super::ringing::Series;
use super::sampling::Sampling;

/// How many times its noise the ringing has to be.
const CLEAR: f64 = 10.0;
/// How many times as large it has to be in the first quarter of the record as in the last.
const FALL: f64 = 1.2;
/// Samples that are looked at together.
const CHUNK: usize = 1 << 16;

/// The beginning as a hit, where the record rings most there and then less and less.
pub(super) fn of(series: &[Series], sampling: &Sampling) -> Option<Hit> {
    let opening = first_looked_at(sampling).min(sampling.samples / 4);
    let (first, _) = squares(series, 0..opening);
    let quarter = sampling.samples / 4;
    let quarters = [0, 1, 2, 3].map(|number| squares(series, number * quarter..(number + 1) * quarter));
    let (rest, _) = squares(series, 4 * quarter..sampling.samples);
    let all = quarters.iter().fold(rest, |most, one| most.max(one.0));
    let noise: f64 = series.iter().map(|one| one.noise * one.noise).sum();
    let power = quarters.map(|quarter| quarter.1);
    let dies_out = power[0] > power[1] && power[0] >= FALL * FALL * power[3];
    let struck = first > CLEAR * CLEAR * noise && first >= all && dies_out;
    let after = lasting(sampling).min(sampling.samples - 1);
    struck.then(|| Hit { time: sampling.time(0), after, onset: 0, strength: first / noise })
}

/// The largest square of a range, those of all series together, and the sum of all of them \[N²\].
fn squares(series: &[Series], range: Range<usize>) -> (f64, f64) {
    let (mut largest, mut sum) = (0.0_f64, 0.0);
    for start in range.clone().step_by(CHUNK) {
        let part = start..(start + CHUNK).min(range.end);
        let mut squares = vec![0.0; part.len()];
        for one in series {
            squares.iter_mut().zip(one.flat(part.clone())).for_each(|(square, force)| *square += force * force);
        }
        largest = squares.iter().copied().fold(largest, f64::max);
        sum += squares.iter().sum::<f64>();
    }
    (largest, sum)
}
