//! How far the clocks of two devices are apart that recorded the same motion, and how far they drift apart.
//!
//! Next door: one signal over frequency (`spectrum`); who joins two logs is `coilsense-lab`.

use std::sync::Arc;

use num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner};

use crate::error::{Error, above_zero, all_bounded, check, count};
use crate::uncertainty::coverage_factor;

mod band;
mod coarse;
mod drift;
mod warp;

/// What a device's clock lacks against another's, found in a signal that both have recorded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClockOffset {
    /// Seconds to add to the second device's times so that they are the first's, at `at` \[s\].
    pub offset: f64,
    /// Half of the interval that holds it there with 95 % \[s\].
    pub half_width: f64,
    /// On the second device's clock \[s\]: the middle of what tells the offset.
    pub at: f64,
    /// How much the offset grows; none where the record does not tell it to 100 ppm, what two crystals may differ by.
    pub drift: Option<ClockDrift>,
    /// Correlation of both signals with it, −1 to 1: below zero where one of them has the other sign.
    pub correlation: f64,
}

/// How much faster the first device's clock runs than the second's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClockDrift {
    /// Seconds that the offset grows by in each second of the second device's clock \[1\].
    pub rate: f64,
    /// Half of the interval that holds it with 95 % \[1\].
    pub half_width: f64,
}

/// Fewest samples that both must have in common.
pub(super) const FEWEST: usize = 256;
/// Half of an offset's interval over the record, at most \[1\]: beyond, the signals do not tell it.
const SHARE: f64 = 0.02;
/// Share of the speed's square that no straight line over time takes away, at least \[1\], and the means by which it is judged.
const TURNING: f64 = 0.5;
const MEANS: usize = 24;
/// Parts of the record whose scatter tells the interval.
const PARTS: usize = 20;

impl ClockOffset {
    /// What is to be added to a time of the second device so that it is the first's \[s\]: offset + drift (t − at).
    pub fn added(&self, time: f64) -> f64 {
        self.offset + self.drift.map_or(0.0, |drift| drift.rate) * (time - self.at)
    }

    /// The second device's time at the first's `time` \[s\]: what [`Self::added`] is turned round.
    pub fn of_second(&self, time: f64) -> f64 {
        let rate = self.drift.map_or(0.0, |drift| drift.rate);
        self.at + (time - self.offset - self.at) / (1.0 + rate)
    }

    /// Half of the interval that holds [`Self::added`] with 95 % \[s\], √(u_o² + (u_d (t − at))²); an unknown drift counts as up to 100 ppm.
    pub fn half_width_at(&self, time: f64) -> f64 {
        let drift = self.drift.map_or(drift::CRYSTALS, |drift| drift.half_width);
        self.half_width.hypot(drift * (time - self.at))
    }

