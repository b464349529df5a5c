//! Settings of the delay-line observer.
//!
//! Next door: the modal one (`kalman`).

use std::f64::consts::PI;

use coilsense_rt::{Delay, DelayLineObserver};

use super::sampled_spring::SampledSpring;
use crate::error::{Error, called, check};

/// An observer by waves: k, l0, Z = √(km), τ, and of every passage the share that mode 1 loses in one.
///
/// λ = 1 − e^(−πζ_1)
///
/// - `gain`: g \[1\], from 0 to 1: the share of what is measured against the wave predicted that is believed
///
/// Source:   [`DelayLineObserver`]; mode 1 decays by e^(−ζ_1 ω_1 τ) in a transit, ω_1 τ = π.
/// Valid:    τ of at least 1 sample, as [`SampledSpring`] sees to; with damping that grows with frequency higher modes ring on too long.
/// Accuracy: that of the wave equation against the chain: dispersion of the windings is left out.
///
/// # Errors
/// [`Error::Value`] for a gain outside of 0 to 1.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// use coilsense::{Damping, mitigation::{SampledSpring, delay_line_observer}};
/// let observer = delay_line_observer(&SampledSpring::new(&spring, &Damping::None, 2500.0)?, 0.3)?;
/// assert_eq!((observer.transit.whole, observer.loss), (23, 0.0));
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn delay_line_observer(spring: &SampledSpring, gain: f64) -> Result<DelayLineObserver<f64>, Error> {
    check((0.0..=1.0).contains(&gain), called("gain", "observer gain"), gain, "", "from 0 to 1")?;
    let transit = 0.5 * spring.surge_period();
    Ok(DelayLineObserver {
        stiffness: spring.spring().stiffness(),
        rest_length: spring.spring().rest_length(),
        impedance: spring.spring().wave_impedance(),
        rate: spring.rate(),
        transit: Delay { whole: transit as usize, fraction: transit.fract() },
        gain,
        loss: -(-PI * spring.ratios()[0]).exp_m1(),
    })
}
