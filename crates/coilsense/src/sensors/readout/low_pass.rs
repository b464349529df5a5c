//! The low-pass: an analog Butterworth filter of order 1 to 8, followed exactly along straight lines.
//!
//! Next door: its gain and lag together with the rest of the chain (`response`).

use std::f64::consts::{PI, TAU};

use coilsense_rt::ReadoutPole;
use num_complex::Complex64;

/// One pole, or a pair of conjugate poles.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Pole {
    /// p over ω_c: on the unit circle, left of the imaginary axis.
    place: Complex64,
    /// g, its share of the gain at rest; twice that for a pair, whose real part is taken.
    share: Complex64,
}

/// Gain 1 at rest, 1/√2 at the bandwidth, monotone.
///
/// |H(f)|² = 1 / (1 + (f/f_c)^2n), poles p_k = ω_c e^(iπ(2k+n−1)/2n), k = 1…n
///
/// - `order`: n, `bandwidth`: f_c = ω_c/2π \[Hz\]
///
/// Source:   `[Butterworth1930]`; `[Oppenheim2010]` appendix B.1 for the poles.
/// Valid:    order 1 to 8.
/// Accuracy: gain and phase of simulated sines follow H to second order of the spacing, 1e-13 for straight-line inputs.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Butterworth {
    cutoff: f64,
    poles: Vec<Pole>,
}

impl Butterworth {
    pub(super) fn new(order: usize, bandwidth: f64) -> Self {
        let place = |k: usize| Complex64::cis(PI * (2 * k + order + 1) as f64 / (2 * order) as f64);
        let poles = (0..order.div_ceil(2)).map(|k| {
            if 2 * k + 1 == order {
                return Pole { place: Complex64::new(-1.0, 0.0), share: share(order, k, place).re.into() };
            }
            Pole { place: place(k), share: 2.0 * share(order, k, place) }
        });
        Self { cutoff: TAU * bandwidth, poles: poles.collect() }
    }

    /// Replaces `values` at `times` \[s\], both of shape `samples`, by the filter's output.
    ///
    /// With H = Σ g_k / (1 − s/p_k) and Σ g_k = 1, the output is x + Σ g_k d_k, where ḋ_k = p_k d_k − ẋ. Over an interval h in which
    /// x grows by Δ on a straight line: d_k ← e^z d_k − Δ (e^z − 1)/z, z = p_k h. At rest all d_k are zero, whatever x is.
    pub(super) fn filter(&self, times: &[f64], values: &mut [f64]) {
        let mut steps = vec![Step::default(); self.poles.len()];
        let mut known = f64::NAN;
        let mut before = values.first().copied().unwrap_or(0.0);
        for sample in 1..values.len() {
            let interval = times[sample] - times[sample - 1];
            // Intervals that differ by no more than the rounding of their times are the same interval.
            let same =
                (interval - known).abs() <= 4.0 * f64::EPSILON * times[sample].abs().max(times[sample - 1].abs());
            if !same {
                known = interval;
                self.poles
                    .iter()
                    .zip(&mut steps)
                    .for_each(|(pole, step)| step.cover(self.cutoff * interval * pole.place));
            }
            let value = values[sample];
            let gain = value - before;
            before = value;
            let mut output = value;
            for (pole, step) in self.poles.iter().zip(&mut steps) {
                step.behind = step.decay * step.behind - gain * step.drag;
                output += (pole.share * step.behind).re;
            }
            values[sample] = output;
        }
    }

    /// Its poles over one interval \[s\].
    pub(super) fn steps(&self, interval: f64) -> Vec<ReadoutPole<f64>> {
        let pair = |value: Complex64| [value.re, value.im];
        let of = |pole: &Pole| {
            let mut step = Step::default();
            step.cover(self.cutoff * interval * pole.place);
            ReadoutPole { decay: pair(step.decay), drag: pair(step.drag), share: pair(pole.share) }
        };
        self.poles.iter().map(of).collect()
    }

    /// H at a frequency \[Hz\].
    pub(super) fn response(&self, frequency: f64) -> Complex64 {
        let x = TAU * frequency / self.cutoff;
        self.sections(x).map(|denominator| denominator.inv()).product()
    }

    /// Phase delay −arg H / ω \[s\], without jumps of the phase; at zero its limit.
    pub(super) fn lag(&self, frequency: f64) -> f64 {
        let x = TAU * frequency.abs() / self.cutoff;
        if x == 0.0 {
            return self.poles.iter().map(|pole| -pole.place.re * pole.multiplicity()).sum::<f64>() / self.cutoff;
        }
        self.sections(x).map(|denominator| denominator.arg()).sum::<f64>() / (x * self.cutoff)
    }

    /// 1 + ix for the real pole, 1 − x² + 2iσx for a pair at −σ ± i√(1−σ²).
    fn sections(&self, x: f64) -> impl Iterator<Item = Complex64> {
        self.poles.iter().map(move |pole| match pole.multiplicity() {
            2.0 => Complex64::new((1.0 - x) * (1.0 + x), -2.0 * pole.place.re * x),
            _ => Complex64::new(1.0, x),
        })
    }
}

impl Pole {
    /// 2 for a pair, 1 for the real pole.
    fn multiplicity(&self) -> f64 {
        if self.place.im == 0.0 { 1.0 } else { 2.0 }
    }
}

/// g_k = Π over the other poles of p_j / (p_j − p_k).
fn share(order: usize, k: usize, place: impl Fn(usize) -> Complex64) -> Complex64 {
    (0..order).filter(|&j| j != k).map(|j| place(j) / (place(j) - place(k))).product()
}

/// How far one pole is behind, and what an interval does to it.
#[derive(Debug, Clone, Copy, Default)]
struct Step {
    /// d: what its output is behind the input.
    behind: Complex64,
    /// e^z.
    decay: Complex64,
    /// (e^z − 1)/z.
    drag: Complex64,
}

impl Step {
    /// Makes it cover an interval, z = p h.
    fn cover(&mut self, z: Complex64) {
        self.decay = z.exp();
        self.drag = if z.norm() > 0.5 {
            (self.decay - 1.0) / z
        } else {
            // Σ z^n/(n+1)!, thirteen terms: the next is below 0.5^13/14! = 1e-15.
            (2..=13).rev().fold(Complex64::ONE, |sum, n| 1.0 + sum * z / f64::from(n))
        };
    }
}
