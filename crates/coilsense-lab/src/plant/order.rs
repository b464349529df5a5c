//! A plant of as many modes as were asked for, or as few as an error needs.
//!
//! Next door: what was asked for (`request`), the error of the forces (`coilsense::plant`), F_L (`windings`).

use coilsense::plant::{ModalPlant, Order};
use coilsense::{Error, Mount, Spring};

use super::windings::Meter;
use super::{PlantError, Request, percent};

/// A spring on its mount about a length, and a meter of its inductance where F_L is wanted.
pub(super) struct Wanted<'a> {
    pub file: &'a str,
    pub spring: &'a Spring,
    pub mount: &'a Mount,
    pub mean_length: f64,
    pub meter: Option<&'a Meter>,
}

impl Wanted<'_> {
    /// The plant, with the bandwidth and the error up to there where a bandwidth was told.
    ///
    /// # Errors
    /// [`PlantError`] for modes too few for the error that is wanted, saying how many it takes.
    pub fn plant(&self, request: &Request) -> Result<(ModalPlant, Option<(f64, f64)>), PlantError> {
        let science = PlantError::science(self.file);
        let Some(bandwidth) = request.bandwidth else {
            return Ok((self.made(request.order()).map_err(science)?, None));
        };
        let found = match (request.modes, request.error) {
            (None, Some(error)) => self.fewest(error, bandwidth).map_err(&science)?,
            _ => self.made(request.order()).map_err(&science)?,
        };
        let left = self.error(&found, bandwidth).map_err(&science)?;
        if let Some(wanted) = request.error
            && left > wanted
        {
            let enough = self.fewest(wanted, bandwidth).map_err(&science)?.kept();
            let left = if left.is_finite() { format!("an error of {}", percent(left)) } else { "modes out".to_owned() };
            let told = format!("modes = {} leaves {left} up to {bandwidth} Hz", found.kept());
            return Err(PlantError::Spec(format!("{}: {told}: {} takes {enough} modes", self.file, percent(wanted))));
        }
        Ok((found, Some((bandwidth, left))))
    }

    fn made(&self, order: Order) -> Result<ModalPlant, Error> {
        ModalPlant::new(self.spring, self.mount, self.mean_length, order)
    }

    /// Of F_i, F_o and F_x, and of F_L where it is wanted.
    fn error(&self, plant: &ModalPlant, bandwidth: f64) -> Result<f64, Error> {
        let forces = plant.error(bandwidth)?;
        let Some(meter) = self.meter else { return Ok(forces) };
        Ok(forces.max(plant.coil_error(&meter.coil, meter.calibration, bandwidth)?))
    }

    /// As few modes as an error needs.
    fn fewest(&self, error: f64, bandwidth: f64) -> Result<ModalPlant, Error> {
        let mut plant = self.made(Order::Within { error, bandwidth })?;
        while plant.kept() < plant.available() && self.error(&plant, bandwidth)? > error {
            plant = self.made(Order::Modes(plant.kept() + 1))?;
        }
        Ok(plant)
    }
}
