//! The spring as a controller sees it: sampled, with a damping ratio for each mode.
//!
//! Next door: what may be off about it (`tolerance`), the designs that take it.

use crate::damping::Damping;
use crate::error::{Error, above_zero, called, check};
use crate::modes::ChainModes;
use crate::spring::Spring;

/// A spring with both end positions measured, its damping, and the rate at which it is sampled.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// use coilsense::{Damping, mitigation::SampledSpring};
/// let sampled = SampledSpring::new(&spring, &Damping::Modal(0.005), 2500.0)?;
/// assert!((sampled.surge_period() - 46.24).abs() < 0.01);
/// assert!(SampledSpring::new(&spring, &Damping::Modal(0.005), 100.0).is_err());
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SampledSpring {
    spring: Spring,
    modes: ChainModes,
    ratios: Vec<f64>,
    rate: f64,
}

impl SampledSpring {
    /// The spring `spring` with `damping`, sampled at `rate` \[Hz\].
    ///
    /// # Errors
    /// [`Error::Value`] for a rate that is not above twice the first surge frequency, a damping ratio of 1 or more, or a loss factor;
    /// [`Error::Count`] where damping for each mode is given for another number of modes.
    pub fn new(spring: &Spring, damping: &Damping, rate: f64) -> Result<Self, Error> {
        spring.check_uniform("observers")?;
        Self::check_rate(spring, rate)?;
        let modes = ChainModes::of(spring);
        let ratios = damping.clone().checked()?.ratios(modes.frequencies())?;
        if let Some(mode) = ratios.iter().position(|ratio| *ratio >= 1.0) {
            // A mode that does not swing needs nothing done about it, and stops being a pair of complex poles.
            let quantity = format!("damping ratio of mode {}", mode + 1);
            let few = mode < 3;
            check(!few, quantity, ratios[mode], "", "below 1, for there is no ringing to mitigate")?;
        }
        Ok(Self { spring: spring.clone(), modes, ratios, rate })
    }

    /// Whether a spring can be sampled at `rate` \[Hz\].
    ///
    /// # Errors
    /// [`Error::Value`] for a rate that is not above twice the first surge frequency.
    pub fn check_rate(spring: &Spring, rate: f64) -> Result<(), Error> {
        above_zero(called("rate", "sampling rate"), rate, "Hz")?;
        let first = spring.surge_frequency();
        let allowed = format!("above twice the first surge frequency of {first:.3} Hz");
        check(rate > 2.0 * first, called("rate", "sampling rate"), rate, "Hz", allowed).map(|_| ())
    }

    /// The spring.
    pub fn spring(&self) -> &Spring {
        &self.spring
    }

    /// Its modes with both end positions given.
    pub fn modes(&self) -> &ChainModes {
        &self.modes
    }

    /// ζ_j \[1\], shape `modes`.
    pub fn ratios(&self) -> &[f64] {
        &self.ratios
    }

    /// Sampling rate \[Hz\].
    pub fn rate(&self) -> f64 {
        self.rate
    }

    /// 2τ = 1/f1 \[samples\], above 2 and rarely whole.
    pub fn surge_period(&self) -> f64 {
        self.rate / self.spring.surge_frequency()
    }

    /// The same damping and rate on another spring, such as a corner of the tolerances.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub(crate) fn on(&self, spring: &Spring) -> Result<Self, Error> {
        Self::new(spring, &Damping::ModalEach(self.ratios.clone()), self.rate)
    }
}
