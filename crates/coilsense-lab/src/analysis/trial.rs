//! Sensors that the spec does not have, tried on all springs.
//!
//! Next door: which are tried (`fix`), how a sensor is judged (`judge`).

use coilsense::Error;
use coilsense::sensors::Readout;

use super::band;
use super::judge::{Judge, Over};
use super::moments::Moments;
use crate::spec::SensorSpec;

/// A sensor tried out, which meets the goal.
pub(super) struct Trial {
    /// The largest combined uncertainty \[N\].
    pub combined: f64,
    /// How much later the force comes \[s\].
    pub lag: f64,
}

impl Judge<'_> {
    /// Sensors that the analysis does not have, tried on all springs: the largest combined uncertainty of each, and whether it reaches the
    /// wanted bandwidth; `None` for those that the nominal spring rules out.
    pub fn trial(&self, sensor: &SensorSpec) -> Result<Option<Trial>, Error> {
        let Some(goal) = self.spec.goal.error else { return Ok(None) };
        let readout = Readout::new(sensor.readout.clone())?;
        let wanted = self.spec.goal.bandwidth;
        if wanted.is_some_and(|wanted| readout.bandwidth_3db() < wanted) {
            return Ok(None);
        }
        let (mut combined, mut raw) = (0.0_f64, 0.0_f64);
        for over_springs in [false, true] {
            (combined, raw) = (0.0, 0.0);
            for case in self.cases {
                let instrument = self.instrument(sensor, case.condition)?;
                let scene = case.scene(sensor, &self.spec.goal);
                let steady = instrument.forces(&instrument.steady_readings(scene.seen)?);
                let counted = self.counted(scene, &steady)?;
                let responses = match over_springs {
                    true => {
                        let beside = self.beside(sensor, &instrument, scene)?;
                        let known = [(beside, Moments::of(&counted.errors))];
                        let (of, specimens) = ((case.condition, case.damping), &self.springs.specimens);
                        Some(self.responses(of, &[sensor], &known, specimens)?)
                    }
                    false => None,
                };
                let over = responses.as_ref().map(|responses| Over { responses, sensor: 0 });
                let assessment = self.assessment(sensor, &instrument, scene, counted, over)?;
                if assessment.combined > goal {
                    return Ok(None);
                }
                (combined, raw) = (combined.max(assessment.combined), raw.max(assessment.raw));
            }
        }
        let behind = if raw > goal { band::lag(wanted) } else { 0.0 };
        Ok(Some(Trial { combined, lag: readout.lag(wanted.unwrap_or(0.0)) + behind }))
    }
}
