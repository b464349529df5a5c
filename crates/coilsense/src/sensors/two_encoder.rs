//! Force from two encoders, with a drive train between the motor's encoder and the spring.
//!
//! Next door: encoders right at the spring's ends (`deflection`), what each encoder makes of its position (`readout`).

use std::borrow::Cow;
use std::sync::Arc;

use super::Quantity;
use super::cause;
use super::cause::{Cause, Place};
use super::deflection::travel;
use super::sensor::{Native, Row, Sensor, Site};
use crate::error::{Error, all_bounded, called, count, finite, from_zero};
use crate::signals::{Channel, Signals};
use crate::spring::Spring;

/// How far a drive train's compliance may be off, either way, as a share \[1\]: it is seldom known better.
pub const USUAL_COMPLIANCE_TOLERANCE: f64 = 0.1;

pub(super) const ROW: Row = Row {
    word: "two-encoder",
    native: Native::Length,
    watches: &[Channel::U1, Channel::U2, Channel::InputForce],
    natural_range: |spring, _| travel(spring),
};

/// An encoder on the motor's side of the drive train and one at end 2, of a series elastic actuator.
#[derive(Debug, Clone, PartialEq)]
pub struct TwoEncoder {
    compliance: f64,
    backlash: f64,
    /// k_s \[N/m\].
    stiffness: f64,
    /// Elongation that reads as no force \[m\].
    zero: f64,
}

impl TwoEncoder {
    /// Encoders around `spring` with a drive train of compliance c and backlash b, zeroed under a static load.
    ///
    /// k_s = 1/(1/k + c), zero = l0 + (b/2) sgn(k (l̄ − l0)): a static load at l̄ reads k (l̄ − l0) exactly
    ///
    /// - `compliance`: c \[m/N\], `backlash`: b, the whole gap \[m\], both zero or above; `mean_length`: l̄ \[m\]
    ///
    /// Source:   springs in series; the zero follows from [`Self::elongation`] at rest with F_i = k (l̄ − l0).
    /// Valid:    a massless drive train, linear but for its gap; friction is not in it.
    /// Accuracy: rounding of the difference of lengths.
    ///
    /// # Errors
    /// [`Error::Value`] for a compliance or backlash below zero, or a value that is not finite.
    pub fn new(spring: &Spring, compliance: f64, backlash: f64, mean_length: f64) -> Result<Self, Error> {
        from_zero(called("compliance", "drive-train compliance"), compliance, "m/N")?;
        from_zero("backlash", backlash, "m")?;
        finite("mean_length", mean_length, "m")?;
        let stiffness = 1.0 / (1.0 / spring.stiffness() + compliance);
        let zero = spring.rest_length() + 0.5 * backlash * side(spring.static_force(mean_length), 0.0);
        Ok(Self { compliance, backlash, stiffness, zero })
    }

    /// k_s: stiffness of spring and drive train in series \[N/m\].
    pub fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// Elongation at which it reads no force \[m\].
    pub fn zero(&self) -> f64 {
        self.zero
    }

