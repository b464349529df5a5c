//! The sine that a record mostly is: its frequency, and how far to trust that.
//!
//! Next door: a whole spectrum (`spectrum`), decaying lines (`crate::identify`).

use std::f64::consts::TAU;

use nalgebra::{SMatrix, SVector};

use super::spectrum::Spectrum;
use crate::error::{Error, all_bounded, check, count};
use crate::uncertainty::coverage_factor;

/// The strongest sine of a record, and the lowest sine of which it may be a harmonic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinusoid {
    /// f \[Hz\], of the strongest line; from 0 Hz to half the sampling rate.
    pub frequency: f64,
    /// Half of the interval that holds it with 95 % \[Hz\].
    pub half_width: f64,
    /// Of that line, in the record's unit.
    pub amplitude: f64,
    /// Its part of the record's mean square, mean and straight trend left out \[1\].
    pub share: f64,
    /// Which harmonic of the lowest line it is: 1 where it is that line itself.
    pub harmonic: u32,
}

/// Fewest samples and periods of a fit.
const FEWEST: usize = 64;
const PERIODS: f64 = 2.0;
/// Parts of the record whose scatter tells the interval.
const PARTS: usize = 20;
/// Highest harmonic that the strongest line is looked at as, and the least amplitude of the fundamental then, in that of the line.
const HARMONICS: u32 = 6;
const LEAST: f64 = 0.05;
/// What rounding makes of a record that does not move.
const ROUNDING: f64 = 1e-10;
/// A line is one where its amplitude is so many times the spectrum's median.
const CLEAR: f64 = 8.0;

impl Sinusoid {
    /// Of `values` at even `times` \[s\] of shape `samples`, at least 64; none where no line with two periods or more stands out of the rest.
    ///
    /// Least squares of c + d t + A cos 2πft + B sin 2πft in c, d, A, B and f, begun at the highest line of a Hann spectrum.
    /// u_f² = Σ_k (Σ_k r g)² K/(K−2)/(Σ g²)² over K = 20 parts: r what is left, g the derivative in f that the others do not explain.
    ///
    /// It is the n-th harmonic where there is a line at f/n, too: of a twentieth of its amplitude or more, and clear of the noise.
    ///
    /// Source:   `[Pintelon2012]` chapter 1 for least squares of a sine; variance by batches as of `ClockOffset`.
    /// Valid:    one steady frequency; its harmonics do not bias it. Above half the sampling rate a sine shows at its alias (`alias_of`).
    /// Accuracy: 1e-9 of f without noise; coverage of the interval in white noise at least the lower 99 % bound of 95 %.
    ///
    /// # Errors
    /// [`Error::Count`] for series of different lengths; [`Error::Value`] for values beyond 1e9, or times that are not even to a quarter
    /// of a sample.
    ///
    /// ```
    /// use coilsense::measures::Sinusoid;
    ///
    /// let times: Vec<f64> = (0..2000).map(|n| f64::from(n) / 500.0).collect();
    /// let motion: Vec<f64> = times.iter().map(|t| 0.1 + 1e-3 * (std::f64::consts::TAU * 26.97 * t).sin()).collect();
    /// let found = Sinusoid::of(&times, &motion)?.ok_or("no sine")?;
    /// assert!((found.frequency - 26.97).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(times: &[f64], values: &[f64]) -> Result<Option<Self>, Error> {
        count("values", values.len(), times.len())?;
        all_bounded("value", values, "")?;
        if values.len() < FEWEST {
            return Ok(None);
        }
        let last = times.len() - 1;
        let interval = (times[last] - times[0]) / last as f64;
        for (index, time) in times.iter().enumerate() {
            let off = (time - times[0] - index as f64 * interval).abs();
            check(off <= 0.25 * interval, "time", *time, "s", "within a quarter of a sample of an even clock")?;
        }
        // Turns per sample, so that no rounded stamp matters.
        let straight = straightened(values);
        let even: Vec<f64> = (0..values.len()).map(|index| index as f64).collect();
        let spectrum = Spectrum::of(&even, &straight)?;
        let amplitudes = spectrum.amplitudes();
        let first = PERIODS as usize;
        let peak = (first..amplitudes.len()).max_by(|&a, &b| amplitudes[a].total_cmp(&amplitudes[b]));
        let Some(peak) = peak else { return Ok(None) };
        let mut sorted = amplitudes[1..].to_vec();
        sorted.sort_by(f64::total_cmp);
        let floor = sorted[sorted.len() / 2];
        let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        if amplitudes[peak] <= (CLEAR * floor).max(ROUNDING * largest) {
            return Ok(None);
        }
        let spacing = 1.0 / values.len() as f64;
        let Some(fit) = Fit::near(&straight, peak as f64 * spacing, spacing)? else { return Ok(None) };
        let power = straight.iter().map(|value| value * value).sum::<f64>() / values.len() as f64;
        let left = Line::at(&straight, fit.frequency).left(&straight);
        let is_line = |n: &u32| {
            let frequency = fit.frequency / f64::from(*n);
            let amplitude = Line::at(&left, frequency).amplitude();
            frequency >= PERIODS * spacing && amplitude > (LEAST * fit.amplitude).max(CLEAR * floor)
        };
        Ok(Some(Self {
            frequency: fit.frequency / interval,
            half_width: fit.half_width / interval,
            amplitude: fit.amplitude,
            share: (0.5 * fit.amplitude * fit.amplitude / power).min(1.0),
            harmonic: (2..=HARMONICS).rev().find(is_line).unwrap_or(1),
        }))
    }

    /// f of the lowest line \[Hz\].
    pub fn fundamental(&self) -> f64 {
        self.frequency / f64::from(self.harmonic)
    }
}

