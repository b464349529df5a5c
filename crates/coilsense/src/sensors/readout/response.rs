//! The chain over frequency: what is left of a sine, and how late it comes.
//!
//! Next door: the same over time (`super`); sines that sampling folds elsewhere (`crate::measures::alias_of`).

use std::f64::consts::{FRAC_1_SQRT_2, PI, TAU};

use num_complex::Complex64;

use super::Readout;

/// Where sin(πx)/(πx) = 1/√2.
const SINC_HALF_POWER: f64 = 0.442_946_470_689_452_3;

impl Readout {
    /// What becomes of a sine at a frequency \[Hz\], complex gain: |H| is the gain, arg H the phase.
    ///
    /// H(f) = B(f) · e^(−iωT_d) · sinc(fW) e^(−iωW/2) · sinc(f/f_s) e^(−iω/2f_s), sinc x = sin(πx)/(πx), B the Butterworth's
    ///
    /// The last factor is the hold: the mean lag of half a sample, and the sine that fits the staircase best.
    ///
    /// Source:   `[Butterworth1930]`; `[Oppenheim2010]` section 4.8.4 for the hold; the mean's factor is the same integral.
    /// Valid:    up to 1e9 Hz; with sampling up to f_s/2, and without the images that the staircase also holds.
    /// Accuracy: gain 1e-14 relative against |B|² = 1/(1 + (f/f_c)^2n); simulated sines follow it to second order of their spacing.
    ///
    /// ```
    /// use coilsense::sensors::{Readout, ReadoutParameters};
    ///
    /// let meter = Readout::new(ReadoutParameters { bandwidth: Some(100.0), order: 4, ..Default::default() })?;
    /// assert!((meter.response(100.0).norm() - 0.5_f64.sqrt()).abs() < 1e-15);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn response(&self, frequency: f64) -> Complex64 {
        let filtered = self.low_pass.as_ref().map_or(Complex64::ONE, |low_pass| low_pass.response(frequency));
        let late = Complex64::cis(-TAU * frequency * self.pure_delay());
        filtered * late * self.windows().map(|window| sinc(frequency * window)).product::<f64>()
    }

    /// σ_B: what of the readings' noise lies below a bandwidth, rms in the quantity's unit.
    ///
    /// σ_B = σ √min(2B/f_s, 1); σ without a bandwidth
    ///
    /// - `bandwidth`: B \[Hz\]; `rate`: f_s of a readout without a sample rate of its own \[Hz\]
    ///
    /// Source:   white noise: its power is spread evenly up to f_s/2.
    /// Valid:    a sharp filter at B; noise of samples that are drawn independently.
    /// Accuracy: rounding.
    ///
    /// ```
    /// use coilsense::sensors::{Readout, ReadoutParameters};
    ///
    /// let cell = Readout::new(ReadoutParameters { noise: 0.4, sample_rate: Some(800.0), ..Default::default() })?;
    /// assert!((cell.noise_within(Some(100.0), 1e4) - 0.2).abs() < 1e-15);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn noise_within(&self, bandwidth: Option<f64>, rate: f64) -> f64 {
        let rate = self.parameters().sample_rate.unwrap_or(rate);
        let share = bandwidth.map_or(1.0, |bandwidth| (2.0 * bandwidth / rate).min(1.0));
        self.parameters().noise * share.sqrt()
    }

    /// How late a sine at a frequency \[Hz\] comes \[s\]: its phase delay; at 0 Hz that of slow changes.
    ///
    /// −arg B(f)/ω + T_d + W/2 + 1/2f_s, with the phase of B unwrapped, and half a turn at each zero of a sinc not counted
    ///
    /// Source:   definition of phase delay, each element's as in [`Self::response`].
    /// Valid:    as [`Self::response`].
    /// Accuracy: 1e-14 relative.
    ///
    /// ```
    /// use coilsense::sensors::{Readout, ReadoutParameters};
    ///
    /// // A first-order low-pass lags slow changes by its time constant 1/2πf_c.
    /// let meter = Readout::new(ReadoutParameters { bandwidth: Some(100.0), ..Default::default() })?;
    /// assert!((meter.lag(0.0) - 1.591_549_430_918_953_5e-3).abs() < 1e-17);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn lag(&self, frequency: f64) -> f64 {
        self.low_pass.as_ref().map_or(0.0, |low_pass| low_pass.lag(frequency)) + self.pure_delay()
    }

    /// Lowest frequency at which the whole chain has lost 3 dB \[Hz\]; infinite where nothing limits it.
    ///
    /// |H(f)| = 1/√2
    ///
    /// Source:   [`Self::response`], bisected: up to the least of its elements' own bandwidths every factor falls.
    /// Valid:    as [`Self::response`]; above f_s/2 it says what the hold alone would do.
    /// Accuracy: 1e-13 relative.
    ///
    /// ```
    /// use coilsense::sensors::{Readout, ReadoutParameters};
    ///
    /// let meter = Readout::new(ReadoutParameters { averaging: Some(0.01), ..Default::default() })?;
    /// assert!((meter.bandwidth_3db() - 44.294_647_068_945).abs() < 1e-11);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn bandwidth_3db(&self) -> f64 {
        let alone = self.windows().map(|window| SINC_HALF_POWER / window);
        let least = alone.chain(self.parameters.bandwidth).fold(f64::INFINITY, f64::min);
        let (mut passed, mut lost) = (0.0, least);
        while least.is_finite() {
            let middle = 0.5 * (passed + lost);
            if middle <= passed || middle >= lost {
                break;
            }
            if self.response(middle).norm() > FRAC_1_SQRT_2 { passed = middle } else { lost = middle }
        }
        lost
    }

    /// The spans over which it averages or holds \[s\].
    fn windows(&self) -> impl Iterator<Item = f64> {
        self.parameters.averaging.into_iter().chain(self.parameters.sample_rate.map(|rate| 1.0 / rate))
    }

    /// What every frequency is late by alike \[s\].
    fn pure_delay(&self) -> f64 {
        self.parameters.delay + 0.5 * self.windows().sum::<f64>()
    }
}

/// sin(πx)/(πx), 1 at zero; exactly zero at the other whole numbers.
fn sinc(x: f64) -> f64 {
    if x == 0.0 {
        return 1.0;
    }
    // sin(πx) = ± sin(π(x − n)) keeps its zeros where x is large.
    let whole = x.round();
    let sign = if whole.rem_euclid(2.0) == 0.0 { 1.0 } else { -1.0 };
    sign * (PI * (x - whole)).sin() / (PI * x)
}
