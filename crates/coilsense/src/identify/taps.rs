//! Taps: the moments at which something struck the spring, found in what its past does not foretell.
//!
//! Next door: the prediction (`whitening`), what rings after them (`lines`, `refine`).

use super::sampling::Sampling;

/// Samples over which a surprise is added up.
const WINDOW: usize = 4;
/// How many times the energy of noise a tap has.
const THRESHOLD: f64 = 9.0;
/// What echoes of a tap stay below, relative to it, and for how long \[s\]: the wave runs to and fro, and a hammer bounces.
const ECHOES: [(f64, f64); 2] = [(2.0, 0.06), (0.5, 0.25)];
/// How long a tap may last \[s\].
const LASTING: f64 = 0.004;
/// Most taps that are used, the strongest.
const MOST: usize = 32;

/// A tap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tap {
    /// When \[s\].
    pub time: f64,
    /// First sample after it.
    pub(super) after: usize,
    /// First sample of it.
    pub(super) onset: usize,
    /// Energy of the surprise over that of noise.
    pub strength: f64,
}

/// The taps of a record, first to last, by each series' surprises (`innovations`).
pub(super) fn find(surprises: &[&[f64]], sampling: &Sampling) -> Vec<Tap> {
    let samples = sampling.samples;
    let square = |index: usize| surprises.iter().map(|e| e[index] * e[index]).sum::<f64>();
    let squares: Vec<f64> = (0..samples).map(square).collect();
    let expected = (WINDOW * surprises.len()) as f64;
    let energy: Vec<f64> = squares.windows(WINDOW).map(|window| window.iter().sum::<f64>() / expected).collect();
    let near = ((LASTING * sampling.rate) as usize).max(WINDOW);
    let mut taps: Vec<Tap> = Vec::new();
    let mut index = 0;
    while index < energy.len() {
        if energy[index] <= THRESHOLD {
            index += 1;
            continue;
        }
        // The surprise, as long as a tap lasts, and its largest part.
        let end = (index + near).min(energy.len());
        let peak = (index..end).fold(index, |best, n| if energy[n] > energy[best] { n } else { best });
        let strength = energy[peak];
        let echo_of = |tap: &Tap| {
            let since = (index - tap.onset) as f64 / sampling.rate;
            ECHOES.iter().any(|(louder, lasting)| since < *lasting && strength < louder * tap.strength)
        };
        let louder = taps.iter().rev().take_while(|tap| index - tap.onset < sampling.rate as usize).any(echo_of);
        if !louder {
            let after = (peak + near).min(samples - 1);
            taps.push(Tap { time: sampling.time(index + WINDOW - 1), after, onset: index, strength });
        }
        index = peak + near;
    }
    if taps.len() > MOST {
        taps.sort_by(|a, b| b.strength.total_cmp(&a.strength));
        taps.truncate(MOST);
        taps.sort_by_key(|tap| tap.onset);
    }
    taps
}
