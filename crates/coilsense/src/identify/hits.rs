//! Hits: the moments at which something struck the spring, found in what its past does not predict.
//!
//! Next door: the prediction (`whitening`), a record that begins with ringing (`beginning`), what rings after them (`lines`, `refine`).

use super::ringing::Series;
use super::sampling::Sampling;
use super::whitening::ORDER;

/// Samples over which a surprise is added up.
const WINDOW: usize = 4;
/// How many times the energy of noise a hit has.
const THRESHOLD: f64 = 9.0;
/// What echoes of a hit stay below, relative to it, and for how long \[s\]: the wave runs to and fro, and a hammer bounces. The first time
/// that it comes back to an end, the force jumps by twice what it jumped at the hit: four times the energy.
const ECHOES: [(f64, f64); 2] = [(5.0, 0.06), (0.5, 0.25)];
/// What prediction leaves of ringing at most, as a share of the largest force that rings nearby: a filter of finite length does not know
/// all modes, and running means carry a share of a hit to before it. Where a sensor's noise is less, this is what hits have to exceed.
const LEFT: f64 = 0.02;
/// How near that is, at least \[s\]: as far as the running means reach.
const NEARBY: f64 = 0.4;
/// How far from both ends of a record hits are looked for \[s\]: there the running means have few samples left, and a hit could not be told
/// from its echoes.
const EDGE: f64 = 0.06;
/// How long a hit may last \[s\].
const LASTING: f64 = 0.004;
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

/// The hits of a record, first to last, by each series' surprises (`innovations`).
pub(super) fn find(series: &[Series], sampling: &Sampling) -> Vec<Hit> {
    let squares = squares(series, sampling);
    let expected = (WINDOW * series.len()) as f64;
    let energy: Vec<f64> = squares.windows(WINDOW).map(|window| window.iter().sum::<f64>() / expected).collect();
    let mut hits = between_edges(&energy, sampling);
    if hits.len() > MOST {
        hits.sort_by(|a, b| b.strength.total_cmp(&a.strength));
        hits.truncate(MOST);
        hits.sort_by_key(|hit| hit.onset);
    }
    hits
}

/// Squares of the surprises of all series, each over its noise or over what prediction leaves of ringing, whichever is more; shape `samples`.
fn squares(series: &[Series], sampling: &Sampling) -> Vec<f64> {
    let block = ((NEARBY * sampling.rate) as usize).max(1);
    let mut sum = vec![0.0; sampling.samples];
    for one in series {
        let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let of_blocks: Vec<f64> = one.flat.chunks(block).map(largest).collect();
        for (index, (sum, surprise)) in sum.iter_mut().zip(&one.surprise).enumerate() {
            let own = index / block;
            let nearby = largest(&of_blocks[own.saturating_sub(1)..(own + 2).min(of_blocks.len())]);
            let share = if LEFT * nearby > one.noise { one.noise / (LEFT * nearby) } else { 1.0 };
            *sum += (share * surprise).powi(2);
        }
    }
    sum
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
fn between_edges(energy: &[f64], sampling: &Sampling) -> Vec<Hit> {
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
        if !louder {
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
