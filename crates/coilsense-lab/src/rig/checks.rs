//! What a rig cannot do, said before it is tried or as soon as it is seen; and what to doubt.
//!
//! Next door: the settings (`spec::RigSpec`), the runs (`plan`, `log`).

use coilsense::{Clash, Damping, FarEnd, Spring};

use super::course::Course;
use super::description::short;
use super::devices::Device;
use super::log::in_period;
use super::plan::{averaging, reading_interval};
use super::{Rig, RigError, Run};
use crate::spec::{DampingCase, Spec};

/// Most samples of a run, and of all: 100 MB and 5 GB of text.
const MOST_ROWS: f64 = 4e6;
const MOST_ROWS_IN_ALL: f64 = 2e8;

/// The one damping of a spec whose end 2 is held.
pub(super) fn damping(spec: &Spec) -> Result<&DampingCase, RigError> {
    let refused = |message: String| Err(RigError::Refused { file: spec.file.clone(), message });
    if spec.mount.far_end() != FarEnd::Position {
        return refused("[mount] end2 must be \"held\" for a rig, where end 2 sits on a load cell".into());
    }
    match spec.mount.cases.as_slice() {
        [case] => Ok(case),
        cases => refused(format!(
            "[mount] damping_ratio must be one value for a rig, such as 0.005, got {}",
            if spec.mount.is_band { "none".to_owned() } else { cases.len().to_string() }
        )),
    }
}

impl Rig {
    /// Settings that do not fit each other, the spring or the instruments.
    pub(super) fn check(&self) -> Result<(), RigError> {
        let s = &self.settings;
        let (window, interval) = (averaging(s), reading_interval(s));
        if window > interval {
            let most = (s.duration / window).floor();
            return Err(self.refused(format!(
                "[rig] readings = {}: must be at most {most}, since the LCR meter takes {window} s for each of those in {} s",
                s.readings, s.duration
            )));
        }
        let rows: f64 = self.runs.iter().map(|run| run.duration * s.sample_rate).sum();
        for run in &self.runs {
            let own = run.duration * s.sample_rate;
            if own > MOST_ROWS || rows > MOST_ROWS_IN_ALL {
                return Err(self.refused(format!(
                    "[rig] {own:.0} samples in {}, {rows:.0} in all: must be at most {MOST_ROWS:.0} and {MOST_ROWS_IN_ALL:.0}; lower duration or sample_rate",
                    run.name
                )));
            }
            // The second harmonic must stay below half of the sample rate.
            if 4.0 * run.frequency >= s.sample_rate {
                return Err(self.refused(format!(
                    "[rig] sample_rate = {} Hz: must be above {} Hz, four times the frequency of {}",
                    s.sample_rate,
                    short(4.0 * run.frequency),
                    run.name
                )));
            }
        }
        if s.taps > 0 && 10.0 * s.tap_duration > s.duration / s.taps_per_run as f64 {
            let most = 0.1 * s.duration / s.taps_per_run as f64;
            return Err(self.refused(format!(
                "[rig] tap_duration = {} s: must be at most {} s, a tenth of the time from hit to hit",
                s.tap_duration,
                short(most)
            )));
        }
        Ok(())
    }

    /// Windings that touch are beyond the model, and no good for a spring.
    pub(super) fn check_clearance(&self, run: &Run, course: &Course) -> Result<(), RigError> {
        let closest = match course {
            Course::Resting { positions, .. } => {
                let furthest = positions.iter().copied().fold(0.0, f64::max);
                (self.length - furthest) / self.spring.chain_masses() as f64
            }
            Course::Periodic { motion, period } => self.smallest_pitch(run, motion, &in_period(*period))?,
            Course::Hit { motion, times } => {
                let (step, until) =
                    (0.25 * self.winding_step(), 1.2 * self.settings.tap_duration + 2.0 * transit(&self.spring));
                let after = |begin: f64| {
                    let samples = (until / step).ceil().min(1e5) as usize;
                    (0..samples).map(|index| begin + index as f64 * step).collect::<Vec<f64>>()
                };
                let mut least = f64::INFINITY;
                for &begin in times {
                    least = least.min(self.smallest_pitch(run, motion, &after(begin))?);
                }
                least
            }
        };
        if closest > self.contact_pitch {
            return Ok(());
        }
        let (key, value) = self.size_of(run);
        Err(self.refused(format!(
            "[rig] {key} = {} mm closes the coil in {}: windings come within {:.4} mm and touch at {:.4} mm; lower it, or raise preload or damping",
            short(1e3 * value),
            run.name,
            1e3 * closest,
            1e3 * self.contact_pitch
        )))
    }

    fn smallest_pitch(&self, run: &Run, motion: &coilsense::Motion, times: &[f64]) -> Result<f64, RigError> {
        let windings = motion.windings(times).map_err(self.science(&run.name))?;
        // Where it is in contact is of no interest here, so that no moment of contact is looked for.
        let clash =
            Clash::seen(motion, times, &windings, f64::MIN_POSITIVE.max(1e-9)).map_err(self.science(&run.name))?;
        Ok(clash.smallest_pitch)
    }

    /// The key that makes a run's motion large, and its value \[m\].
    fn size_of(&self, run: &Run) -> (&'static str, f64) {
        match run.kind {
            super::Kind::Calibration | super::Kind::Preload => ("calibration_travel", self.settings.calibration_travel),
            super::Kind::Harmonic => ("amplitude", self.settings.amplitude),
            super::Kind::Tap => ("tap_height", self.settings.tap_height),
        }
    }

    /// An instrument shows nothing beyond its range: a load cell's is either way, a laser's has the preload in its middle.
    pub(super) fn check_range(
        &self,
        run: &Run,
        device: &Device,
        values: &[f64],
        quantity: &str,
    ) -> Result<(), RigError> {
        let (least, most) = values.iter().fold((0.0_f64, 0.0_f64), |(a, b), &v| (a.min(v), b.max(v)));
        let (limit, unit, factor) =
            if quantity == "u1" { (0.5 * device.range, "mm", 1e3) } else { (device.range, "N", 1.0) };
        let furthest = most.max(-least);
        if furthest <= limit {
            return Ok(());
        }
        let (key, value) = self.size_of(run);
        Err(self.refused(format!(
            "{quantity} reaches {:.4} {unit} in {}, and {:?} shows at most {} {unit}; lower [rig] {key} = {} mm or take a wider range",
            factor * furthest,
            run.name,
            device.name,
            short(factor * limit),
            short(1e3 * value)
        )))
    }

    /// What the numbers do not show by themselves.
    pub(super) fn doubts(&self) -> Vec<String> {
        let mut doubts = Vec::new();
        let undamped = match self.mount.damping() {
            Damping::None => true,
            Damping::Modal(ratio) => *ratio == 0.0,
            Damping::ModalEach(ratios) => ratios.contains(&0.0),
            Damping::MassProportional { rate } => *rate == 0.0,
            Damping::StiffnessProportional { time } => *time == 0.0,
            Damping::Hysteretic { .. } => false,
        };
        if undamped {
            let text = "without damping a resonance never settles: the sines are shown as a vanishing damping would leave them, and hits ring on for ever";
            doubts.push(text.into());
        }
        if self.settings.frequencies > 0 && self.settings.distortion == 0.0 {
            let text = "without distortion no sine has a second harmonic: half of the first surge frequency does not make the spring surge";
            doubts.push(text.into());
        }
        doubts
    }
}

fn transit(spring: &Spring) -> f64 {
    spring.transit_time()
}