    /// From two records of one signal, shapes `first samples` and `second samples`, each at least 256, both at `interval` \[s\]; the records
    /// start at `starts` \[s\] on their own clocks. Gain and sign may differ.
    ///
    /// Coarsely the whole ℓ of the largest −K_ℓ ln(1 − ρ_ℓ²), ρ the correlation of the K samples that overlap; then Σ ψ = 0 with ψ = ½(b a' − a b') of both signals behind one
    /// low-pass, a' and b' their derivatives: noise of either device has no part in its mean. u² = Σ_k (Σ_k ψ)² K/(K−1)/(Σ a'b')² over
    /// K = 20 parts, with Student's t of as many parts as carry the motion. With a drift the lag is ℓ + s (i − ī), ī = Σ i a'b'/Σ a'b':
    /// Σ ψ = 0 and Σ ψ (i − ī) = 0, begun at the line through the correlations of 32 blocks; drift = −s/(1 + s).
    ///
    /// Source:   the time-delay estimator of maximum likelihood for white noise, `[Knapp1976]`; variance by batches (`[Carter1987]` for its bound).
    /// Valid:    motions that do not repeat themselves, noise independent between the devices, drifts up to 200 ppm that stay the same.
    /// Accuracy: 1e-4 of a sample for sums of sines without noise; drifts of 600 s in a tenth of noise to 0.2 ppm; coverage of the intervals
    ///           93 to 99 % over steady shaking, hits and slow motion in noise (tests: at least the lower 99 % bound of 95 %).
    /// Differs:  the cut of the low-pass is the highest line at which both are coherent, in place of a weight per line: short of data, weights
    ///           are noise themselves.
    ///
    /// # Errors
    /// [`Error::Count`] for too few samples; [`Error::Value`] for an interval not above zero, a value beyond 1e9, signals that do not
    /// resemble each other, or that do so at several offsets.
    ///
    /// ```
    /// use coilsense::measures::ClockOffset;
    ///
    /// let motion = |t: f64| (40.0 * t).sin() * (-t).exp() + (13.0 * t).cos() * (-(t - 3.0).powi(2)).exp();
    /// let record = |late: f64| (0..2000).map(|n| motion(0.005 * f64::from(n) - late)).collect::<Vec<f64>>();
    /// let found = ClockOffset::between(&record(0.0), &record(0.3), [0.0, 0.0], 0.005)?;
    /// assert!((found.offset + 0.3).abs() < 1e-4, "{found:?}");
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn between(first: &[f64], second: &[f64], starts: [f64; 2], interval: f64) -> Result<Self, Error> {
        above_zero("interval", interval, "s")?;
        for values in [first, second] {
            all_bounded("value", values, "")?;
            check(values.len() >= FEWEST, "samples", values.len() as f64, "", format!("at least {FEWEST}"))?;
        }
        let coarse = coarse::lag(first, second)?;
        let (from, to) = coarse.overlap(first.len(), second.len());
        let a = straightened(&first[from..to]);
        let shifted = |index: usize| (index as i64 + coarse.lag) as usize;
        let b = straightened(&second[shifted(from)..shifted(to)]);
        count("second", b.len(), a.len())?;
        let (fine, drift) = match drift::line(&a, &b)? {
            Some(line) => {
                // The lag counts the first device's seconds, the drift the second's.
                let once = 1.0 + line.slope;
                let drift = ClockDrift { rate: -line.slope / once, half_width: line.slope_half / (once * once) };
                (Fine { lag: line.lag, half_width: line.lag_half, centre: line.centre }, Some(drift))
            }
            None => (refined(&a, &b)?, None),
        };
        let turns = turning(&a);
        check(
            turns >= TURNING,
            "share of the motion that is no parabola",
            turns,
            "",
            "at least 0.5: a parabola that is late looks like one that is tilted",
        )?;
        let told = fine.half_width <= SHARE * a.len() as f64;
        let half_width = fine.half_width * interval;
        check(
            told,
            "half-width of the offset",
            half_width,
            "s",
            "at most a fiftieth of the record: the signals hardly tell it",
        )?;
        let offset = starts[0] - starts[1] - (coarse.lag as f64 + fine.lag) * interval;
        Ok(Self {
            offset,
            half_width,
            at: starts[0] + (from as f64 + fine.centre) * interval - offset,
            drift,
            correlation: coarse.correlation,
        })
    }
}

/// A lag \[samples\].
struct Fine {
    lag: f64,
    half_width: f64,
    /// Of the information.
    centre: f64,
}

/// Share of a signal's speed, squared, that is no straight line over time \[1\]: what of a delay is left when slow trends are taken out.
fn turning(a: &[f64]) -> f64 {
    let part = a.len() / MEANS;
    let means: Vec<f64> = a.chunks_exact(part).map(|part| part.iter().sum::<f64>()).collect();
    let speeds: Vec<f64> = means.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let all: f64 = speeds.iter().map(|speed| speed * speed).sum();
    let left: f64 = straightened(&speeds).iter().map(|speed| speed * speed).sum();
    if all > 0.0 { left / all } else { 1.0 }
}

