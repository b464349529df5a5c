//! How far a run may go: windings must not touch, instruments must not saturate.
//!
//! Next door: what is seen before anything runs (`checks`).

use coilsense::{Clash, Motion};

use super::course::Course;
use super::description::short;
use super::devices::Device;
use super::meter::in_period;
use super::{Kind, Rig, RigError, Run};

impl Rig {
    /// Windings that touch are beyond the model, and no good for a spring.
    pub(super) fn check_clearance(&self, run: &Run, course: &Course) -> Result<(), RigError> {
        let closest = match course {
            Course::Resting { positions, .. } => {
                let furthest = positions.iter().copied().fold(0.0, f64::max);
                (self.length - furthest) / self.spring.whole_windings() as f64
            }
            Course::Periodic { motion, period } => self.smallest_pitch(run, motion, &in_period(*period))?,
            Course::Hit { motion, times } => {
                let (step, until) =
                    (0.25 * self.winding_step(), 1.2 * self.settings.hit_duration + 2.0 * self.spring.transit_time());
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
        // Of the chain, which may carry dead windings, to active windings, which touch at the wire's diameter.
        let wire = self.spring.wire_diameter();
        let gap = (closest - self.contact_pitch) * self.spring.whole_windings() as f64 / self.spring.windings();
        Err(self.refused(format!(
            "[rig] {key} = {} mm closes the coil in {}: windings come within {:.4} mm and touch at {:.4} mm; lower it, or raise preload or damping",
            short(1e3 * value),
            run.name,
            1e3 * (wire + gap),
            1e3 * wire
        )))
    }

    fn smallest_pitch(&self, run: &Run, motion: &Motion, times: &[f64]) -> Result<f64, RigError> {
        let windings = motion.windings(times).map_err(self.science(&run.name))?;
        let clash = Clash::seen(motion, times, &windings, self.contact_pitch).map_err(self.science(&run.name))?;
        Ok(clash.smallest_pitch)
    }

    /// The key that makes a run's motion large, and its value \[m\].
    fn size_of(&self, run: &Run) -> (&'static str, f64) {
        match run.kind {
            Kind::Calibration | Kind::Preload => ("calibration_travel", self.settings.calibration_travel),
            Kind::Harmonic => ("amplitude", self.settings.amplitude),
            Kind::Hit => ("hit_height", self.settings.hit_height),
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
}
