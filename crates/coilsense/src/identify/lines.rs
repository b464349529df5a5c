//! Lines that ring: peaks of the spectra after hits, each sought with the window that suits how fast it decays.
//!
//! Next door: the hits (`hits`), the exact fit that starts from these lines (`refine`), lines of a record without hits (`welch`).

use realfft::RealFftPlanner;

use super::hits::Hit;
use super::ringing::Series;
use super::sampling::Sampling;
use super::welch::{Welch, floor};

/// Shortest window \[s\], and the factor from one to the next.
const SHORTEST: f64 = 0.04;
/// Longest window \[s\].
const LONGEST: f64 = 10.0;
/// Peaks fall on both sides by at least this factor of power before a higher one comes.
const PROMINENCE: f64 = 4.0;
/// Of a window's best length: e-folding time of the line's amplitude over the window's length (largest ratio of line to noise).
const FOLDS: f64 = 0.55;
/// Resolved lines over which the flank of a strong line is taken, at least.
const CELLS: usize = 16;
/// Most lines per series.
const MOST: usize = 40;

/// A line as a spectrum shows it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Peak {
    /// Which series.
    pub(super) series: usize,
    /// Hz.
    pub(super) frequency: f64,
    /// e-folding time of its amplitude \[s\], roughly; infinite where it does not decay.
    pub(super) folding: f64,
    /// Power over that of the noise.
    pub(super) strength: f64,
    /// Amplitude of a steady line, in the series' unit; zero for others.
    pub(super) amplitude: f64,
}

/// Peaks of one series after hits, the strongest first.
pub(super) fn after_hits(index: usize, series: &Series, hits: &[Hit], sampling: &Sampling) -> Vec<Peak> {
    let mut all = Vec::new();
    let mut seconds = SHORTEST.max(24.0 / sampling.rate);
    let mut planner = RealFftPlanner::new();
    while seconds <= LONGEST.min(0.5 * sampling.duration()) {
        let length = (seconds * sampling.rate) as usize;
        all.extend(at_scale(index, series, hits, length, sampling, &mut planner));
        seconds *= 1.6;
    }
    all.sort_by(|a: &(Peak, f64), b| b.0.strength.total_cmp(&a.0.strength));
    let mut kept: Vec<(Peak, f64)> = Vec::new();
    for (peak, width) in all {
        // One line shows at several scales; the best has been kept.
        let known = kept.iter().any(|(other, of)| (other.frequency - peak.frequency).abs() < 1.5 * width.max(*of));
        if !known && kept.len() < MOST {
            kept.push((peak, width));
        }
    }
    kept.into_iter().map(|(peak, _)| peak).collect()
}

/// Peaks of the power averaged over all hits that have room for a window of this length, each with the spectrum's resolution.
fn at_scale(
    index: usize,
    series: &Series,
    hits: &[Hit],
    length: usize,
    sampling: &Sampling,
    planner: &mut RealFftPlanner<f64>,
) -> Vec<(Peak, f64)> {
    let (rate, noise) = (sampling.rate, series.noise);
    let next = |index: usize| hits.get(index + 1).map_or(sampling.samples, |hit| hit.onset);
    let starts: Vec<usize> =
        (0..hits.len()).filter(|&i| hits[i].after + length <= next(i)).map(|i| hits[i].after).collect();
    if starts.is_empty() || length < 8 {
        return Vec::new();
    }
    // Full where the ringing begins, nothing where the window ends: no side lobes, and no loss of what rings.
    let quarter = std::f64::consts::FRAC_PI_2 / length as f64;
    let taper: Vec<f64> = (0..length).map(|n| (quarter * n as f64).cos().powi(2)).collect();
    let padded = (2 * length).next_power_of_two();
    let transform = planner.plan_fft_forward(padded);
    let (mut input, mut output) = (transform.make_input_vec(), transform.make_output_vec());
    let mut power = vec![0.0; padded / 2 + 1];
    for &start in &starts {
        input.fill(0.0);
        for ((y, x), w) in input.iter_mut().zip(series.flat(start..start + length)).zip(&taper) {
            *y = x * w;
        }
        if transform.process(&mut input, &mut output).is_ok() {
            power.iter_mut().zip(&output).for_each(|(sum, line)| *sum += line.norm_sqr() / starts.len() as f64);
        }
    }
    let white = noise * noise * taper.iter().map(|w| w * w).sum::<f64>();
    let spacing = rate / padded as f64;
    let threshold = rare(starts.len());
    // On the flank of a strong line the ripple is the flank's, not the noise's.
    let between = floor(&power, CELLS * padded / length);
    peaks(&power, PROMINENCE)
        .into_iter()
        .filter_map(|(line, place)| {
            let strength = power[line] / white.max(f64::MIN_POSITIVE);
            let stands_out = power[line] > threshold * white.max(between[line]);
            // Below two turns within the window it is drift.
            let swings = place * spacing * length as f64 / rate > 2.0;
            let peak = Peak {
                series: index,
                frequency: place * spacing,
                folding: FOLDS * length as f64 / rate,
                strength: strength * starts.len() as f64,
                amplitude: 0.0,
            };
            (stands_out && swings).then_some((peak, rate / length as f64))
        })
        .collect()
}

