//! Each sensor judged over all cases: its combined uncertainty, whether it meets the goal, and what breaks it.
//!
//! Next door: what is said of it (`verdict`), what makes a force uncertain (`budget`), sensors tried out (`trial`), the judgement by itself
//! (`assessed`).

use coilsense::inductance::OverLength;
use coilsense::sensors::{Instrument, MAX_ORDER, Measurement, Readout, Site};
use coilsense::{Channel, Error};

use super::band;
use super::budget::{Model, OSCILLATION, SensorBudget, doubt, with_bias};
use super::case::{Case, Scene};
use super::moments::Moments;
use super::overload::overload;
use super::rank::has_limits;
use super::response::Responses;
use super::specimen::{Specimens, Springs};
use super::spread::Spread;
use super::trial_run::Request;
use super::verdict::{Assessment, GoalFilter, Verdict};
use crate::spec::{SensorSpec, Spec, SpringInductance};
use crate::study::{Bent, Helices};

/// Share of the force in the spring below which it does not count that it bends.
const STRAIGHT_ENOUGH: f64 = 1e-9;

/// Share of a length over which L counts as straight.
const ABOUT: f64 = 1e-4;

/// What sensors are judged by.
#[derive(Clone, Copy)]
pub(super) struct Judge<'a> {
    pub spec: &'a Spec,
    pub coil: &'a SpringInductance,
    pub helices: &'a Helices,
    pub cases: &'a [Case],
    pub springs: &'a Springs,
}

