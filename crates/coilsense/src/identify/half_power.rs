//! Damping from the width of a line at half its power, where the record can carry it.
//!
//! Next door: the ring-down fit, which needs no resolution (`refine`).

use realfft::RealFftPlanner;

use super::hits::Hit;
use super::ringing::Series;
use super::sampling::Sampling;
use super::value::Estimate;
use crate::uncertainty::coverage_factor;

/// Lines of the transform that a width must span.
const LEAST_LINES: f64 = 3.0;
/// Fewest hits, each left out in turn for the interval.
const LEAST_HITS: usize = 3;
/// What the power at the peak must be over that of the noise.
const LEAST_POWER: f64 = 30.0;

/// ζ from the width of the power spectrum of a ring-down at half its height.
///
/// ζ = Δf/2f: the transform of A e^(λt) from the hit on has the power |A|²/((ω − ω_d)² + σ²), whose half is at ω_d ± σ
///
/// The spectra after all hits are averaged; leaving out each hit in turn gives the interval (jackknife, Student's t).
///
/// - `folding`: 1/σ \[s\] and `frequency`: f \[Hz\], roughly, from the ring-down fit
///
/// Source:   `[Ewins2000]` section 4.3 (peak amplitude method), here on free decay, where it is exact.
/// Valid:    stretches of eight e-foldings and more (the cut tail is e^(−8)), a line far from others: one nearby adds to its foot.
/// Accuracy: `tests/identify`: within its intervals of the ring-down fit's ζ.
///
/// A text says why the record cannot carry it.
pub(super) fn ratio(
    series: &Series,
    hits: &[Hit],
    sampling: &Sampling,
    frequency: f64,
    folding: f64,
) -> Result<Estimate, String> {
    let width = 1.0 / (std::f64::consts::PI * folding);
    let needed = 8.0 * folding;
    if !needed.is_finite() {
        return Err("the line does not decay".to_owned());
    }
    let length = (needed * sampling.rate).ceil() as usize;
    let room = |index: usize| {
        hits.get(index + 1).map_or(sampling.samples, |hit| hit.onset) - hits[index].after.min(sampling.samples)
    };
    let starts: Vec<usize> = (0..hits.len())
        .filter(|&index| hits[index].after < sampling.samples && room(index) >= length)
        .map(|index| hits[index].after)
        .collect();
    if starts.len() < LEAST_HITS {
        return Err(format!(
            "the width of {} Hz needs at least {LEAST_HITS} hits with {} s of quiet after each, {} here",
            short(width),
            short(needed),
            starts.len()
        ));
    }
    let neighbour = 0.5 * frequency;
    if 4.0 * width > neighbour {
        return Err(format!("the width of {} Hz reaches into the lines beside it", short(width)));
    }
    let powers = spectra(series, &starts, length);
    let spacing = sampling.rate / (padded(length)) as f64;
    let noise = series.noise * series.noise * length as f64;
    let of = |without: Option<usize>| half_width(&powers, without, spacing, frequency, width, noise);
    let all = of(None).ok_or("the line does not stand out enough of the noise")?;
    if all * sampling.rate.recip() * length as f64 <= LEAST_LINES * 0.5 {
        return Err(format!("the width of {} Hz is below the resolution", short(all)));
    }
    let ones: Vec<f64> = (0..starts.len()).filter_map(|index| of(Some(index))).collect();
    if ones.len() < starts.len() {
        return Err("the line does not stand out enough of the noise".to_owned());
    }
    let count = ones.len() as f64;
    let mean = ones.iter().sum::<f64>() / count;
    let variance = (count - 1.0) / count * ones.iter().map(|one| (one - mean).powi(2)).sum::<f64>();
    let factor = coverage_factor(0.95, count - 1.0).map_err(|error| error.to_string())?;
    Ok(Estimate::new(0.5 * all / frequency, 0.5 * variance.sqrt() / frequency, factor))
}

fn padded(length: usize) -> usize {
    (8 * length).next_power_of_two()
}

/// Power of each stretch over frequency, finely interpolated; shape `stretches` of `lines`.
fn spectra(series: &Series, starts: &[usize], length: usize) -> Vec<Vec<f64>> {
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(padded(length));
    let mut output = transform.make_output_vec();
    let mut one = |start: &usize| {
        let mut input = transform.make_input_vec();
        input[..length].copy_from_slice(&series.flat(*start..*start + length));
        // Its length is the plan's own.
        match transform.process(&mut input, &mut output) {
            Ok(()) => output.iter().map(|line| line.norm_sqr()).collect(),
            Err(_) => vec![0.0; output.len()],
        }
    };
    starts.iter().map(&mut one).collect()
}

/// Width at half power \[Hz\] of the mean of all spectra but one.
fn half_width(
    powers: &[Vec<f64>],
    without: Option<usize>,
    spacing: f64,
    frequency: f64,
    width: f64,
    noise: f64,
) -> Option<f64> {
    let count = powers.len() - usize::from(without.is_some());
    let taken = || powers.iter().enumerate().filter(|(index, _)| Some(*index) != without);
    let at = |line: usize| {
        taken().map(|(_, power)| power.get(line).copied().unwrap_or(0.0)).sum::<f64>() / count as f64 - noise
    };
    let from = (((frequency - 2.0 * width) / spacing) as usize).max(1);
    let to = ((frequency + 2.0 * width) / spacing) as usize + 1;
    let peak = (from..=to).max_by(|&a, &b| at(a).total_cmp(&at(b)))?;
    let top = at(peak);
    if top < LEAST_POWER * noise {
        return None;
    }
    let crossing = |step: isize| {
        let mut line = peak;
        for _ in 0..(20.0 * width / spacing) as usize + 20 {
            let next = line.checked_add_signed(step)?;
            let (here, there) = (at(line), at(next));
            if there < 0.5 * top {
                let part = (here - 0.5 * top) / (here - there);
                return Some(line as f64 + part * step as f64);
            }
            line = next;
        }
        None
    };
    Some((crossing(1)? - crossing(-1)?) * spacing)
}

fn short(value: f64) -> String {
    let digits = (2 - value.abs().max(1e-12).log10().floor() as i32).clamp(0, 6) as usize;
    format!("{value:.digits$}")
}