/// Peaks of a record without hits, of lines far above what is between them, the strongest first; and the spectrum.
pub(super) fn steady(index: usize, series: &Series, sampling: &Sampling) -> (Vec<Peak>, Welch) {
    let length = (sampling.samples / 8).max(64).min(sampling.samples);
    let welch = Welch::of_stretches(&|range| series.flat(range), sampling.samples, sampling.rate, length);
    let between = floor(&welch.density, 12);
    let threshold = 2.0 * rare(welch.segments.div_ceil(2).max(1));
    let mut found: Vec<Peak> = peaks(&welch.density, PROMINENCE)
        .into_iter()
        .filter_map(|(line, place)| {
            let strength = welch.density[line] / between[line].max(f64::MIN_POSITIVE);
            // A Hann-tapered line of amplitude a has the density a²/(3 Δf).
            let amplitude = (3.0 * welch.spacing * welch.density[line]).sqrt();
            let frequency = place * welch.spacing;
            let peak = Peak { series: index, frequency, folding: f64::INFINITY, strength, amplitude };
            (strength > threshold && place > 4.0).then_some(peak)
        })
        .collect();
    found.sort_by(|a, b| b.strength.total_cmp(&a.strength));
    found.truncate(MOST);
    (found, welch)
}

/// What the mean of n exponentially distributed powers exceeds once in some millions (Wilson and Hilferty's cube root).
fn rare(count: usize) -> f64 {
    let ninth = 1.0 / (9.0 * count as f64);
    (1.0 - ninth + 5.2 * ninth.sqrt()).powi(3)
}

/// Lines from which the power falls on both sides by a factor before a higher line comes, each with its place between lines.
fn peaks(power: &[f64], prominence: f64) -> Vec<(usize, f64)> {
    let mut found = Vec::new();
    // Walk up and down: a maximum counts once the power has fallen, a minimum once it has risen.
    let (mut low, mut high, mut rising) = (f64::INFINITY, (0, 0.0), true);
    for (line, &value) in power.iter().enumerate() {
        if rising {
            if value > high.1 {
                high = (line, value);
            }
            low = f64::min(low, value);
            if value * prominence < high.1 {
                if high.0 > 0 && high.0 + 1 < power.len() {
                    found.push((high.0, vertex(power, high.0)));
                }
                (rising, low) = (false, value);
            }
        } else {
            low = low.min(value);
            if value > prominence * low {
                (rising, high) = (true, (line, value));
            }
        }
    }
    found
}

/// Place of a peak between lines, by a parabola through the logarithms.
fn vertex(power: &[f64], line: usize) -> f64 {
    let of = |line: usize| power[line].max(f64::MIN_POSITIVE).ln();
    let (before, here, after) = (of(line - 1), of(line), of(line + 1));
    let bend = before - 2.0 * here + after;
    let shift = if bend < 0.0 { 0.5 * (before - after) / bend } else { 0.0 };
    line as f64 + shift.clamp(-0.5, 0.5)
}
