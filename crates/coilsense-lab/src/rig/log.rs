//! What the instruments record of a run.
//!
//! Next door: how the spring moves (`course`), what limits each instrument (`devices`), the files (`write`).

use coilsense::Motion;

use super::course::Course;
use super::devices::Device;
use super::plan::{MOVING, READINGS, RESTING, averaging, calibration_step, reading_interval};
use super::sheet::{Column, Sheet};
use super::{Kind, Rig, RigError, Run};

/// What is recorded of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Log {
    /// Load cell and laser: `time`, `F_o`, `u1`.
    pub fast: Sheet,
    /// LCR meter: `time` at which a reading's window ends, `L`; of a calibration also the means of `u1` and `F_o` over that window.
    pub slow: Sheet,
}

/// Samples simulated for each recorded one where an instrument has dynamics of its own, so that motion is straight between them.
const FINER: usize = 8;

impl Rig {
    /// Lets a run run, by its number in [`Self::runs`], and records it.
    ///
    /// # Errors
    /// [`RigError`] where the coil closes, a reading is beyond an instrument's range, or the science refuses a value.
    pub fn log(&self, number: usize) -> Result<Log, RigError> {
        let Some(run) = self.runs.get(number) else {
            return Err(self.refused(format!("run {number} is not there; there are {}", self.runs.len())));
        };
        let mut randomness = self.randomness(number);
        let memory = self.devices.load_cell.memory().max(self.devices.laser.memory());
        let rate = self.settings.sample_rate;
        let lead = (memory * rate).ceil();
        let course = self.course(run, lead / rate, &mut randomness).map_err(self.science(&run.name))?;
        self.check_clearance(run, &course)?;

        let finer = if memory > 0.0 { FINER } else { 1 };
        let rows = (run.duration * rate).round().max(1.0) as usize;
        let count = (lead as usize + rows - 1) * finer + 1;
        let times: Vec<f64> = (0..count).map(|index| index as f64 / (rate * finer as f64)).collect();
        let (u1, force) = self.ends(&course, &times).map_err(self.science(&run.name))?;
        let recorded: Vec<f64> = (0..rows).map(|row| row as f64 / rate).collect();
        let mut read = |device: &Device, values: &[f64], quantity: &str| -> Result<Vec<f64>, RigError> {
            self.check_range(run, device, values, quantity)?;
            let seen = device.dynamics.ideal_series(&times, values).map_err(self.science(&run.name))?;
            let kept: Vec<f64> = seen[lead as usize * finer..].iter().step_by(finer).copied().collect();
            device.readings(&recorded, &kept, &mut randomness).map_err(self.science(&run.name))
        };
        let force = self.relaxed(run, &times, lead / rate, force);
        let (force, u1) = (read(&self.devices.load_cell, &force, "F_o")?, read(&self.devices.laser, &u1, "u1")?);
        let slow = self.slow(run, &course, lead / rate, [&u1, &force], &mut randomness)?;
        let columns = vec![time(recorded, rate), self.force_column(force, 0), self.position_column(u1, 0)];
        Ok(Log { fast: Sheet { columns }, slow })
    }

    /// The force less what the spring has lost since the first run began.
    fn relaxed(&self, run: &Run, times: &[f64], lead: f64, mut force: Vec<f64>) -> Vec<f64> {
        for (force, time) in force.iter_mut().zip(times) {
            *force -= self.settings.preload * self.relaxation.lost_share((run.begin + time - lead).max(0.0));
        }
        force
    }

    /// Readings of the LCR meter.
    fn slow(
        &self,
        run: &Run,
        course: &Course,
        lead: f64,
        fast: [&[f64]; 2],
        randomness: &mut rand_pcg::Pcg64,
    ) -> Result<Sheet, RigError> {
        let begins = self.windows(run);
        let inductance = self.inductances(course, lead, &begins).map_err(self.science(&run.name))?;
        let times: Vec<f64> = begins.iter().map(|begin| begin + averaging(&self.settings)).collect();
        let meter = &self.devices.meter;
        let inductance = meter.readings(&times, &inductance, randomness).map_err(self.science(&run.name))?;
        let decimals = meter.decimals(1e-6);
        let inductance = Column { name: "L", unit: "uH", factor: 1e-6, decimals, values: inductance };
        let mut columns = vec![Column { name: "time", unit: "s", factor: 1.0, decimals: Some(3), values: times }];
        if run.kind == Kind::Calibration {
            let [u1, force] = fast.map(|series| begins.iter().map(|&begin| self.mean_from(series, begin)).collect());
            columns.extend([self.position_column(u1, 1), self.force_column(force, 1)]);
        }
        columns.push(inductance);
        Ok(Sheet { columns })
    }

