//! Force from a load cell at an end: it sees the force itself, oscillation of the windings included.
//!
//! Next door: forces that are estimates by a length (`deflection`, `two_encoder`, `inductance`).

use std::borrow::Cow;
use std::sync::Arc;

use super::Quantity;
use super::sensor::{Native, Row, Sensor};
use crate::error::Error;
use crate::excitation::End;
use crate::signals::{Channel, Signals};

pub(super) const ROW: Row = Row {
    word: "load-cell",
    native: Native::Force,
    watches: &[Channel::InputForce, Channel::OutputForce],
    natural_range: |spring, _| spring.nominal_force(),
};

/// A load cell at an end.
#[derive(Debug, Clone, Copy)]
struct LoadCell(Channel);

pub(super) fn at(end: End) -> Arc<dyn Sensor> {
    Arc::new(LoadCell(match end {
        End::One => Channel::InputForce,
        End::Two => Channel::OutputForce,
    }))
}

/// The other end.
pub(super) fn alternatives(end: End) -> Vec<(&'static str, Quantity)> {
    match end {
        End::One => vec![("its place at end 2", Quantity::Force(End::Two))],
        End::Two => vec![("its place at end 1", Quantity::Force(End::One))],
    }
}

impl Sensor for LoadCell {
    fn quantity<'a>(&self, signals: &'a Signals) -> Result<Cow<'a, [f64]>, Error> {
        Ok(signals.channel(self.0)?.into())
    }

    fn force_of(&self, reading: f64) -> f64 {
        reading
    }

    fn zero(&self) -> f64 {
        0.0
    }

    fn slope(&self) -> Option<f64> {
        None
    }
}
