//! Hits: the moments at which something struck the spring, found in what its past does not predict.
//!
//! Next door: the prediction (`whitening`), a record that begins with ringing (`beginning`), what rings after them (`lines`, `refine`).

use super::channel_check::{Conditions, QUIET};
use super::median::median;
use super::ringing::NEARBY;
use super::sampling::Sampling;
use super::whitening::{ORDER, Surprise};

/// Samples over which a surprise is added up.
const WINDOW: usize = 4;
/// How many times the energy of noise a hit has.
const THRESHOLD: f64 = 9.0;
/// What echoes of a hit stay below, relative to it, and for how long \[s\]: the wave runs to and fro, and a hammer bounces. The first time
/// that it comes back to an end, the force jumps by twice what it jumped at the hit: four times the energy.
const ECHOES: [(f64, f64); 2] = [(5.0, 0.06), (0.5, 0.25)];
/// How far from both ends of a record hits are looked for \[s\]: there the running means have few samples left, and a hit could not be told
/// from its echoes.
const EDGE: f64 = 0.06;
/// How long a hit may last \[s\].
const LASTING: f64 = 0.004;
/// Periods of a low-pass's corner after which it has answered a hit.
const RESPONSE: f64 = 2.0;
/// Energy of a soft hit's slow surprise over that of the usual hit, at least.
const SOFTEST: f64 = 0.1;
/// What comes this soon after a hit is of it \[s\].
const TOGETHER: f64 = 0.02;
/// Most hits that are used, the strongest.
const MOST: usize = 32;

/// A hit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// When \[s\].
    pub time: f64,
    /// First sample after it.
    pub(super) after: usize,
    /// First sample of it.
    pub(super) onset: usize,
    /// Energy of the surprise over that of noise.
    pub strength: f64,
}

/// The hits of a record, first to last, by the quick and the slow surprises of so many series.
///
/// They are sought in the quick surprises. One that leaves the slow ones as they were was no hit but what the quick prediction, which reaches back
/// over less than a period of a low mode, does not know of ringing.
pub(super) fn find(surprises: [Surprise; 2], series: usize, sampling: &Sampling, conditions: &Conditions) -> Vec<Hit> {
    let [step, far] = [surprises[0].step, surprises[1].step];
    let [quick, slow] = surprises.map(|surprise| energy(surprise, series, sampling, conditions));
    let confirmed = |onset: usize| {
        let sample = onset * step;
        let from = (sample / far).min(slow.len().saturating_sub(1));
        let to = (from + WINDOW).min(slow.len());
        // Where the slow prediction says nothing for clipped samples are all about, a hit is what begins after quiet.
        let silent = conditions.any_clipped(sample.saturating_sub(ORDER * far)..sample + 2 * WINDOW * far);
        let fresh = || !conditions.any_clipped(sample.saturating_sub((QUIET * sampling.rate) as usize)..sample);
        slow[from..to].iter().any(|energy| *energy > THRESHOLD) || silent && fresh()
    };
    let at = |hits: Vec<Hit>, step: usize| {
        let scaled =
            move |hit: Hit| Hit { onset: hit.onset * step, after: (hit.after * step).min(sampling.samples - 1), ..hit };
        hits.into_iter().map(scaled)
    };
    let mut hits: Vec<Hit> = at(between_edges(&quick, &sampling.every(step), confirmed), step).collect();
    // A soft hit has no part that is quick, and is no corner of a slow motion, which is far below the hits there are. Running means carry a
    // share of a hit to before it, and know little at the record's ends.
    let slow_part = |hit: &Hit| {
        let from = (hit.onset / far).min(slow.len().saturating_sub(1));
        slow[from..(from + 2 * WINDOW).min(slow.len())].iter().copied().fold(0.0, f64::max)
    };
    let mut parts: Vec<f64> = hits.iter().map(slow_part).collect();
    let usual = median(&mut parts);
    let near = (NEARBY * sampling.rate) as usize;
    let soft = at(between_edges(&slow, &sampling.every(far), |_| true), far)
        .filter(|soft| soft.onset > near && soft.onset + near < sampling.samples)
        .filter(|soft| soft.strength > SOFTEST * usual)
        .filter(|soft| hits.iter().all(|hit| hit.onset.abs_diff(soft.onset) > near));
    let soft: Vec<Hit> = soft.collect();
    hits.extend(soft);
    hits.sort_by_key(|hit| hit.onset);
    hits = one_each(&hits, (TOGETHER * sampling.rate) as usize);
    if hits.len() > MOST {
        hits.sort_by(|a, b| b.strength.total_cmp(&a.strength));
        hits.truncate(MOST);
        hits.sort_by_key(|hit| hit.onset);
    }
    hits
}

