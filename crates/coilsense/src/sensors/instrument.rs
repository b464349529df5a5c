//! A sensor on a spring with what its instrument makes of a signal over time, ready to read.
//!
//! Next door: the sensor itself (`sensor`, and one file a kind), the instrument's dynamics, noise and steps (`readout`), what its force
//! errs by (`measurement`).

use std::borrow::Cow;
use std::sync::Arc;

use super::Cause;
use super::readout::Readout;
use super::sensor::{Sensor, Site};
use crate::error::Error;
use crate::signals::Signals;

/// A sensor on a spring in a condition of use: from signals to its readings, and from readings to a force.
///
/// ```
/// use coilsense::inductance::{MaxwellSum, SelfDistance};
/// use coilsense::sensors::{Instrument, Quantity, Readout, ReadoutParameters, Site};
/// # let spring = coilsense::Spring::new(coilsense::SpringParameters { rest_length: 0.104, windings: 52.0,
/// #     coil_radius: 0.008, wire_radius: 0.001, mass: 0.065, stiffness: 760.0, min_length: 0.196,
/// #     max_length: 0.264, nominal_force: None, inductance_windings: None, sections: None })?;
///
/// let coil = MaxwellSum::new(&spring, SelfDistance::default());
/// let site = Site { spring: &spring, coil: &coil, mean_length: 0.23 };
/// let laser = Instrument::new(Readout::new(ReadoutParameters::default())?, Quantity::Deflection.on(&site)?);
/// assert!((laser.force(0.204) - 76.0).abs() < 1e-12);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Instrument {
    readout: Readout,
    sensor: Arc<dyn Sensor>,
}

impl Instrument {
    /// A sensor and its dynamics.
    pub fn new(readout: Readout, sensor: Arc<dyn Sensor>) -> Self {
        Self { readout, sensor }
    }

    /// How it answers over frequency.
    pub fn readout(&self) -> &Readout {
        &self.readout
    }

    /// What it watches, in its native unit, shape `samples`.
    ///
    /// # Errors
    /// [`Error::MissingSignal`] where a signal that it needs is not there.
    pub fn quantity<'a>(&self, signals: &'a Signals) -> Result<Cow<'a, [f64]>, Error> {
        self.sensor.quantity(signals)
    }

    /// The force \[N\] that a reading means.
    pub fn force(&self, reading: f64) -> f64 {
        self.sensor.force_of(reading)
    }

    /// The forces \[N\] that readings mean, shape `samples`.
    pub fn forces(&self, readings: &[f64]) -> Vec<f64> {
        readings.iter().map(|&reading| self.force(reading)).collect()
    }

    /// The reading that an error of the gain leaves as it is, in the native unit ([`Sensor::zero`]).
    pub fn zero(&self) -> f64 {
        self.sensor.zero()
    }

    /// dF/dl of an estimate by a length \[N/m\]; `None` where the force itself is seen ([`Sensor::slope`]).
    pub fn slope(&self) -> Option<f64> {
        self.sensor.slope()
    }

    /// How it sees the spring's metal expand, at a reading in its native unit ([`Sensor::expands`]).
    pub fn expands(&self, reading: f64) -> f64 {
        self.sensor.expands(reading)
    }

    /// What its kind errs by of its own ([`Sensor::own_causes`]).
    pub(super) fn own_causes(&self, site: &Site<'_>) -> Vec<Cause> {
        self.sensor.own_causes(site)
    }

    /// What it reads over all of `signals`, in its native unit, without noise and resolution.
    ///
    /// # Errors
    /// As [`Self::quantity`].
    pub fn steady_readings(&self, signals: &Signals) -> Result<Vec<f64>, Error> {
        self.steady_readings_of(signals.time(), &self.quantity(signals)?)
    }

    /// The same of the quantity that it watches, shape `times`.
    ///
    /// # Errors
    /// Those of [`Readout::ideal_series`].
    pub fn steady_readings_of(&self, times: &[f64], quantity: &[f64]) -> Result<Vec<f64>, Error> {
        self.readout.ideal_series(times, quantity)
    }
}