    /// When each of the LCR meter's windows begins, counted from the record's begin \[s\].
    fn windows(&self, run: &Run) -> Vec<f64> {
        let interval = reading_interval(&self.settings);
        if run.kind != Kind::Calibration {
            return (0..self.settings.readings).map(|index| index as f64 * interval).collect();
        }
        let first = |position: usize| position as f64 * calibration_step(&self.settings) + MOVING + RESTING;
        let positions = 0..self.settings.calibration_positions;
        positions.flat_map(|p| (0..READINGS).map(move |index| first(p) + index as f64 * interval)).collect()
    }

    /// Mean of a recorded series over a window of the LCR meter.
    fn mean_from(&self, series: &[f64], begin: f64) -> f64 {
        let sample = |time: f64| ((time * self.settings.sample_rate).round() as usize).min(series.len());
        let first = sample(begin).min(series.len().saturating_sub(1));
        let window = &series[first..sample(begin + averaging(&self.settings)).max(first + 1)];
        window.iter().sum::<f64>() / window.len() as f64
    }

    /// Mean inductance \[H\] over each window.
    fn inductances(&self, course: &Course, lead: f64, begins: &[f64]) -> Result<Vec<f64>, coilsense::Error> {
        match course {
            Course::Resting { positions, step } => {
                let at = |begin: &f64| super::course::resting(positions, *step, *begin);
                Ok(begins.iter().map(|begin| self.coil.at_length(self.length - at(begin))).collect())
            }
            // Every window holds whole periods, so one period tells the mean of all.
            Course::Periodic { motion, period } => {
                let mean = self.mean_inductance(motion, &in_period(*period), false)?;
                Ok(vec![mean; begins.len()])
            }
            Course::Hit { motion, .. } => {
                let step = self.winding_step();
                let samples = (averaging(&self.settings) / step).ceil() as usize;
                let step = averaging(&self.settings) / samples as f64;
                let times = |begin: f64| (0..=samples).map(move |index| lead + begin + index as f64 * step).collect();
                begins.iter().map(|&begin| self.mean_inductance(motion, &times(begin), true)).collect()
            }
        }
    }

    /// Mean of L over equidistant `times`; by the trapezoid rule where they hold both ends of a window that does not repeat.
    fn mean_inductance(&self, motion: &Motion, times: &Vec<f64>, trapezoid: bool) -> Result<f64, coilsense::Error> {
        let series = self.coil.series(&motion.windings(times)?);
        let (sum, count): (f64, f64) = (series.iter().sum(), series.len() as f64);
        Ok(match (trapezoid, series.as_slice()) {
            (true, [first, .., last]) => (sum - 0.5 * (first + last)) / (count - 1.0),
            _ => sum / count,
        })
    }

    /// Time from sample to sample of the windings after a hit \[s\]: four in the hit, eight in a period of the first mode.
    pub(super) fn winding_step(&self) -> f64 {
        let wanted = (0.25 * self.settings.tap_duration).min(0.125 / self.spring.surge_frequency());
        wanted.max(0.5 / self.settings.sample_rate)
    }

    fn force_column(&self, values: Vec<f64>, more: usize) -> Column {
        let decimals = self.devices.load_cell.decimals(1.0).map(|decimals| decimals + more);
        Column { name: "F_o", unit: "N", factor: 1.0, decimals, values }
    }

    fn position_column(&self, values: Vec<f64>, more: usize) -> Column {
        let decimals = self.devices.laser.decimals(1e-3).map(|decimals| decimals + more);
        Column { name: "u1", unit: "mm", factor: 1e-3, decimals, values }
    }
}

/// Times that share a period out evenly \[s\]: L follows the windings smoothly, so the mean over them is exact to rounding.
pub(super) fn in_period(period: f64) -> Vec<f64> {
    const SAMPLES: usize = 256;
    (0..SAMPLES).map(|index| period * index as f64 / SAMPLES as f64).collect()
}

/// The fast record's clock: as many decimals as a sample takes, at most to the nanosecond.
fn time(values: Vec<f64>, rate: f64) -> Column {
    let whole = |decimals: &usize| {
        let step = 10_f64.powi(*decimals as i32) / rate;
        (step - step.round()).abs() < 1e-9 * step.max(1.0) && step >= 0.5
    };
    let decimals = (0..9).find(whole).unwrap_or(9);
    Column { name: "time", unit: "s", factor: 1.0, decimals: Some(decimals), values }
}
