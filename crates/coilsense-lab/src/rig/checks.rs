//! What a rig cannot do, said before it is tried; and what to doubt.
//!
//! Next door: the settings (`spec::RigSpec`), what only a run shows (`clearance`).

use coilsense::{Damping, FarEnd};

use super::description::short;
use super::plan::{averaging, reading_interval};
use super::{Rig, RigError};
use crate::spec::{DampingCase, Spec};

/// Most samples that are simulated for a run: 64 MB each of time, force and position.
const MOST_SIMULATED: f64 = 8e6;
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
            let simulated = (run.duration + self.memory()) * s.sample_rate * self.finer() as f64;
            if simulated > MOST_SIMULATED {
                return Err(self.refused(format!(
                    "{simulated:.0} samples to simulate in {}: must be at most {MOST_SIMULATED:.0}; load cell and laser watch for {} s before (bandwidth, delay, averaging, sample_rate)",
                    run.name,
                    short(self.memory())
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
        if s.hits > 0 && 10.0 * s.hit_duration > s.duration / s.hits_per_run as f64 {
            let most = 0.1 * s.duration / s.hits_per_run as f64;
            return Err(self.refused(format!(
                "[rig] hit_duration = {} s: must be at most {} s, a tenth of the time from hit to hit",
                s.hit_duration,
                short(most)
            )));
        }
        Ok(())
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