/// The lag of b behind a, which is within a few samples.
fn refined(a: &[f64], b: &[f64]) -> Result<Fine, Error> {
    let cut = band::coherent(a, b)?;
    let (a, b) = (Filtered::of(a, cut)?, Filtered::of(b, cut)?);
    let edge = (a.samples / 20).max(1);
    let (value_a, slope_a) = a.shifted(0.0)?;
    let mut lag = 0.0;
    let mut terms = (Vec::new(), Vec::new());
    for _ in 0..12 {
        let (value_b, slope_b) = b.shifted(lag)?;
        let inner = edge..a.samples - edge;
        terms =
            inner.map(|i| (0.5 * (value_b[i] * slope_a[i] - value_a[i] * slope_b[i]), slope_a[i] * slope_b[i])).unzip();
        let step = terms.0.iter().sum::<f64>() / terms.1.iter().sum::<f64>();
        check(step.is_finite(), "correlation", 0.0, "", "above zero where the signals move")?;
        lag -= step;
        if step.abs() < 1e-10 {
            break;
        }
    }
    check(
        lag.abs() <= 0.25 / cut + 2.0,
        "lag",
        lag,
        "samples",
        "near that of the largest correlation: the noise is too large",
    )?;
    let part = terms.0.len() / PARTS;
    let sums =
        |terms: &[f64]| -> Vec<f64> { terms.chunks_exact(part).take(PARTS).map(|part| part.iter().sum()).collect() };
    let (scores, weights) = (sums(&terms.0), sums(&terms.1));
    let total: f64 = weights.iter().sum();
    let scatter: f64 = scores.iter().map(|score| score * score).sum();
    let effective = total * total / weights.iter().map(|weight| weight * weight).sum::<f64>();
    let factor = coverage_factor(0.95, (effective - 1.0).clamp(1.0, PARTS as f64 - 1.0))?;
    let parts = PARTS as f64;
    let all: f64 = terms.1.iter().sum();
    let centre = terms.1.iter().enumerate().map(|(index, weight)| (edge + index) as f64 * weight).sum::<f64>() / all;
    Ok(Fine { lag, half_width: factor * (scatter * parts / (parts - 1.0)).sqrt() / total.abs(), centre })
}

/// A signal behind the low-pass, over frequency.
struct Filtered {
    samples: usize,
    padded: usize,
    lines: Vec<Complex64>,
    inverse: Arc<dyn ComplexToReal<f64>>,
}

impl Filtered {
    /// `cut` in cycles a sample.
    fn of(values: &[f64], cut: f64) -> Result<Self, Error> {
        let padded = (2 * values.len()).next_power_of_two();
        let mut input = values.to_vec();
        input.resize(padded, 0.0);
        let mut lines = transform(&mut input)?;
        for (line, value) in lines.iter_mut().enumerate() {
            *value *= low_pass(line as f64 / padded as f64, cut) / padded as f64;
        }
        Ok(Self { samples: values.len(), padded, lines, inverse: RealFftPlanner::new().plan_fft_inverse(padded) })
    }

    /// Values and slopes per sample at times later by `lag` samples.
    fn shifted(&self, lag: f64) -> Result<(Vec<f64>, Vec<f64>), Error> {
        let angle = |line: usize| std::f64::consts::TAU * line as f64 / self.padded as f64;
        let turned = self.lines.iter().enumerate().map(|(line, x)| x * Complex64::cis(angle(line) * lag));
        let turned: Vec<Complex64> = turned.collect();
        let slopes = turned.iter().enumerate().map(|(line, x)| x * Complex64::new(0.0, angle(line))).collect();
        Ok((self.back(turned)?, self.back(slopes)?))
    }

    fn back(&self, mut lines: Vec<Complex64>) -> Result<Vec<f64>, Error> {
        // A real series has real first and last lines.
        for end in [0, lines.len() - 1] {
            lines[end].im = 0.0;
        }
        let mut values = vec![0.0; self.padded];
        let done = self.inverse.process(&mut lines, &mut values);
        check(done.is_ok(), "samples", self.padded as f64, "", "a length that can be transformed")?;
        values.truncate(self.samples);
        Ok(values)
    }
}

/// One below the cut, none from one and a half times it on, half a cosine between; nothing near half the sample rate, where
/// interpolation between samples is not true.
fn low_pass(frequency: f64, cut: f64) -> f64 {
    if frequency > 0.45 || frequency >= 1.5 * cut {
        0.0
    } else if frequency <= cut {
        1.0
    } else {
        0.5 + 0.5 * (std::f64::consts::PI * (frequency - cut) / (0.5 * cut)).cos()
    }
}

/// Lines of a series.
fn transform(values: &mut [f64]) -> Result<Vec<Complex64>, Error> {
    let plan = RealFftPlanner::new().plan_fft_forward(values.len());
    let mut lines = plan.make_output_vec();
    let done = plan.process(values, &mut lines);
    check(done.is_ok(), "samples", values.len() as f64, "", "a length that can be transformed")?;
    Ok(lines)
}

/// Without mean and drift.
fn straightened(values: &[f64]) -> Vec<f64> {
    let centre = 0.5 * (values.len() as f64 - 1.0);
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let (mut slope, mut norm) = (0.0, 0.0);
    for (index, value) in values.iter().enumerate() {
        let place = index as f64 - centre;
        slope += place * (value - mean);
        norm += place * place;
    }
    let slope = if norm > 0.0 { slope / norm } else { 0.0 };
    values.iter().enumerate().map(|(index, value)| value - mean - slope * (index as f64 - centre)).collect()
}
