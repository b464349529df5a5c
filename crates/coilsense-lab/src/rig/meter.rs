//! What the LCR meter reads in a run: means of the inductance of all windings where they are.
//!
//! Next door: the fast record (`log`), how the spring moves (`course`), the sum over windings (`coilsense::inductance`).

use coilsense::Motion;
use coilsense::inductance::OverLength;
use rand_pcg::Pcg64;

use super::course::{Course, resting};
use super::plan::{MOVING, READINGS, RESTING, averaging, calibration_step, reading_interval};
use super::sheet::{Column, Sheet};
use super::{Kind, Rig, RigError, Run};

impl Rig {
    /// Readings of the LCR meter.
    pub(super) fn slow(
        &self,
        run: &Run,
        course: &Course,
        lead: f64,
        fast: [&[f64]; 2],
        randomness: &mut Pcg64,
    ) -> Result<Sheet, RigError> {
        let begins = self.windows(run);
        let inductance = self.inductances(course, lead, &begins).map_err(self.science(&run.name))?;
        let times: Vec<f64> = begins.iter().map(|begin| begin + averaging(&self.settings)).collect();
        let meter = &self.devices.meter;
        let inductance = meter.readings(&times, &inductance, randomness).map_err(self.science(&run.name))?;
        let decimals = meter.decimals(1e-6);
        let inductance = Column { name: "L", unit: "uH", factor: 1e-6, decimals, values: inductance };
        let mut columns = vec![Column { name: "time", unit: "s", factor: 1.0, decimals: Some(6), values: times }];
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
                let at = |begin: &f64| resting(positions, *step, *begin);
                Ok(begins.iter().map(|begin| self.coil.at_length(self.length - at(begin))).collect())
            }
            // Every window holds whole periods, so one period tells the mean of all.
            Course::Periodic { motion, period } => {
                let mean = self.mean_inductance(motion, &in_period(*period), false)?;
                Ok(vec![mean; begins.len()])
            }
            Course::Hit { motion, .. } => {
                let step = self.winding_step();
                let samples = (averaging(&self.settings) / step).ceil().max(1.0) as usize;
                let step = averaging(&self.settings) / samples as f64;
                let times = |begin: f64| {
                    (0..=samples).map(move |index| lead + begin + index as f64 * step).collect::<Vec<f64>>()
                };
                begins.iter().map(|&begin| self.mean_inductance(motion, &times(begin), true)).collect()
            }
        }
    }

    /// Mean of L over equidistant `times`; by the trapezoid rule where they hold both ends of a window that does not repeat.
    fn mean_inductance(&self, motion: &Motion, times: &[f64], trapezoid: bool) -> Result<f64, coilsense::Error> {
        let series = self.coil.series(&motion.windings(times)?);
        let (sum, count): (f64, f64) = (series.iter().sum(), series.len() as f64);
        Ok(match (trapezoid, series.as_slice()) {
            (true, [first, .., last]) => (sum - 0.5 * (first + last)) / (count - 1.0),
            _ => sum / count,
        })
    }

    /// Time from sample to sample of the windings after a hit \[s\]: four in the hit, eight in a period of the first mode.
    pub(super) fn winding_step(&self) -> f64 {
        let wanted = (0.25 * self.settings.hit_duration).min(0.125 / self.spring.surge_frequency());
        wanted.max(0.5 / self.settings.sample_rate)
    }
}

/// Times that share a period out evenly \[s\]: L follows the windings smoothly, so the mean over them is exact to rounding.
pub(super) fn in_period(period: f64) -> Vec<f64> {
    const SAMPLES: usize = 256;
    (0..SAMPLES).map(|index| period * index as f64 / SAMPLES as f64).collect()
}
