//! The three instruments, each with the errors that this one has: dynamics, gain, offset, noise, steps.
//!
//! Next door: what they are by the spec (`spec::SensorSpec`), what they watch (`course`).

use coilsense::Error;
use coilsense::sensors::{Readout, ReadoutParameters};
use rand::RngExt;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;

use crate::spec::{RigSpec, SensorSpec};

/// Load cell, laser and LCR meter of a rig.
#[derive(Debug, Clone)]
pub(super) struct Devices {
    pub load_cell: Device,
    pub laser: Device,
    pub meter: Device,
}

/// An instrument: a specimen of what its data sheet says.
#[derive(Debug, Clone)]
pub(super) struct Device {
    pub name: String,
    /// Full scale, in its native unit.
    pub range: f64,
    /// Low-pass, delay, averaging, its own sampling.
    pub dynamics: Readout,
    /// Noise and steps.
    pub digits: Readout,
    gain: f64,
    offset: f64,
}

impl Devices {
    pub(super) fn new(settings: &RigSpec, randomness: &mut Pcg64) -> Result<Self, Error> {
        Ok(Self {
            load_cell: Device::new(&settings.load_cell, settings.sample_rate, randomness)?,
            laser: Device::new(&settings.laser, settings.sample_rate, randomness)?,
            meter: Device::of_means(&settings.meter, randomness)?,
        })
    }
}

impl Device {
    /// An instrument recorded at `rate` \[Hz\]. What it samples faster than that is as if it were asked at each sample of the record.
    fn new(sensor: &SensorSpec, rate: f64, randomness: &mut Pcg64) -> Result<Self, Error> {
        let p = &sensor.readout;
        let sample_rate = p.sample_rate.filter(|own| *own < rate);
        let dynamics = ReadoutParameters { noise: 0.0, resolution: None, sample_rate, ..p.clone() };
        let digits = ReadoutParameters { noise: p.noise, resolution: p.resolution, sample_rate, ..Default::default() };
        Self::specimen(sensor, dynamics, digits, randomness)
    }

    /// The LCR meter, whose window and rate are the plan's: each reading has noise of its own.
    fn of_means(sensor: &SensorSpec, randomness: &mut Pcg64) -> Result<Self, Error> {
        let p = &sensor.readout;
        let digits = ReadoutParameters { noise: p.noise, resolution: p.resolution, ..Default::default() };
        Self::specimen(sensor, ReadoutParameters::default(), digits, randomness)
    }

    /// Limits of error are those of a uniform distribution, a calibration's uncertainty is the standard deviation of a normal one.
    fn specimen(
        sensor: &SensorSpec,
        dynamics: ReadoutParameters,
        digits: ReadoutParameters,
        randomness: &mut Pcg64,
    ) -> Result<Self, Error> {
        let [full_scale, reading]: [f64; 2] = [(); 2].map(|()| randomness.random_range(-1.0..=1.0));
        let calibration: f64 = StandardNormal.sample(randomness);
        Ok(Self {
            name: sensor.name.clone(),
            range: sensor.range,
            dynamics: Readout::new(dynamics)?,
            digits: Readout::new(digits)?,
            gain: 1.0 + sensor.accuracy_reading * reading + sensor.calibration_uncertainty * calibration,
            offset: sensor.accuracy_full_scale * sensor.range * full_scale,
        })
    }

    /// How long before a record the instrument must watch, for its record to begin as it goes on \[s\]; zero where it has no memory.
    pub(super) fn memory(&self) -> f64 {
        let p = self.dynamics.parameters();
        // A low-pass of order 8 has forgotten a start by e^(−2π·20·0.195) after twenty periods of its corner.
        let filter = p.bandwidth.map_or(0.0, |bandwidth| 20.0 / bandwidth);
        filter + p.delay + p.averaging.unwrap_or(0.0) + p.sample_rate.map_or(0.0, f64::recip)
    }

    /// What it shows at `times` where it has the `values` behind its dynamics.
    pub(super) fn readings(&self, times: &[f64], values: &[f64], randomness: &mut Pcg64) -> Result<Vec<f64>, Error> {
        let off: Vec<f64> = values.iter().map(|value| self.gain * value + self.offset).collect();
        self.digits.series(times, &off, randomness.random())
    }

    /// Decimals that tell its readings apart where a unit is `unit` of the native one; `None` where it rounds nothing, so that all count.
    pub(super) fn decimals(&self, unit: f64) -> Option<usize> {
        let p = self.digits.parameters();
        let step = p.resolution.or((p.noise > 0.0).then_some(0.1 * p.noise))? / unit;
        let decimals = (-step.log10() - 1e-9).ceil().max(0.0);
        let whole = step * 10_f64.powf(decimals);
        let more = if (whole - whole.round()).abs() < 1e-9 { 0 } else { 1 };
        Some((decimals as usize + more).min(15))
    }
}