impl Judge<'_> {
    /// The verdict on a sensor of the analysis; `responses` are those of all its sensors in each case.
    pub fn verdict(&self, index: usize, sensor: &SensorSpec, responses: &[Responses]) -> Result<Verdict, Error> {
        let assessments = self.assessments(index, sensor, responses)?;
        let worst = worst(&assessments);
        let budget = self.model(index, sensor, worst, responses)?.with_monte_carlo()?;
        let readout = Readout::new(sensor.readout.clone())?;
        let bandwidth = readout.bandwidth_3db();
        let wanted = self.spec.goal.bandwidth;
        let filter = self.filter(&assessments);
        Ok(Verdict {
            sensor: index,
            meets: self.meets(&assessments),
            assessments,
            worst,
            budget,
            bandwidth,
            lag: readout.lag(wanted.unwrap_or(0.0)) + filter.map_or(0.0, |filter| filter.lag),
            filter,
            overload: overload(index, sensor, self.cases).map(|(_, most)| most),
            too_slow: wanted.is_some_and(|wanted| bandwidth < wanted),
            by_readout: self.by_readout(index, sensor, &self.cases[worst])?,
            // Without sensors a spec is judged by perfect ones.
            has_limits: self.spec.sensors.is_empty() || has_limits(sensor),
            sooner: None,
            fixes: Vec::new(),
        })
    }

    /// Whether most of what a sensor sees wrong of the motion in a case would be gone if it told at once what it watches.
    fn by_readout(&self, index: usize, sensor: &SensorSpec, case: &Case) -> Result<bool, Error> {
        let instrument = self.instrument(sensor, case.condition)?;
        let scene = case.scene(sensor, &self.spec.goal);
        let at_once = instrument.forces(&instrument.quantity(scene.seen)?);
        let seen = |forces: &[f64]| Ok(rms(&self.counted(scene, forces)?.errors));
        Ok(seen(&at_once)? < 0.5 * seen(&case.readings[index].steady)?)
    }

    /// The combined uncertainty of the worst case \[N\], and whether every case meets the goal.
    pub fn combined(&self, index: usize, sensor: &SensorSpec, responses: &[Responses]) -> Result<f64, Error> {
        let assessments = self.assessments(index, sensor, responses)?;
        Ok(assessments[worst(&assessments)].combined)
    }

    /// A sensor in every case.
    fn assessments(
        &self,
        index: usize,
        sensor: &SensorSpec,
        responses: &[Responses],
    ) -> Result<Vec<Assessment>, Error> {
        let assess = |number: usize| {
            let case = &self.cases[number];
            let instrument = self.instrument(sensor, case.condition)?;
            let over = Over { responses: &responses[number], sensor: index };
            let scene = case.scene(sensor, &self.spec.goal);
            let counted = self.counted(scene, &case.readings[index].steady)?;
            self.assessment(sensor, &instrument, scene, counted, Some(over))
        };
        (0..self.cases.len()).map(assess).collect()
    }

    fn model<'m>(
        &'m self,
        index: usize,
        sensor: &'m SensorSpec,
        number: usize,
        responses: &'m [Responses],
    ) -> Result<SensorModel<'m>, Error> {
        let case = &self.cases[number];
        let instrument = self.instrument(sensor, case.condition)?;
        let over = Over { responses: &responses[number], sensor: index };
        let scene = case.scene(sensor, &self.spec.goal);
        let steady = &case.readings[index].steady;
        Ok(SensorModel { judge: self, sensor, instrument, scene, steady, over })
    }

    /// A sensor in one case, by its errors there; `over` says how they change from spring to spring, without it the nominal one alone is
    /// judged.
    pub fn assessment(
        &self,
        sensor: &SensorSpec,
        instrument: &Instrument,
        scene: Scene<'_>,
        Counted { errors, raw }: Counted,
        over: Option<Over<'_>>,
    ) -> Result<Assessment, Error> {
        let straight = self.straight(instrument, scene)?;
        let model = self.model_of(sensor, instrument, scene, Errors { errors, straight }, over)?;
        let budget = model.budget()?;
        let instrument_only = model.of_instrument(&budget);
        let (mut inside, mut worst) = (None, f64::NAN);
        if self.springs.one_by_one && over.is_some() {
            let each = model.of_specimens(&self.springs.specimens);
            let met = |goal: f64| each.iter().filter(|error| **error <= goal).count() as f64 / each.len() as f64;
            inside = self.spec.goal.error.map(met);
            // Of the further springs that a resonance takes, the oscillation alone is known.
            worst = each.iter().fold(model.spread.loudest, |worst, error| worst.max(*error));
        }
        let instrument = instrument_only.sqrt();
        Ok(Assessment {
            oscillation: model.spread.nominal.square().sqrt(),
            over_specimens: model.spread.rms(),
            loudest: model.spread.loudest,
            combined: with_bias(&budget),
            nominal: model.nominal().hypot(instrument),
            raw: raw.hypot(model.beside().square().sqrt()).hypot(instrument),
            inside,
            worst,
        })
    }

    /// How the errors of sensors in a condition under a damping change from spring to spring; `known` of each: the variance \[N²\] of all
    /// that is not oscillation, and its errors on the nominal spring.
    pub fn responses(
        &self,
        (condition, damping): (usize, usize),
        sensors: &[&SensorSpec],
        known: &[(f64, Moments)],
        specimens: &Specimens,
    ) -> Result<Responses, Error> {
        let (spec, coil, goal) = (self.spec, self.coil, self.spec.goal.error);
        let helix = self.helices.get(condition, damping);
        Responses::of(&Request { spec, coil, helix, condition, damping, sensors, known, goal }, specimens)
    }

    /// Variance of everything but the oscillation \[N²\].
    pub fn beside(&self, sensor: &SensorSpec, instrument: &Instrument, scene: Scene<'_>) -> Result<f64, Error> {
        let still = Errors { errors: vec![0.0], straight: Vec::new() };
        let budget = self.model_of(sensor, instrument, scene, still, None)?.budget()?;
        let each = budget.contributions().iter().filter(|line| line.name != OSCILLATION);
        Ok(each.map(|line| line.contribution * line.contribution).sum())
    }

    /// A sensor as it is set up for a condition.
    pub fn instrument(&self, sensor: &SensorSpec, condition: usize) -> Result<Instrument, Error> {
        sensor.on(&self.site(condition))
    }

    /// Where sensors sit in a condition: on the nominal spring.
    fn site(&self, condition: usize) -> Site<'_> {
        let mean_length = self.spec.conditions[condition].excitation.mean_length();
        Site { spring: &self.spec.spring.spring, coil: self.coil, mean_length }
    }

    /// What a change of L \[H\] is as one of length \[m\], about the mean length of a condition.
    fn length_of(&self, condition: usize, change: f64) -> f64 {
        let length = self.spec.conditions[condition].excitation.mean_length();
        let step = ABOUT * length;
        let [before, after] = [length - step, length + step].map(|length| self.coil.at_length(length));
        change * (2.0 * step / (after - before)).abs()
    }

    /// Errors of the force \[N\] that a sensor reads without noise and resolution.
    pub fn counted(&self, scene: Scene<'_>, steady: &[f64]) -> Result<Counted, Error> {
        let truth = scene.signals.channel(self.spec.goal.force)?;
        let errors: Vec<f64> = steady.iter().zip(truth).map(|(force, truth)| force - truth).collect();
        let raw = rms(&errors[scene.judged.clone()]);
        let errors = band::within(&errors, scene.signals.time(), scene.judged, self.spec.goal.bandwidth)?;
        Ok(Counted { errors, raw })
    }

    /// What a sensor of length errs by because it takes the spring's force for a straight line, where that of the coil bends \[N\]; empty for
    /// other sensors, and where the coil is no helix.
    fn straight(&self, instrument: &Instrument, scene: Scene<'_>) -> Result<Vec<f64>, Error> {
        if instrument.slope().is_none() {
            return Ok(Vec::new());
        }
        let (spring, bandwidth) = (&self.spec.spring.spring, self.spec.goal.bandwidth);
        // Without a bandwidth no other sample counts.
        let needed = if bandwidth.is_some() { 0..scene.signals.time().len() } else { scene.judged.clone() };
        let [u1, u2] = [Channel::U1, Channel::U2].map(|of| Ok(&scene.signals.channel(of)?[needed.clone()]));
        let lengths: Vec<f64> = u1?.iter().zip(u2?).map(|(u1, u2)| u2 - u1).collect();
        let within = |curve: &[f64]| {
            let each: Vec<f64> =
                lengths.iter().zip(curve).map(|(length, curve)| spring.static_force(*length) - curve).collect();
            if bandwidth.is_none() {
                return Ok(each);
            }
            band::within(&each, scene.signals.time(), scene.judged, bandwidth)
        };
        if !self.helices.is_empty() {
            return within(&scene.signals.channel(Channel::DeflectionForce)?[needed]);
        }
        let (one, other) = self.spec.mount.ends.ways();
        let other = other.filter(|other| other.turning() != one.turning());
        let force = lengths.iter().map(|length| spring.static_force(*length).abs()).fold(0.0, f64::max);
        let mut largest = (STRAIGHT_ENOUGH * force, Vec::new());
        for way in [Some(one), other].into_iter().flatten() {
            let forces = Bent::of(&self.spec.spring, way.turning())
                .and_then(|bent| lengths.iter().map(|length| bent.force(*length)).collect::<Result<Vec<f64>, _>>());
            let Ok(forces) = forces else { continue };
            let errors = within(&forces)?;
            if rms(&errors) > largest.0 {
                largest = (rms(&errors), errors);
            }
        }
        Ok(largest.1)
    }

    fn model_of<'m>(
        &'m self,
        sensor: &'m SensorSpec,
        instrument: &'m Instrument,
        scene: Scene<'_>,
        Errors { errors, straight }: Errors,
        over: Option<Over<'_>>,
    ) -> Result<Model<'m>, Error> {
        let truth = scene.signals.channel(self.spec.goal.force)?;
        let by_size = |a: &usize, b: &usize| truth[*a].abs().total_cmp(&truth[*b].abs());
        let largest = scene.judged.clone().max_by(by_size).unwrap_or(scene.judged.start);
        let quantity = instrument.quantity(scene.seen)?;
        let nominal = Moments::of(&errors);
        let spread = match over {
            Some(over) => {
                let as_chains = self.springs.as_chains.as_ref();
                Spread::over(over.responses, over.sensor, nominal, &self.springs.specimens, as_chains)
            }
            None => Spread::nominal(nominal),
        };
        let (bandwidth, rate) = (self.spec.goal.bandwidth, self.spec.conditions[scene.condition].sample_rate);
        let measurement = Measurement {
            instrument,
            site: self.site(scene.condition),
            limits: sensor.limits(),
            spring: doubt(&self.spec.spring),
            reading: quantity[largest],
            noise: instrument.readout().noise_within(bandwidth, rate),
            warming: self.spec.uncertainty.temperature_change,
        };
        let bends = !self.helices.is_empty();
        let by_coil = sensor.quantity.of_kind().watches(Channel::Inductance);
        let uneven = if by_coil { self.length_of(scene.condition, scene.inductance_doubt) } else { 0.0 };
        Ok(Model { spec: self.spec, measurement, errors, spread, straight, bends, uneven })
    }

    /// The low-pass that a goal with a bandwidth needs where errors of every frequency exceed it.
    fn filter(&self, assessments: &[Assessment]) -> Option<GoalFilter> {
        let (goal, bandwidth) = (self.spec.goal.error?, self.spec.goal.bandwidth?);
        let each = assessments.iter().enumerate();
        let (case, largest) = each.max_by(|a, b| a.1.raw.total_cmp(&b.1.raw))?;
        let needed =
            GoalFilter { bandwidth, order: MAX_ORDER, lag: band::lag(Some(bandwidth)), raw: largest.raw, case };
        Some(needed).filter(|filter| filter.raw > goal)
    }

    fn meets(&self, assessments: &[Assessment]) -> Vec<bool> {
        let Some(goal) = self.spec.goal.error else { return Vec::new() };
        let dampings = self.spec.mount.cases.len();
        let all = |damping: usize| {
            let of_damping = self.cases.iter().zip(assessments).filter(|(case, _)| case.damping == damping);
            of_damping.map(|(_, assessment)| assessment.combined).all(|combined| combined <= goal)
        };
        (0..dampings).map(all).collect()
    }
}

