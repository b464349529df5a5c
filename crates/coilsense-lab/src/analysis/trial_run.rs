//! The errors of sensors on a spring that is not the nominal one: only the judged part of a run, and what a filter must have seen before.
//!
//! Next door: the whole run of the nominal spring (`case`), what is made of many springs (`response`).

use std::ops::Range;

use coilsense::sensors::{ReadoutParameters, Site};
use coilsense::signals::sampled_window;
use coilsense::{Calibration, Channel, Error};

use super::band;
use super::moments::Moments;
use super::specimen::Change;
use super::ways::changed;
use crate::spec::{SensorSpec, Spec, SpringInductance};
use crate::study::{self, Coil, Helical, Meets, Method, Setup, Simulation};

/// L to second order is good enough for how an error changes.
const ANY: f64 = 1.0;

/// What a case's responses are found for.
pub(super) struct Request<'a> {
    pub spec: &'a Spec,
    pub coil: &'a SpringInductance,
    /// What moves, where that is no chain.
    pub helix: Option<&'a Helical>,
    pub condition: usize,
    pub damping: usize,
    pub sensors: &'a [&'a SensorSpec],
    /// One per sensor: the variance \[N²\] beside which its oscillation need not be known better, and its errors on the nominal spring by
    /// the whole run.
    pub known: &'a [(f64, Moments)],
    /// The goal \[N\], where the share of springs inside it is wanted.
    pub goal: Option<f64>,
}

/// A case, ready to be run on other springs.
pub(super) struct TrialRun<'a> {
    pub asked: &'a Request<'a>,
    times: Vec<f64>,
    judged: Range<usize>,
    /// From which sample on each sensor watches: what the others remember makes no difference to it.
    begins: Vec<usize>,
    by_coil: bool,
}

impl<'a> TrialRun<'a> {
    pub fn new(asked: &'a Request<'a>) -> Result<Self, Error> {
        let condition = &asked.spec.conditions[asked.condition];
        let rate = condition.sample_rate;
        let bandwidth = asked.spec.goal.bandwidth.map_or(0.0, band::memory);
        // On the grid of the condition's own samples.
        let from = |before: f64| ((condition.window.0 - before).max(0.0) * rate).floor();
        let each = asked.sensors.iter().map(|sensor| from(memory(&sensor.readout).max(bandwidth)));
        let each: Vec<f64> = each.collect();
        let first = each.iter().copied().fold(f64::INFINITY, f64::min);
        let times = sampled_window(rate, first / rate, condition.window.1)?;
        let judged = band::judged(&times, condition.window);
        let begins = each.iter().map(|begin| (begin - first) as usize).collect();
        Ok(Self { asked, times, judged, begins, by_coil: needs_coil(asked.spec, asked.sensors) })
    }

    /// Errors of every sensor on a changed spring, as far as they count: an instrument knows the stiffness of the spring that it is on.
    pub fn moments(&self, change: Change) -> Result<Vec<Moments>, Error> {
        let asked = self.asked;
        let spring = &changed(&asked.spec.spring.spring, change)?;
        let helix = asked.helix.map(|helix| (helix, change.map(f64::exp)));
        let condition = &asked.spec.conditions[asked.condition];
        let mean_length = condition.excitation.mean_length();
        // Only how an error changes is asked, of which magnetisation is a small part.
        let sum = asked.coil.in_air();
        let coil = match self.by_coil {
            true => {
                let calibration = Calibration::theoretical(&asked.spec.spring.spring, sum, mean_length)?;
                Some(Coil { sum, steel: None, calibration, method: Method::Within(ANY) })
            }
            false => None,
        };
        let way = &asked.spec.mount.cases[asked.damping];
        let contact = way.contact.as_ref().map(|way| Meets { contact: &way.contact, apart: None });
        let (mount, excitation) = (&way.mount, &condition.excitation);
        let setup = Setup { spring, mount, excitation, coil, positions: false, helix, contact };
        let Simulation { signals, seen, .. } = study::simulate(&setup, &self.times)?;
        let goal = &asked.spec.goal;
        let truth = seen.truth(&signals, goal).channel(goal.force)?;
        let of = |(sensor, &begin): (&&crate::spec::SensorSpec, &usize)| {
            let instrument = sensor.on(&Site { spring, coil: sum, mean_length })?;
            let times = &self.times[begin..];
            let readings = instrument
                .steady_readings_of(times, &instrument.quantity(seen.by(&signals, sensor, goal))?[begin..])?;
            let forces = instrument.forces(&readings);
            let errors: Vec<f64> = forces.iter().zip(&truth[begin..]).map(|(force, truth)| force - truth).collect();
            let judged = self.judged.start - begin..self.judged.end - begin;
            let counted = band::within(&errors, times, &judged, asked.spec.goal.bandwidth)?;
            Ok(Moments::of(&counted))
        };
        asked.sensors.iter().zip(&self.begins).map(of).collect()
    }
}

/// How long ago an instrument still remembers \[s\].
fn memory(settings: &ReadoutParameters) -> f64 {
    let low_pass = settings.bandwidth.map_or(0.0, |bandwidth| band::low_pass(settings.order, bandwidth));
    low_pass + settings.delay + settings.averaging.unwrap_or(0.0) + settings.sample_rate.map_or(0.0, f64::recip)
}

/// Whether the coil's inductance is needed: the goal calls F_L true, or a sensor watches L.
pub(super) fn needs_coil(spec: &Spec, sensors: &[&SensorSpec]) -> bool {
    let by_coil = |sensor: &&SensorSpec| sensor.quantity.of_kind().watches(Channel::Inductance);
    spec.goal.force == Channel::InductanceForce || sensors.iter().any(by_coil)
}
