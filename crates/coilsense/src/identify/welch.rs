//! Power over frequency of a whole record, after Welch.
//!
//! Next door: lines that ring down after hits (`lines`).

use std::ops::Range;

use realfft::RealFftPlanner;

use super::median::median;

/// One-sided power spectral density, Hann-tapered segments half overlapping.
#[derive(Debug, Clone, PartialEq)]
pub struct Welch {
    /// From line to line \[Hz\].
    pub spacing: f64,
    /// Density of each line \[unit²/Hz\], 0 Hz first.
    pub density: Vec<f64>,
    /// How many segments were averaged.
    pub segments: usize,
}

impl Welch {
    /// Of a series sampled at `rate` \[Hz\], in segments of `length` samples; the mean of each is taken out.
    ///
    /// S_k = 2/(f_s Σw²) · mean |Σ w_n (x_n − x̄) e^(−2πikn/L)|², w_n = ½(1 − cos(2πn/L))
    ///
    /// Source:   `[Welch1967]`.
    /// Valid:    steady series; a line of amplitude a shows as a²/(3 · spacing) there.
    /// Accuracy: 1e-12 relative against the plain sum (`tests/identify`).
    pub fn of(values: &[f64], rate: f64, length: usize) -> Self {
        Self::of_stretches(&|range| values[range].to_vec(), values.len(), rate, length)
    }

    /// The same of a series of so many samples whose stretches are computed where they are needed.
    pub(super) fn of_stretches(
        stretch: &dyn Fn(Range<usize>) -> Vec<f64>,
        samples: usize,
        rate: f64,
        length: usize,
    ) -> Self {
        let length = length.clamp(1, samples.max(1));
        let transform = RealFftPlanner::<f64>::new().plan_fft_forward(length);
        let turn = std::f64::consts::TAU / length as f64;
        let taper: Vec<f64> = (0..length).map(|n| 0.5 * (1.0 - (turn * n as f64).cos())).collect();
        let power: f64 = taper.iter().map(|w| w * w).sum::<f64>().max(f64::MIN_POSITIVE);
        let mut density = vec![0.0; length / 2 + 1];
        let (mut input, mut output) = (transform.make_input_vec(), transform.make_output_vec());
        let mut segments = 0;
        let mut start = 0;
        while start + length <= samples {
            let part = stretch(start..start + length);
            let mean = part.iter().sum::<f64>() / length as f64;
            for ((x, w), y) in part.iter().zip(&taper).zip(&mut input) {
                *y = w * (x - mean);
            }
            // Lengths come from the plan itself.
            if transform.process(&mut input, &mut output).is_ok() {
                density.iter_mut().zip(&output).for_each(|(sum, line)| *sum += line.norm_sqr());
                segments += 1;
            }
            start += (length / 2).max(1);
        }
        let scale = 1.0 / (rate * power * segments.max(1) as f64);
        for (line, value) in density.iter_mut().enumerate() {
            let twice = if line == 0 || 2 * line == length { 1.0 } else { 2.0 };
            *value *= twice * scale;
        }
        Self { spacing: rate / length as f64, density, segments }
    }
}

/// Median of the values about each line, in bands a third of an octave and at least `least` lines wide: what is between the lines.
pub(super) fn floor(values: &[f64], least: usize) -> Vec<f64> {
    let mut floor = vec![0.0; values.len()];
    let mut from = 1;
    while from < values.len() {
        let to = ((from as f64 * 1.26) as usize).max(from + least).min(values.len());
        // A last band that is too thin reaches back into the one before it.
        let wide = if to - from < least { to.saturating_sub(least).max(1)..to } else { from..to };
        let mut band = values[wide].to_vec();
        floor[from..to].fill(median(&mut band));
        from = to;
    }
    if let Some(&second) = floor.get(1) {
        floor[0] = second;
    }
    floor
}