/// Errors of a sensor in a case on the nominal spring.
#[derive(Debug, Clone)]
pub(super) struct Counted {
    /// As far as they count, over the judged samples \[N\].
    pub errors: Vec<f64>,
    /// Their rms at every frequency \[N\].
    pub raw: f64,
}

/// Errors of a sensor over the judged samples, as far as they count.
struct Errors {
    /// With the motion \[N\].
    errors: Vec<f64>,
    /// Of the straight line in place of the coil's static curve \[N\]; empty where there are none, or none are asked for.
    straight: Vec<f64>,
}

/// How a sensor's error changes from spring to spring in a case.
#[derive(Clone, Copy)]
pub(super) struct Over<'a> {
    pub responses: &'a Responses,
    /// Its number among the sensors of the responses.
    pub sensor: usize,
}

/// What the budget of a sensor in a case is made from.
struct SensorModel<'a> {
    judge: &'a Judge<'a>,
    sensor: &'a SensorSpec,
    instrument: Instrument,
    scene: Scene<'a>,
    steady: &'a [f64],
    over: Over<'a>,
}

impl SensorModel<'_> {
    fn with_monte_carlo(&self) -> Result<SensorBudget, Error> {
        let Counted { errors, .. } = self.judge.counted(self.scene, self.steady)?;
        let straight = self.judge.straight(&self.instrument, self.scene)?;
        let errors = Errors { errors, straight };
        self.judge.model_of(self.sensor, &self.instrument, self.scene, errors, Some(self.over))?.with_monte_carlo()
    }
}

/// Number of the case with the largest uncertainty; of cases that are alike, the first.
fn worst(assessments: &[Assessment]) -> usize {
    let by_size = |a: &usize, b: &usize| assessments[*a].combined.total_cmp(&assessments[*b].combined);
    (0..assessments.len()).rev().max_by(by_size).unwrap_or(0)
}

fn rms(errors: &[f64]) -> f64 {
    (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt()
}
