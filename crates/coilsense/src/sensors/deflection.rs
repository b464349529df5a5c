//! Force from the ends' positions: potentiometers, encoders, lasers.
//!
//! Next door: an encoder behind a drive train (`two_encoder`), force from the inductance (`inductance`).

use std::borrow::Cow;
use std::sync::Arc;

use super::sensor::{Native, Row, Sensor, Site};
use crate::error::{Error, count};
use crate::signals::{Channel, Signals};
use crate::spring::Spring;

pub(super) const ROW: Row = Row {
    word: "deflection",
    native: Native::Length,
    watches: &[Channel::U1, Channel::U2],
    natural_range: |spring, _| travel(spring),
};

/// From the shortest to the longest length in use \[m\].
pub(super) fn travel(spring: &Spring) -> f64 {
    let (shortest, longest) = spring.operating_range();
    longest - shortest
}

/// F_x: force of a spring without mass between the ends \[N\], shape `samples`; the paper's reference.
///
/// F_x = k (u2 − u1 − l0)
///
/// - `u1`, `u2`: positions of the ends \[m\], shape `samples`
///
/// Source:   `[Weijde2017]` section III-C.
/// Valid:    an ideal sensor; no initial tension.
/// Accuracy: rounding of the difference of lengths.
///
/// # Errors
/// [`Error::Count`] where the two series are not equally long.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// let force = coilsense::sensors::deflection_force(&spring, &[0.0], &[0.204])?;
/// assert!((force[0] - 76.0).abs() < 1e-12);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn deflection_force(spring: &Spring, u1: &[f64], u2: &[f64]) -> Result<Vec<f64>, Error> {
    count("u2", u2.len(), u1.len())?;
    Ok(u1.iter().zip(u2).map(|(u1, u2)| spring.static_force(u2 - u1)).collect())
}

/// A gauge of length at the spring's ends.
#[derive(Debug, Clone)]
struct Deflection(Spring);

pub(super) fn on(site: &Site<'_>) -> Arc<dyn Sensor> {
    Arc::new(Deflection(site.spring.clone()))
}

impl Sensor for Deflection {
    fn quantity<'a>(&self, signals: &'a Signals) -> Result<Cow<'a, [f64]>, Error> {
        let (u1, u2) = (signals.channel(Channel::U1)?, signals.channel(Channel::U2)?);
        Ok(u1.iter().zip(u2).map(|(u1, u2)| u2 - u1).collect())
    }

    fn force_of(&self, reading: f64) -> f64 {
        self.0.static_force(reading)
    }

    fn zero(&self) -> f64 {
        self.0.rest_length()
    }

    fn slope(&self) -> Option<f64> {
        Some(self.0.stiffness())
    }
}