/// In turns per sample.
struct Fit {
    frequency: f64,
    half_width: f64,
    amplitude: f64,
}

impl Fit {
    /// Gauss and Newton's steps from `begin`; none where they leave its line.
    fn near(values: &[f64], begin: f64, spacing: f64) -> Result<Option<Self>, Error> {
        let mut frequency = begin;
        for _ in 0..30 {
            let line = Line::at(values, frequency);
            let slope = line.slope(values.len());
            let left = line.left(values);
            let square: f64 = slope.iter().map(|g| g * g).sum();
            let step = left.iter().zip(&slope).map(|(r, g)| r * g).sum::<f64>() / square;
            if !step.is_finite() {
                return Ok(None);
            }
            frequency += step.clamp(-0.5 * spacing, 0.5 * spacing);
            if (frequency - begin).abs() > 2.0 * spacing || !(frequency > 0.0 && frequency < 0.5) {
                return Ok(None);
            }
            if step.abs() < 1e-9 * spacing {
                break;
            }
        }
        let line = Line::at(values, frequency);
        let slope = line.slope(values.len());
        // Harmonics are no noise.
        let harmonics = (2..=HARMONICS).map(|n| frequency * f64::from(n)).filter(|line| *line < 0.5);
        let left = harmonics.fold(line.left(values), |left, line| Line::at(&left, line).left(&left));
        let part = values.len().div_ceil(PARTS);
        let scores = left.chunks(part).zip(slope.chunks(part));
        let scatter: f64 = scores.map(|(r, g)| r.iter().zip(g).map(|(r, g)| r * g).sum::<f64>().powi(2)).sum();
        let square: f64 = slope.iter().map(|g| g * g).sum();
        // The ends of a record tell most of its frequency: about half of the parts count.
        let factor = coverage_factor(0.95, (PARTS / 2) as f64)?;
        let parts = PARTS as f64;
        let half_width = factor * (scatter * parts / (parts - 2.0)).sqrt() / square;
        Ok(Some(Self { frequency, half_width, amplitude: line.amplitude() }))
    }
}

/// c + d x + A cos ωn + B sin ωn, least squares at one frequency; x from −1 to 1.
struct Line {
    omega: f64,
    factors: SVector<f64, 4>,
    gram: SMatrix<f64, 4, 4>,
}

impl Line {
    fn at(values: &[f64], frequency: f64) -> Self {
        let omega = TAU * frequency;
        let (mut gram, mut moments) = (SMatrix::<f64, 4, 4>::zeros(), SVector::<f64, 4>::zeros());
        for (index, value) in values.iter().enumerate() {
            let base = base(omega, index, values.len());
            gram += base * base.transpose();
            moments += *value * base;
        }
        let factors = gram.lu().solve(&moments).unwrap_or_else(SVector::zeros);
        Self { omega, factors, gram }
    }

    fn amplitude(&self) -> f64 {
        f64::hypot(self.factors[2], self.factors[3])
    }

    fn left(&self, values: &[f64]) -> Vec<f64> {
        let each = values.iter().enumerate();
        each.map(|(index, value)| value - base(self.omega, index, values.len()).dot(&self.factors)).collect()
    }

    /// Derivative in the frequency, less what the other four explain.
    fn slope(&self, samples: usize) -> Vec<f64> {
        let middle = 0.5 * (samples as f64 - 1.0);
        let own = |index: usize| {
            let (sine, cosine) = (self.omega * index as f64).sin_cos();
            TAU * (index as f64 - middle) * (self.factors[3] * cosine - self.factors[2] * sine)
        };
        let mut moments = SVector::<f64, 4>::zeros();
        for index in 0..samples {
            moments += own(index) * base(self.omega, index, samples);
        }
        let explained = self.gram.lu().solve(&moments).unwrap_or_else(SVector::zeros);
        (0..samples).map(|index| own(index) - base(self.omega, index, samples).dot(&explained)).collect()
    }
}

fn base(omega: f64, index: usize, samples: usize) -> SVector<f64, 4> {
    let (sine, cosine) = (omega * index as f64).sin_cos();
    SVector::<f64, 4>::new(1.0, 2.0 * index as f64 / (samples - 1) as f64 - 1.0, cosine, sine)
}

/// Without mean and straight trend.
fn straightened(values: &[f64]) -> Vec<f64> {
    let middle = 0.5 * (values.len() as f64 - 1.0);
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let lever: f64 = (0..values.len()).map(|index| (index as f64 - middle).powi(2)).sum();
    let turn = values.iter().enumerate().map(|(index, value)| (index as f64 - middle) * (value - mean)).sum::<f64>();
    let slope = turn / lever;
    values.iter().enumerate().map(|(index, value)| value - mean - slope * (index as f64 - middle)).collect()
}
