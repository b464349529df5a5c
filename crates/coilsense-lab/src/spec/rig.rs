//! The table `[rig]`: what `coilsense rig` lets run.
//!
//! Next door: the instruments (`sensor`), the runs themselves (`crate::rig`).

use coilsense::End;
use coilsense::sensors::{Kind, Quantity};

use super::SpecError;
use super::document::Document;
use super::sensor::SensorSpec;
use crate::quantity::Dimension;

/// A rig like that of the paper's experiment, in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct RigSpec {
    /// Static force about which the actuator moves \[N\].
    pub preload: f64,
    /// Samples of load cell and laser per second \[Hz\].
    pub sample_rate: f64,
    /// Of each recorded run \[s\].
    pub duration: f64,
    /// Readings of the LCR meter in a run.
    pub readings: usize,
    /// Between two recorded runs \[s\].
    pub pause: f64,
    /// How many runs with a sine.
    pub frequencies: usize,
    /// Of the sines \[m\].
    pub amplitude: f64,
    /// The second harmonic as a share of the amplitude \[1\].
    pub distortion: f64,
    /// From the first to the last position of the calibration \[m\].
    pub calibration_travel: f64,
    /// How many positions it has.
    pub calibration_positions: usize,
    /// How long the spring has been stretched before the first run \[s\].
    pub settling: f64,
    /// Share of the force lost per decade of time \[1\].
    pub relaxation: f64,
    /// How many runs with hits.
    pub hits: usize,
    /// Hits in each of them.
    pub hits_per_run: usize,
    /// How far a hit moves end 1 \[m\].
    pub hit_height: f64,
    /// How long a hit lasts \[s\].
    pub hit_duration: f64,
    /// At end 2.
    pub load_cell: SensorSpec,
    /// Of end 1's position.
    pub laser: SensorSpec,
    /// Of the spring's inductance; it has an averaging window.
    pub meter: SensorSpec,
}

/// Most hits in a run: nine jumps of velocity each are then few enough for the motion's closed form, which any window of it is quick with.
const MOST_HITS: u64 = 7;

/// Averaging window of the paper's LCR meter \[s\].
const PAPER_AVERAGING: f64 = 0.445;

impl RigSpec {
    pub(super) fn parse(document: &Document<'_>, sensors: &[SensorSpec]) -> Result<Self, SpecError> {
        let rig = Self::paper(sensors)?;
        let Some(section) = document.optional_section("rig")? else {
            return Ok(rig);
        };
        let above_zero = |key, usual, dimension| Ok(section.above_zero(key, dimension)?.unwrap_or(usual));
        let count = |key, usual, from, to| -> Result<usize, SpecError> {
            Ok(section.optional_whole(key, from, to)?.map_or(usual, |number| number as usize))
        };
        let share = |key, usual| -> Result<f64, SpecError> { Ok(section.share(key)?.unwrap_or(usual)) };
        Ok(Self {
            preload: above_zero("preload", rig.preload, Dimension::Force)?,
            sample_rate: above_zero("sample_rate", rig.sample_rate, Dimension::Frequency)?,
            duration: above_zero("duration", rig.duration, Dimension::Time)?,
            readings: count("readings", rig.readings, 1, 1_000_000)?,
            pause: section.not_negative("pause", Dimension::Time)?.unwrap_or(rig.pause),
            frequencies: count("frequencies", rig.frequencies, 0, 200)?,
            amplitude: above_zero("amplitude", rig.amplitude, Dimension::Length)?,
            distortion: share("distortion", rig.distortion)?,
            calibration_travel: above_zero("calibration_travel", rig.calibration_travel, Dimension::Length)?,
            calibration_positions: count("calibration_positions", rig.calibration_positions, 2, 1000)?,
            settling: above_zero("settling", rig.settling, Dimension::Time)?,
            relaxation: share("relaxation", rig.relaxation)?,
            hits: count("hits", rig.hits, 0, 1000)?,
            hits_per_run: count("hits_per_run", rig.hits_per_run, 1, MOST_HITS)?,
            hit_height: above_zero("hit_height", rig.hit_height, Dimension::Length)?,
            hit_duration: above_zero("hit_duration", rig.hit_duration, Dimension::Time)?,
            ..rig
        })
    }

    /// The paper's rig, with the instruments of a spec where it has them.
    ///
    /// Preload, frequencies, amplitude, rates, times, readings: `[Weijde2017]` section IV. The rest is chosen.
    fn paper(sensors: &[SensorSpec]) -> Result<Self, SpecError> {
        let of = |fits: fn(Quantity) -> bool| sensors.iter().find(|sensor| fits(sensor.quantity)).cloned();
        let mut meter = of(|quantity| quantity.of_kind() == Kind::Inductance).map_or_else(paper_meter, Ok)?;
        meter.readout.averaging.get_or_insert(PAPER_AVERAGING);
        Ok(Self {
            preload: 26.0,
            sample_rate: 2500.0,
            duration: 40.0,
            readings: 59,
            pause: 10.0,
            frequencies: 13,
            amplitude: 1e-3,
            distortion: 0.02,
            calibration_travel: 9e-3,
            calibration_positions: 11,
            settling: 120.0,
            relaxation: 2e-4,
            hits: 5,
            hits_per_run: 5,
            hit_height: 0.5e-3,
            hit_duration: 5e-3,
            load_cell: of(|quantity| quantity == Quantity::Force(End::Two)).map_or_else(paper_load_cell, Ok)?,
            laser: of(|quantity| quantity == Quantity::Deflection).map_or_else(paper_laser, Ok)?,
            meter,
        })
    }
}

/// What the paper's data acquisition tells apart, as a share of its range: 16 bits of ±10 V, of which a sensor takes 0 to 10 V.
const CONVERTER_STEP: f64 = 2.0 / 65536.0;

fn class(name: &str, quantity: Quantity, range: f64) -> Result<SensorSpec, SpecError> {
    SensorSpec::of_class(name, quantity, range).map_err(SpecError)
}

/// FUTEK LSB200 of 110 N. Noise and limits of error are chosen as typical: the paper and our catalogue have none.
fn paper_load_cell() -> Result<SensorSpec, SpecError> {
    let range = 110.0;
    let mut device = class("load cell of the paper", Quantity::Force(End::Two), range)?;
    (device.readout.noise, device.readout.resolution) = (2e-4 * range, Some(CONVERTER_STEP * range));
    (device.accuracy_full_scale, device.accuracy_reading) = (1e-3, 1e-3);
    Ok(device)
}

/// Micro-Epsilon ILD 1401-10: 10 mm. Its step is the catalogue's, which hides that of the converter; noise and limits are chosen as typical.
fn paper_laser() -> Result<SensorSpec, SpecError> {
    let mut device = class("laser distance meter of the paper", Quantity::Deflection, 10e-3)?;
    device.readout.noise = 2e-6;
    (device.accuracy_full_scale, device.accuracy_reading) = (2e-3, 1e-3);
    Ok(device)
}

/// Wayne Kerr LCR43100, read to six digits of 10 µH. Noise and limits of error are chosen as typical of its class.
fn paper_meter() -> Result<SensorSpec, SpecError> {
    let coil = Quantity::Inductance {
        uncalibrated: false,
        form: 0.0,
        form_by: coilsense::sensors::FormBy::Measured,
        remounting: 0.0,
    };
    let mut device = class("LCR meter of the paper", coil, 10e-6)?;
    (device.readout.noise, device.readout.resolution) = (0.5e-9, Some(10e-12));
    device.accuracy_reading = 1e-3;
    Ok(device)
}
