//! A signal over frequency: amplitudes of its lines, power within a band, and where sampling folds a line to.
//!
//! Next door: what an instrument lets through (`crate::sensors::Readout`), a signal against its reference (`deviation`).

use crate::error::{Error, above_zero, all_bounded, check, count, entry, number_of};
use crate::measures::transform;
use crate::signals::increasing;

/// One-sided spectrum of a uniformly sampled series, tapered after Hann.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// From line to line \[Hz\].
    spacing: f64,
    mean: f64,
    amplitudes: Vec<f64>,
    /// Mean square that each line stands for, the mean taken out.
    powers: Vec<f64>,
}

impl Spectrum {
    /// Of `values` (any unit) at uniform `times` \[s\], both of shape `samples`, at least three.
    ///
    /// X_k = Σ w_n (x_n − mean) e^(−2πikn/N), w_n = ½(1 − cos(2πn/N)), line k at k f_s/N, k = 0…⌊N/2⌋;
    /// amplitude 2|X_k|/Σw (|X_k|/Σw at f_s/2), at 0 Hz |mean|; power 2|X_k|²/(N Σw²), half of it at 0 Hz and at f_s/2
    ///
    /// Source:   `[Harris1978]` table I (Hann: coherent gain 1/2, noise bandwidth 3/2 lines, scalloping 1.42 dB).
    /// Valid:    series that go on as they were: a transient is weighted by where in the window it lies.
    /// Accuracy: amplitude of a sine on a line 1e-12 relative, half way between two lines −1.42 dB; 1e-12 against the plain sum.
    ///
    /// # Errors
    /// [`Error::Count`] for fewer than three samples or series of different lengths; [`Error::Value`] for a value beyond 1e9 either
    /// way, or a time more than 1e-6 of the interval off its place.
    ///
    /// ```
    /// use coilsense::measures::Spectrum;
    ///
    /// let times: Vec<f64> = (0..1000).map(|n| f64::from(n) / 1000.0).collect();
    /// let values: Vec<f64> = times.iter().map(|t| 2.0 + 3.0 * (std::f64::consts::TAU * 54.0 * t).sin()).collect();
    /// let spectrum = Spectrum::of(&times, &values)?;
    /// assert!((spectrum.frequencies()[54] - 54.0).abs() < 1e-9);
    /// assert!((spectrum.amplitudes()[54] - 3.0).abs() < 1e-12);
    /// assert!((spectrum.rms_within(0.0, 500.0).powi(2) - (4.0 + 4.5)).abs() < 1e-12);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn of(times: &[f64], values: &[f64]) -> Result<Self, Error> {
        let interval = uniform_interval(times)?;
        count("values", values.len(), times.len())?;
        all_bounded("value", values, "")?;
        let samples = values.len() as f64;
        let mean = values.iter().map(|value| value / samples).sum::<f64>();
        let magnitudes = tapered_transform(values, mean)?;
        // Sums over the taper in closed form: Σw = N/2, Σw² = 3N/8 for N of three or more.
        let (gain, power) = (2.0 / samples, 8.0 / (3.0 * samples * samples));
        let twice = |line: usize| if line == 0 || 2 * line == values.len() { 1.0 } else { 2.0 };
        let lines = magnitudes.iter().enumerate();
        let mut amplitudes: Vec<f64> = lines.clone().map(|(line, x)| twice(line) * gain * x).collect();
        amplitudes[0] = mean.abs();
        let powers = lines.map(|(line, x)| twice(line) * power * x * x).collect();
        Ok(Self { spacing: 1.0 / (interval * samples), mean, amplitudes, powers })
    }

    /// Frequencies of the lines \[Hz\], shape `lines`.
    pub fn frequencies(&self) -> Vec<f64> {
        (0..self.amplitudes.len()).map(|line| line as f64 * self.spacing).collect()
    }

    /// Peak amplitude of the sine that each line stands for, in the unit of the values, shape `lines`; the mean's size at 0 Hz.
    pub fn amplitudes(&self) -> &[f64] {
        &self.amplitudes
    }

    /// Rms of what lies within a band \[Hz\], in the unit of the values; zero for a band without a line.
    ///
    /// √(Σ power of the lines with from ≤ f ≤ to, and mean² where 0 Hz is among them)
    ///
    /// A sine's power spreads over the lines beside its own: leave it two lines of room on either side. A bound that rounds to just
    /// beside a line (1e-6 of their spacing) still means that line.
    ///
    /// Source:   Parseval's theorem; `[Harris1978]` table I for the noise bandwidth, which the powers are divided by.
    /// Valid:    as [`Self::of`].
    /// Accuracy: a sine whose lines are in the band 1e-12 relative; white noise of 1e5 samples 1 %, since the taper weighs it.
    pub fn rms_within(&self, from: f64, to: f64) -> f64 {
        let (first, last) = (from / self.spacing - 1e-6, to / self.spacing + 1e-6);
        let within = |line: usize| (first..=last).contains(&(line as f64));
        let steady = if within(0) { self.mean * self.mean } else { 0.0 };
        let lines = self.powers.iter().enumerate().filter(|(line, _)| within(*line));
        (steady + lines.map(|(_, power)| power).sum::<f64>()).sqrt()
    }
}

/// |X_k| of the tapered deviations from the mean, shape `lines`.
fn tapered_transform(values: &[f64], mean: f64) -> Result<Vec<f64>, Error> {
    let samples = values.len();
    let turn = std::f64::consts::TAU / samples as f64;
    let taper = |index: usize| 0.5 * (1.0 - (turn * index as f64).cos());
    let tapered: Vec<f64> = values.iter().enumerate().map(|(n, value)| taper(n) * (value - mean)).collect();
    Ok(transform::forward(tapered)?.iter().map(|line| line.norm()).collect())
}

/// Time from sample to sample \[s\] of a uniform series.
fn uniform_interval(times: &[f64]) -> Result<f64, Error> {
    let samples = times.len();
    if samples < 3 {
        return Err(number_of("times", samples, "at least 3"));
    }
    let (first, last) = (increasing(times)?[0], times[samples - 1]);
    let interval = (last - first) / (samples - 1) as f64;
    above_zero("interval of the times", interval, "s")?;
    let digits = 4.0 * f64::EPSILON * first.abs().max(last.abs());
    let off = |index: usize| (times[index] - (first + index as f64 * interval)).abs() > 1e-6 * interval + digits;
    match (0..samples).find(|&index| off(index)) {
        None => Ok(interval),
        Some(index) => {
            let allowed = format!("uniform, {} s here", first + index as f64 * interval);
            check(false, entry("time", index), times[index], "s", allowed)
        }
    }
}

/// Where a line shows after sampling \[Hz\]: folded into 0 to f_s/2.
///
/// |f − f_s round(f/f_s)|
///
/// - `frequency`: f, `sample_rate`: f_s, above zero \[Hz\]
///
/// Source:   `[Oppenheim2010]` section 4.2.
/// Valid:    sampling at uniform times; f and f_s finite.
/// Accuracy: 2e-16 of f.
///
/// ```
/// // Sampled at 100 Hz, a surge line at 54 Hz shows at 46 Hz and its fourth harmonic at 16 Hz.
/// assert_eq!(coilsense::measures::alias_of(54.0, 100.0), 46.0);
/// assert_eq!(coilsense::measures::alias_of(216.0, 100.0), 16.0);
/// ```
pub fn alias_of(frequency: f64, sample_rate: f64) -> f64 {
    (frequency - sample_rate * (frequency / sample_rate).round()).abs()
}
