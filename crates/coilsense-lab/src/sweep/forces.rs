//! How far each of the paper's forces is off in one condition under one damping: only the judged window is computed.
//!
//! Next door: what is made of it (`design`), the same with sensors, spectra and all signals (`crate::analysis`).

use coilsense::inductance::MaxwellSum;
use coilsense::sensors::deflection_force;
use coilsense::signals::sampled_window;
use coilsense::{Calibration, Channel, Clash, Deviation, Error, InductanceSensor, Motion};

use super::column::{BY_INDUCTANCE, Needs};
use crate::spec::Core;

/// L is taken to second order where that is within this share of it.
const TOLERANCE: f64 = 1e-6;

/// One condition under one damping.
#[derive(Debug, Clone, Default)]
pub(super) struct Judged {
    /// Of each of [`Channel::FORCES`] that is asked for \[N\].
    pub deviations: [Option<Deviation>; 4],
    /// How many samples of L took the second-order form, and how many the exact sum.
    pub methods: [usize; 2],
    /// The largest stated bound of L, as a share of it.
    pub bound: f64,
    /// How near windings come, where the positions had to be looked at.
    pub clash: Option<Clash>,
}

/// Judges a condition under a damping.
pub(super) fn judge(
    core: &Core,
    coil: Option<&MaxwellSum>,
    condition: usize,
    damping: usize,
    needs: &Needs,
) -> Result<Judged, Error> {
    let asked = &core.conditions[condition];
    let spring = &core.spring.spring;
    let motion = Motion::mounted(spring, &core.mount.cases[damping].mount, &asked.excitation)?;
    let mut judged = Judged { clash: clash(core, &motion, condition, needs)?, ..Judged::default() };
    if needs.forces == [false; 4] {
        return Ok(judged);
    }
    let times = sampled_window(asked.sample_rate, asked.window.0, asked.window.1)?;
    let forces = motion.end_forces(&times)?;
    let by_deflection = || {
        let (u1, u2): (Vec<f64>, Vec<f64>) = motion.ends(&times)?.into_iter().map(<(f64, f64)>::from).unzip();
        deflection_force(spring, &u1, &u2)
    };
    let deflection = match needs.forces[2] || core.goal.force == Channel::DeflectionForce {
        true => by_deflection()?,
        false => Vec::new(),
    };
    let series = [forces.input.as_slice(), forces.output.as_slice(), deflection.as_slice()];
    let truth = Channel::FORCES.iter().position(|force| *force == core.goal.force);
    let truth = series[truth.unwrap_or(2)];
    for (index, series) in series.into_iter().enumerate().filter(|(index, _)| needs.forces[*index]) {
        judged.deviations[index] = Some(Deviation::between(series, truth)?);
    }
    if let Some(coil) = coil.filter(|_| needs.forces[BY_INDUCTANCE]) {
        let windings = motion.windings(&times)?;
        let inductance = coil.series_within(&windings, TOLERANCE)?;
        let calibration = Calibration::theoretical(spring, coil, asked.excitation.mean_length())?;
        let samples: Vec<f64> = inductance.samples.iter().map(|sample| sample.inductance).collect();
        let force = InductanceSensor::new(spring, calibration).force(&samples);
        judged.deviations[BY_INDUCTANCE] = Some(Deviation::between(&force, truth)?);
        judged.methods = [inductance.second_order, inductance.exact];
        judged.bound = inductance.samples.iter().map(|sample| sample.bound / sample.inductance).fold(0.0, f64::max);
    }
    Ok(judged)
}

/// Whether windings touch from t = 0 to the end of the judged window.
fn clash(core: &Core, motion: &Motion, condition: usize, needs: &Needs) -> Result<Option<Clash>, Error> {
    let asked = &core.conditions[condition];
    let contact = core.spring.contact_pitch();
    if !needs.pitch && Clash::excluded(motion, asked.window.1, contact) {
        return Ok(None);
    }
    let times = sampled_window(asked.sample_rate, 0.0, asked.window.1)?;
    Clash::seen(motion, &times, &motion.windings(&times)?, contact).map(Some)
}
