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
    /// From force to command with it \[s\]: in samples the whole numbers of them on either side, for a loop may bear the longer better.
    pub delays: Vec<f64>,
}

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
        let mut quickest: Option<(&SensorSpec, f64)> = None;
        for sensor in spec.sensors.iter().filter(|sensor| measures(&sensor.quantity) == channel) {
            let lag = Readout::new(sensor.readout.clone())?.lag(0.0);
            quickest = quickest.filter(|(_, least)| *least <= lag).or(Some((sensor, lag)));
        }
        let lag = quickest.map_or(0.0, |(_, lag)| lag);
        let delays = match control.sample_time {
            None => vec![control.delay + lag],
            Some(step) => {
                let (samples, late) = (lag / step, (control.delay / step).round());
                let near = (samples - samples.round()).abs() <= WHOLE;
                let both = if near { [samples.round(); 2] } else { [samples.floor(), samples.ceil()] };
                let each = both.map(|whole| (late + whole) * step);
                if near { vec![each[0]] } else { each.to_vec() }
            }
        };
        Ok(Self { sensor: quickest.map(|(sensor, _)| sensor.name.clone()), lag, delays })
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
