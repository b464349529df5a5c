//! What an instrument makes of a physical quantity: low-pass ► delay ► averaging ► sampling ► noise ► resolution.
//!
//! One file per element, each with its closed form; this one holds the settings and runs the chain over time. Next door: the chain
//! over frequency (`response`) and step by step (`steps`), what the quantity is (`crate::motion`), the estimate made of it (`super`).

mod boxcar;
mod delay;
mod low_pass;
mod noise;
mod quantiser;
mod response;
mod sample_hold;
mod steps;
mod straight;

use crate::error::{Error, above_zero, all_bounded, called, check, count, from_zero};
use crate::signals::increasing;
use low_pass::Butterworth;
pub use steps::ReadoutSteps;

/// Highest order of a readout's low-pass.
pub const MAX_ORDER: usize = 8;

/// What describes an instrument, by name; [`Readout::new`] checks it. The default lets everything through as it is.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadoutParameters {
    /// Where the low-pass has lost 3 dB \[Hz\]; `None` for no low-pass.
    pub bandwidth: Option<f64>,
    /// Order of the low-pass, a Butterworth, 1 to [`MAX_ORDER`]; without `bandwidth` it means nothing.
    pub order: usize,
    /// T_d: time by which the reading comes late \[s\].
    pub delay: f64,
    /// W: the reading is the mean over the preceding W \[s\], as an LCR meter's; `None` for the momentary value.
    pub averaging: Option<f64>,
    /// f_s: samples per second \[Hz\], taken at k/f_s and held until the next; `None` for a continuous reading.
    pub sample_rate: Option<f64>,
    /// σ: rms of the noise, in the quantity's unit: one normal number for every sample of the instrument, or, without `sample_rate`,
    /// for every time at which it is asked. So without `sample_rate` its density over frequency depends on these times.
    pub noise: f64,
    /// q: step between readings, in the quantity's unit; `None` for no rounding.
    pub resolution: Option<f64>,
}

impl Default for ReadoutParameters {
    fn default() -> Self {
        Self { bandwidth: None, order: 1, delay: 0.0, averaging: None, sample_rate: None, noise: 0.0, resolution: None }
    }
}

/// An instrument whose every setting has been checked.
///
/// ```
/// use coilsense::sensors::{Readout, ReadoutParameters};
///
/// // An LCR meter: 10 ms windows, 100 readings per second, 1 nH steps.
/// let meter = Readout::new(ReadoutParameters {
///     averaging: Some(0.01), sample_rate: Some(100.0), resolution: Some(1e-9), ..Default::default()
/// })?;
/// // It lags by half a window and half a hold, and averages 100 Hz away.
/// assert!((meter.lag(0.0) - 0.01).abs() < 1e-15);
/// assert!(meter.response(100.0).norm() < 1e-15);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Readout {
    parameters: ReadoutParameters,
    low_pass: Option<Butterworth>,
}

impl Readout {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`Error::Value`] for the first that is not finite, an order outside of 1 to [`MAX_ORDER`], a delay or noise below zero, a
    /// bandwidth, window, sample rate or resolution that is not above zero.
    pub fn new(parameters: ReadoutParameters) -> Result<Self, Error> {
        let p = &parameters;
        let allowed = (1..=MAX_ORDER).contains(&p.order);
        check(allowed, called("order", "order of the low-pass"), p.order as f64, "", format!("from 1 to {MAX_ORDER}"))?;
        if let Some(bandwidth) = p.bandwidth {
            above_zero("bandwidth", bandwidth, "Hz")?;
        }
        from_zero("delay", p.delay, "s")?;
        if let Some(window) = p.averaging {
            above_zero(called("averaging", "averaging window"), window, "s")?;
        }
        if let Some(rate) = p.sample_rate {
            above_zero("sample_rate", rate, "Hz")?;
        }
        from_zero("noise", p.noise, "")?;
        if let Some(step) = p.resolution {
            // A step may be far below what `above_zero` takes for a spring: picohenries, say.
            check(step.is_finite() && step > 0.0, "resolution", step, "", "above zero and finite")?;
        }
        let low_pass = p.bandwidth.map(|bandwidth| Butterworth::new(p.order, bandwidth));
        Ok(Self { parameters, low_pass })
    }

    /// The settings it was made from.
    pub fn parameters(&self) -> &ReadoutParameters {
        &self.parameters
    }

    /// The reading at each of `times`, in the unit of `values`, shape `samples`.
    ///
    /// resolution(noise + sampling(averaging(delay(low-pass(x))))), each left out where its setting says so
    ///
    /// - `times`: \[s\], increasing, shape `samples`, uniform or not; `values`: x, shape `samples`, in any unit
    /// - `seed`: of the noise; the same seed gives the same noise
    ///
    /// x is taken as straight between samples, and constant before the first at its first value, so a steady start has no transient.
    ///
    /// Source:   each element's closed form, given in its file (`low_pass`, `delay`, `boxcar`, `sample_hold`, `noise`, `quantiser`).
    /// Valid:    a linear instrument up to its quantiser; samples close enough for x to be straight between them.
    /// Accuracy: each element alone is exact for a straight-line x: 1e-13 of the largest value. What one element hands to the next is
    ///           taken as straight between `times` too: an error of second order, halving the spacing h divides it by four; delay
    ///           and hold read between times to (ωh)²/8 of a sine.
    ///
    /// # Errors
    /// [`Error::Value`] for a time that is not finite or not after its predecessor, or a value beyond 1e9 either way;
    /// [`Error::Count`] where `values` has not one value per time.
    ///
    /// ```
    /// use coilsense::sensors::{Readout, ReadoutParameters};
    ///
    /// let meter = Readout::new(ReadoutParameters { delay: 0.1, resolution: Some(0.5), ..Default::default() })?;
    /// let reading = meter.series(&[0.0, 0.1, 0.2, 0.3], &[1.0, 2.0, 3.1, 3.2], 1)?;
    /// assert_eq!(reading, [1.0, 1.0, 2.0, 3.0]);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn series(&self, times: &[f64], values: &[f64], seed: u64) -> Result<Vec<f64>, Error> {
        let mut reading = self.ideal_series(times, values)?;
        let p = &self.parameters;
        if p.noise > 0.0 {
            noise::add(times, &mut reading, p.noise, p.sample_rate, seed);
        }
        if let Some(step) = p.resolution {
            reading.iter_mut().for_each(|value| *value = quantiser::round(*value, step));
        }
        Ok(reading)
    }

    /// [`Self::series`] without noise and rounding: what the instrument does to the quantity every time alike.
    ///
    /// # Errors
    /// As [`Self::series`].
    pub fn ideal_series(&self, times: &[f64], values: &[f64]) -> Result<Vec<f64>, Error> {
        all_bounded("time", increasing(times)?, "s")?;
        count("values", values.len(), times.len())?;
        all_bounded("value", values, "")?;
        let mut reading = values.to_vec();
        if let Some(low_pass) = &self.low_pass {
            low_pass.filter(times, &mut reading);
        }
        if self.parameters.delay > 0.0 {
            reading = delay::by(self.parameters.delay, times, &reading);
        }
        if let Some(window) = self.parameters.averaging {
            reading = boxcar::mean_over(window, times, &reading);
        }
        if let Some(rate) = self.parameters.sample_rate {
            reading = sample_hold::at_rate(rate, times, &reading);
        }
        Ok(reading)
    }
}
