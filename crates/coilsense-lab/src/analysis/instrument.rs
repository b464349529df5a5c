//! A sensor on a spring, ready to read: from signals to its readings, and from readings to a force.
//!
//! Next door: what it is by the spec (`spec::SensorSpec`), its parts (`coilsense::sensors`).

use std::borrow::Cow;

use coilsense::inductance::MaxwellSum;
use coilsense::sensors::{Readout, TwoEncoder};
use coilsense::{Calibration, Channel, End, Error, InductanceSensor, Signals, Spring};

use crate::spec::{Quantity, SensorSpec};

/// A sensor on a spring in a condition of use.
#[derive(Debug, Clone)]
pub struct Instrument {
    readout: Readout,
    conversion: Conversion,
}

/// From a reading in the native unit to a force.
#[derive(Debug, Clone)]
enum Conversion {
    Force(Channel),
    Deflection(Spring),
    TwoEncoder(TwoEncoder),
    Inductance(InductanceSensor),
}

impl Instrument {
    /// A sensor on `spring`, set to zero (and eq. (13) forced through) at `mean_length` \[m\].
    ///
    /// # Errors
    /// What the science says of the sensor's values.
    pub fn new(sensor: &SensorSpec, spring: &Spring, coil: &MaxwellSum, mean_length: f64) -> Result<Self, Error> {
        let conversion = match sensor.quantity {
            Quantity::Force(End::One) => Conversion::Force(Channel::InputForce),
            Quantity::Force(End::Two) => Conversion::Force(Channel::OutputForce),
            Quantity::Deflection => Conversion::Deflection(spring.clone()),
            Quantity::TwoEncoder { compliance, backlash } => {
                Conversion::TwoEncoder(TwoEncoder::new(spring, compliance, backlash, mean_length)?)
            }
            Quantity::Inductance { .. } => {
                let calibration = Calibration::theoretical(spring, coil, mean_length)?;
                Conversion::Inductance(InductanceSensor::new(spring, calibration))
            }
        };
        Ok(Self { readout: Readout::new(sensor.readout.clone())?, conversion })
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
        let ends = || Ok::<_, Error>((signals.channel(Channel::U1)?, signals.channel(Channel::U2)?));
        Ok(match &self.conversion {
            Conversion::Force(channel) => signals.channel(*channel)?.into(),
            Conversion::Deflection(_) => {
                let (u1, u2) = ends()?;
                u1.iter().zip(u2).map(|(u1, u2)| u2 - u1).collect()
            }
            Conversion::TwoEncoder(encoders) => {
                let (u1, u2) = ends()?;
                encoders.elongation(u1, u2, signals.channel(Channel::InputForce)?)?.into()
            }
            Conversion::Inductance(_) => signals.channel(Channel::Inductance)?.into(),
        })
    }

    /// The force \[N\] that a reading means.
    pub fn force(&self, reading: f64) -> f64 {
        match &self.conversion {
            Conversion::Force(_) => reading,
            Conversion::Deflection(spring) => spring.static_force(reading),
            Conversion::TwoEncoder(encoders) => encoders.force(&[reading])[0],
            Conversion::Inductance(sensor) => sensor.force(&[reading])[0],
        }
    }

    /// The forces \[N\] that readings mean, shape `samples`.
    pub fn forces(&self, readings: &[f64]) -> Vec<f64> {
        readings.iter().map(|&reading| self.force(reading)).collect()
    }

    /// The reading that an error of the gain leaves as it is, in the native unit: none, or of a length the one that means no force.
    ///
    /// A gauge of length has its zero where it was mounted; taken at the rest length, a gain that is off by a share puts the force off by
    /// that share.
    pub fn zero(&self) -> f64 {
        match &self.conversion {
            Conversion::Deflection(spring) => spring.rest_length(),
            Conversion::TwoEncoder(encoders) => encoders.zero(),
            Conversion::Force(_) | Conversion::Inductance(_) => 0.0,
        }
    }

    /// dF/dl of its estimate \[N/m\]: the stiffness of `spring`, or of spring and drive train in series.
    pub fn stiffness(&self, spring: &Spring) -> f64 {
        match &self.conversion {
            Conversion::TwoEncoder(encoders) => encoders.stiffness(),
            _ => spring.stiffness(),
        }
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

    /// The length that the calibration reads from an inductance \[m\], and α, β; `None` for other sensors.
    pub fn calibration(&self) -> Option<&Calibration> {
        match &self.conversion {
            Conversion::Inductance(sensor) => Some(sensor.calibration()),
            _ => None,
        }
    }
}
