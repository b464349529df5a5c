//! What every kind of sensor is: a row in the table of kinds, and once it sits on a spring, a way from signals to readings and to a force.
//!
//! Next door: the kinds, one file each, and their table (the parent); what an instrument makes of a signal over time (`readout`).

use std::borrow::Cow;
use std::fmt::Debug;

use super::cause::Cause;
use crate::error::Error;
use crate::inductance::OverLength;
use crate::signals::{Channel, Signals};
use crate::spring::Spring;

/// What a sensor's readings are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Native {
    /// Forces \[N\].
    Force,
    /// Lengths \[m\].
    Length,
    /// Inductances \[H\].
    Inductance,
}

impl Native {
    /// Its SI unit.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Force => "N",
            Self::Length => "m",
            Self::Inductance => "H",
        }
    }
}

/// A kind in the table of kinds.
pub(super) struct Row {
    /// Its word.
    pub word: &'static str,
    pub native: Native,
    /// The signals that it watches.
    pub watches: &'static [Channel],
    /// Full scale where nobody says it, in the native unit.
    pub natural_range: fn(&Spring, &dyn OverLength) -> f64,
}

/// Where a sensor sits.
#[derive(Debug, Clone, Copy)]
pub struct Site<'a> {
    /// The spring that it is told it sits on.
    pub spring: &'a Spring,
    /// The windings of that spring as a coil.
    pub coil: &'a dyn OverLength,
    /// l̄: length at which it is set to zero, and through which its calibration goes \[m\].
    pub mean_length: f64,
}

/// A sensor on a spring: what it watches, which force its readings mean, and what that errs by beyond the limits of its data sheet.
///
/// Each kind has one; a kind of one's own is judged like them by [`super::Instrument::new`] and [`super::Measurement`].
pub trait Sensor: Debug + Send + Sync {
    /// What it watches, in its native unit, shape `samples`.
    ///
    /// # Errors
    /// [`Error::MissingSignal`] where a signal that it needs is not there.
    fn quantity<'a>(&self, signals: &'a Signals) -> Result<Cow<'a, [f64]>, Error>;

    /// The force \[N\] that a reading in the native unit means.
    fn force_of(&self, reading: f64) -> f64;

    /// The reading that an error of the gain leaves as it is, in the native unit: none, or of a length the one that means no force.
    ///
    /// A gauge of length has its zero where it was mounted; taken at the rest length, a gain that is off by a share puts the force off by
    /// that share.
    fn zero(&self) -> f64;

    /// dF/dl of an estimate by a length, taken directly or by an inductance \[N/m\]; `None` where the force itself is seen.
    fn slope(&self) -> Option<f64>;

    /// By which share what it watches grows for each share by which the spring's metal does, its ends where they are \[1\]: none but for an inductance.
    fn expands(&self, reading: f64) -> f64 {
        let _ = reading;
        0.0
    }

    /// What it errs by of its own, beyond [`super::Limits`] and [`super::SpringDoubt`]; nothing for most.
    fn own_causes(&self, site: &Site<'_>) -> Vec<Cause> {
        let _ = site;
        Vec::new()
    }
}
