//! How late each force is read: what the spec's sensors add to the way from a force to the command.
//!
//! Next door: the loops with it (`loops`), the sensors themselves (`coilsense::sensors`).

use coilsense::sensors::{Quantity, Readout};
use coilsense::{Channel, End, Error};

use crate::spec::{ControlSpec, SensorSpec, Spec};

/// The way from a force to the command.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The quickest of the spec's sensors that measure the force; `None` where none does, and it is read at once.
    pub sensor: Option<String>,
    /// How late that tells slow changes \[s\].
    pub lag: f64,
    /// From force to command with it, the least and the most \[s\]: a loop may bear the longer better. A reading is fresh or as old as the next one;
    /// in samples these are whole numbers.
    pub delays: Vec<f64>,
    /// Where the sensor has lost 3 dB, if that is below [`CLEAR`] times the first surge frequency \[Hz\]: what a delay alone says of the surge is then
    /// no statement, and the force is fed back only where there is no other.
    pub coarse: Option<f64>,
}

/// Up to so many times the first surge frequency a sensor must show a force for its lag to stand for it.
pub const CLEAR: f64 = 3.0;

/// A lag so near a whole number of samples is one \[1\].
const WHOLE: f64 = 1e-6;

impl Reading {
    /// Of each force, as [`Channel::FORCES`].
    ///
    /// # Errors
    /// [`Error::Value`] for a readout that is none.
    pub(super) fn all(spec: &Spec, control: &ControlSpec) -> Result<Vec<Self>, Error> {
        Channel::FORCES.into_iter().map(|channel| Self::of(channel, spec, control)).collect()
    }

    fn of(channel: Channel, spec: &Spec, control: &ControlSpec) -> Result<Self, Error> {
        let mut quickest: Option<(&SensorSpec, Readout, f64)> = None;
        for sensor in spec.sensors.iter().filter(|sensor| measures(&sensor.quantity) == channel) {
            let readout = Readout::new(sensor.readout.clone())?;
            let lag = readout.lag(0.0);
            if quickest.as_ref().is_none_or(|(.., least)| lag < *least) {
                quickest = Some((sensor, readout, lag));
            }
        }
        let Some((sensor, readout, lag)) = quickest else {
            return Ok(Self { sensor: None, lag: 0.0, delays: vec![control.delay], coarse: None });
        };
        let period = sensor.readout.sample_rate.map_or(0.0, |rate| 1.0 / rate);
        let (fresh, stale) = (lag - 0.5 * period, lag + 0.5 * period);
        let (least, most) = match control.sample_time {
            None => (fresh, stale),
            Some(step) => {
                // A sensor that is quicker than the controller is read when it has something new.
                let most = if period > step { stale } else { lag };
                ((fresh / step + WHOLE).floor() * step, (most / step - WHOLE).ceil() * step)
            }
        };
        let mut delays = vec![control.delay + least, control.delay + most];
        delays.dedup_by(|one, other| (*one - *other).abs() <= WHOLE * lag);
        let bandwidth = readout.bandwidth_3db();
        let coarse = (bandwidth < CLEAR * spec.spring.spring.surge_frequency()).then_some(bandwidth);
        Ok(Self { sensor: Some(sensor.name.clone()), lag, delays, coarse })
    }
}

/// The force that a sensor gives.
fn measures(quantity: &Quantity) -> Channel {
    match quantity {
        Quantity::Force(End::One) => Channel::InputForce,
        Quantity::Force(End::Two) => Channel::OutputForce,
        Quantity::Deflection | Quantity::TwoEncoder { .. } => Channel::DeflectionForce,
        Quantity::Inductance { .. } => Channel::InductanceForce,
    }
}