    /// Distance between the two encoders \[m\], shape `samples`.
    ///
    /// u2 − u_motor = (u2 − u1) + c F_i + (b/2) sgn F_i
    ///
    /// - `u1`, `u2`: positions of the spring's ends \[m\], `f_i`: force at end 1, tension positive \[N\], each of shape `samples`
    ///
    /// In tension the spring pulls end 1 away from the motor: it lies ahead by the drive train's stretch c F_i and by half the gap,
    /// u1 = u_motor + c F_i + (b/2) sgn F_i. At F_i = 0 nothing tells where in its gap it lies: it is taken to stay on the side it
    /// touched last, before the first contact on the side of that contact, and in the middle where there never is one.
    ///
    /// Source:   statics of the drive train, as derived above.
    /// Valid:    a massless drive train: impacts within the gap are not in it.
    /// Accuracy: rounding of the sum.
    ///
    /// # Errors
    /// [`Error::Count`] where the series are not equally long; [`Error::Value`] for a value beyond 1e9 either way.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// let encoders = coilsense::sensors::TwoEncoder::new(&spring, 1e-5, 2e-4, 0.204)?;
    /// let elongation = encoders.elongation(&[0.0], &[0.204], &[76.0])?;
    /// assert!((elongation[0] - (0.204 + 76e-5 + 1e-4)).abs() < 1e-15);
    /// assert!((encoders.force(&elongation)[0] - 76.0).abs() < 1e-11);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn elongation(&self, u1: &[f64], u2: &[f64], f_i: &[f64]) -> Result<Vec<f64>, Error> {
        count("u2", u2.len(), u1.len())?;
        count("F_i", f_i.len(), u1.len())?;
        all_bounded("u1", u1, "m")?;
        all_bounded("u2", u2, "m")?;
        all_bounded("F_i", f_i, "N")?;
        let first = f_i.iter().find(|force| **force != 0.0);
        let mut contact = first.map_or(0.0, |&force| side(force, 0.0));
        let elongation = u1.iter().zip(u2).zip(f_i).map(|((u1, u2), &force)| {
            contact = side(force, contact);
            (u2 - u1) + self.compliance * force + 0.5 * self.backlash * contact
        });
        Ok(elongation.collect())
    }

    /// Force that the two encoders tell \[N\], shape `samples`.
    ///
    /// F = k_s (e − zero)
    ///
    /// - `elongation`: e, as [`Self::elongation`] gives it, through an instrument or not \[m\], shape `samples`
    ///
    /// Source:   Hooke's law for spring and drive train in series.
    /// Valid:    slow changes; loads on the side of the gap on which it was zeroed, else it is off by k_s b.
    /// Accuracy: rounding of the difference of lengths.
    pub fn force(&self, elongation: &[f64]) -> Vec<f64> {
        elongation.iter().map(|&length| self.force_at(length)).collect()
    }

    fn force_at(&self, elongation: f64) -> f64 {
        self.stiffness * (elongation - self.zero)
    }
}

/// Two encoders, and how far their drive train may be off.
#[derive(Debug, Clone)]
struct OnDriveTrain {
    encoders: TwoEncoder,
    /// Of the compliance, as a share \[1\].
    tolerance: f64,
}

pub(super) fn on(site: &Site<'_>, compliance: f64, tolerance: f64, backlash: f64) -> Result<Arc<dyn Sensor>, Error> {
    let encoders = TwoEncoder::new(site.spring, compliance, backlash, site.mean_length)?;
    Ok(Arc::new(OnDriveTrain { encoders, tolerance }))
}

/// A drive train without play, and none.
pub(super) fn alternatives(compliance: f64, compliance_tolerance: f64) -> Vec<(&'static str, Quantity)> {
    let without_play = |compliance| Quantity::TwoEncoder { compliance, compliance_tolerance, backlash: 0.0 };
    vec![
        ("a drive train without backlash", without_play(compliance)),
        ("encoders on the spring's own ends", without_play(0.0)),
    ]
}

impl Sensor for OnDriveTrain {
    fn quantity<'a>(&self, signals: &'a Signals) -> Result<Cow<'a, [f64]>, Error> {
        let (u1, u2) = (signals.channel(Channel::U1)?, signals.channel(Channel::U2)?);
        Ok(self.encoders.elongation(u1, u2, signals.channel(Channel::InputForce)?)?.into())
    }

    fn force_of(&self, reading: f64) -> f64 {
        self.encoders.force_at(reading)
    }

    fn zero(&self) -> f64 {
        self.encoders.zero
    }

    fn slope(&self) -> Option<f64> {
        Some(self.encoders.stiffness)
    }

    /// Set to zero at the mean length, a drive train that is softer than thought shows in what the force is off its mean.
    fn own_causes(&self, _: &Site<'_>) -> Vec<Cause> {
        let softer = self.tolerance * self.encoders.compliance;
        Cause::within(Place::Compliance, cause::COMPLIANCE, softer).into_iter().collect()
    }
}

/// Sign of a force, and where it is exactly zero the one before.
fn side(force: f64, before: f64) -> f64 {
    if force == 0.0 { before } else { force.signum() }
}