/// Hits that are one: its wave may reach the louder end later.
fn one_each(hits: &[Hit], together: usize) -> Vec<Hit> {
    let mut merged: Vec<Hit> = Vec::new();
    for hit in hits {
        match merged.last_mut() {
            Some(last) if hit.onset < last.onset + together => {
                last.after = hit.after;
                last.strength = last.strength.max(hit.strength);
            }
            _ => merged.push(*hit),
        }
    }
    merged
}

/// Lets what is fitted begin behind the logger's low-pass, and behind the last clipped sample of each hit.
pub(super) fn begin_behind(hits: &mut [Hit], sampling: &Sampling, conditions: &Conditions) {
    let response = conditions.low_pass.map_or(0, |corner| (RESPONSE / corner * sampling.rate) as usize);
    for index in 0..hits.len() {
        let end = hits.get(index + 1).map_or(sampling.samples - 1, |next| next.onset);
        let hit = &mut hits[index];
        let clipped = conditions.last_clipped(hit.onset..end).map_or(0, |last| last + 1);
        hit.after = (hit.after + response).max(clipped).min(end.max(hit.after));
    }
}

/// Energy of the surprises of all series over `WINDOW` samples, relative to that of noise.
fn energy(surprise: Surprise, series: usize, sampling: &Sampling, conditions: &Conditions) -> Vec<f64> {
    let expected = (WINDOW * series) as f64;
    let Surprise { step, mut squares } = surprise;
    conditions.leave_out_clipped(&mut squares, step, sampling.rate);
    let windows = (squares.len() + 1).saturating_sub(WINDOW);
    for index in 0..windows {
        squares[index] = squares[index..index + WINDOW].iter().sum::<f64>() / expected;
    }
    squares.truncate(windows);
    squares
}

/// How long a hit lasts \[samples\].
pub(super) fn lasting(sampling: &Sampling) -> usize {
    ((LASTING * sampling.rate) as usize).max(WINDOW)
}

/// How many samples at the beginning are not looked at: the first ones cannot be predicted either.
pub(super) fn first_looked_at(sampling: &Sampling) -> usize {
    (EDGE * sampling.rate) as usize + ORDER
}

/// The hits by the energy of the surprises over `WINDOW` samples.
fn between_edges(energy: &[f64], sampling: &Sampling, confirmed: impl Fn(usize) -> bool) -> Vec<Hit> {
    let samples = sampling.samples;
    let near = lasting(sampling);
    let mut hits: Vec<Hit> = Vec::new();
    let mut index = 0;
    while index < energy.len() {
        if energy[index] <= THRESHOLD {
            index += 1;
            continue;
        }
        // The surprise, as long as a hit lasts, and its largest part.
        let end = (index + near).min(energy.len());
        let peak = (index..end).fold(index, |best, n| if energy[n] > energy[best] { n } else { best });
        let strength = energy[peak];
        let echo_of = |hit: &Hit| {
            let since = (index - hit.onset) as f64 / sampling.rate;
            ECHOES.iter().any(|(louder, lasting)| since < *lasting && strength < louder * hit.strength)
        };
        let louder = hits.iter().rev().take_while(|hit| index - hit.onset < sampling.rate as usize).any(echo_of);
        if !louder && confirmed(index) {
            let after = (peak + near).min(samples - 1);
            hits.push(Hit { time: sampling.time(index + WINDOW - 1), after, onset: index, strength });
        }
        index = peak + near;
    }
    // Left out only now: what follows from what is at an edge is known as its echo.
    let looked_at = first_looked_at(sampling)..energy.len().saturating_sub((EDGE * sampling.rate) as usize);
    hits.retain(|hit| looked_at.contains(&hit.onset));
    hits
}
