//! What the instruments record of a run.
//!
//! Next door: how the spring moves (`course`), the LCR meter's part (`meter`), what limits each instrument (`devices`), the files (`write`).

use super::devices::Device;
use super::sheet::{Column, Sheet};
use super::{Rig, RigError, Run};

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
        let (memory, finer) = (self.memory(), self.finer());
        let rate = self.settings.sample_rate;
        let lead = (memory * rate).ceil();
        let course = self.course(run, lead / rate, &mut randomness).map_err(self.science(&run.name))?;
        self.check_clearance(run, &course)?;

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

    /// How long load cell and laser must watch before a record begins \[s\].
    pub(super) fn memory(&self) -> f64 {
        self.devices.load_cell.memory().max(self.devices.laser.memory())
    }

    /// Samples that are simulated for each that is recorded.
    pub(super) fn finer(&self) -> usize {
        if self.memory() > 0.0 { FINER } else { 1 }
    }

    /// The force less what the spring has lost since the first run began.
    fn relaxed(&self, run: &Run, times: &[f64], lead: f64, mut force: Vec<f64>) -> Vec<f64> {
        for (force, time) in force.iter_mut().zip(times) {
            *force -= self.settings.preload * self.relaxation.lost_share((run.begin + time - lead).max(0.0));
        }
        force
    }

    pub(super) fn force_column(&self, values: Vec<f64>, more: usize) -> Column {
        let decimals = self.devices.load_cell.decimals(1.0).map(|decimals| decimals + more);
        Column { name: "F_o", unit: "N", factor: 1.0, decimals, values }
    }

    pub(super) fn position_column(&self, values: Vec<f64>, more: usize) -> Column {
        let decimals = self.devices.laser.decimals(1e-3).map(|decimals| decimals + more);
        Column { name: "u1", unit: "mm", factor: 1e-3, decimals, values }
    }
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
