//! Each sensor judged over all cases: its combined uncertainty, whether it meets the goal, and what breaks it.
//!
//! Next door: what makes a force uncertain (`budget`), what would help (`fix`), the judgement by itself (`assessed`).

use std::borrow::Cow;
use std::ops::Range;

use coilsense::inductance::MaxwellSum;
use coilsense::{Error, Signals};

use super::band;
use super::budget::{Model, SensorBudget, with_bias};
use super::case::Case;
use super::fix::{self, Fix};
use super::instrument::Instrument;
use crate::spec::{SensorSpec, Spec};

/// What the analysis says of one sensor.
#[derive(Debug, Clone)]
pub struct Verdict {
    /// Number of the sensor among [`super::Analysis::sensors`].
    pub sensor: usize,
    /// One per case.
    pub assessments: Vec<Assessment>,
    /// Number of the case with the largest combined uncertainty, the first of them where several are alike.
    pub worst: usize,
    /// The budget of that case.
    pub budget: SensorBudget,
    /// For each damping, whether all conditions meet the goal; empty without a goal.
    pub meets: Vec<bool>,
    /// Where the sensor's own answer has fallen by 3 dB \[Hz\]; infinite for one without limits.
    pub bandwidth: f64,
    /// How much later the force comes at the wanted bandwidth, or slowly where none is wanted \[s\].
    pub lag: f64,
    /// Whether the sensor does not reach the wanted bandwidth.
    pub too_slow: bool,
    /// Single changes with which it meets the goal, the quickest first.
    pub fixes: Vec<Fix>,
}

/// A sensor in a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Assessment {
    /// Rms deviation from the true force at the same instant within the wanted bandwidth, without noise and resolution \[N\]: surge,
    /// and the lag behind a moving force.
    pub oscillation: f64,
    /// Combined standard uncertainty, with the bias that stays uncorrected \[N\].
    pub combined: f64,
}

impl Verdict {
    /// The combined standard uncertainty of the worst case \[N\].
    pub fn combined(&self) -> f64 {
        self.assessments[self.worst].combined
    }

    /// Whether it meets the goal under every damping; `None` without a goal.
    pub fn meets_always(&self) -> Option<bool> {
        if self.meets.is_empty() { None } else { Some(!self.too_slow && self.meets.iter().all(|meets| *meets)) }
    }
}

/// What sensors are judged by.
#[derive(Clone, Copy)]
pub(super) struct Judge<'a> {
    pub spec: &'a Spec,
    pub coil: &'a MaxwellSum,
    pub cases: &'a [Case],
}

/// What of a case a sensor is judged by.
#[derive(Clone, Copy)]
pub(super) struct Scene<'a> {
    /// Number of the condition in the spec.
    pub condition: usize,
    pub signals: &'a Signals,
    pub judged: &'a Range<usize>,
}

impl Judge<'_> {
    /// The verdict on a sensor of the analysis.
    pub fn verdict(&self, index: usize, sensor: &SensorSpec) -> Result<Verdict, Error> {
        let assessments = self.assessments(sensor, |case, _| Ok(Cow::Borrowed(&case.readings[index].steady)))?;
        let worst = worst(&assessments);
        let case = &self.cases[worst];
        let instrument = self.instrument(sensor, case.condition)?;
        let budget = self.model(sensor, &instrument, case.scene(), &case.readings[index].steady)?.with_monte_carlo()?;
        let readout = instrument.readout();
        let bandwidth = readout.bandwidth_3db();
        let wanted = self.spec.goal.bandwidth;
        let mut verdict = Verdict {
            sensor: index,
            meets: self.meets(&assessments),
            assessments,
            worst,
            budget,
            bandwidth,
            lag: readout.lag(wanted.unwrap_or(0.0)),
            too_slow: wanted.is_some_and(|wanted| bandwidth < wanted),
            fixes: Vec::new(),
        };
        if verdict.meets_always() == Some(false) {
            verdict.fixes = fix::of(self, sensor, &verdict)?;
        }
        Ok(verdict)
    }

    /// A sensor in every case; `steady` gives the force that it reads without noise and resolution.
    fn assessments<'c>(
        &'c self,
        sensor: &SensorSpec,
        steady: impl Fn(&'c Case, &Instrument) -> Result<Cow<'c, [f64]>, Error>,
    ) -> Result<Vec<Assessment>, Error> {
        let assess = |case: &'c Case| {
            let instrument = self.instrument(sensor, case.condition)?;
            self.assessment(sensor, &instrument, case.scene(), &steady(case, &instrument)?)
        };
        self.cases.iter().map(assess).collect()
    }

    /// A sensor in one case; `steady` is the force that it reads without noise and resolution.
    pub fn assessment(
        &self,
        sensor: &SensorSpec,
        instrument: &Instrument,
        scene: Scene<'_>,
        steady: &[f64],
    ) -> Result<Assessment, Error> {
        let model = self.model(sensor, instrument, scene, steady)?;
        let oscillation = rms(&model.errors);
        Ok(Assessment { oscillation, combined: with_bias(&model.budget()?) })
    }

    /// The largest combined uncertainty of a sensor that the analysis does not have, and whether it reaches the wanted bandwidth.
    pub fn trial(&self, sensor: &SensorSpec) -> Result<Trial, Error> {
        let assessments = self.assessments(sensor, |case, instrument| {
            Ok(instrument.forces(&instrument.steady_readings(&case.signals)?).into())
        })?;
        let readout = coilsense::sensors::Readout::new(sensor.readout.clone())?;
        let wanted = self.spec.goal.bandwidth;
        Ok(Trial {
            combined: assessments[worst(&assessments)].combined,
            reaches: wanted.is_none_or(|wanted| readout.bandwidth_3db() >= wanted),
            lag: readout.lag(wanted.unwrap_or(0.0)),
        })
    }

    /// A sensor as it is set up for a condition.
    pub fn instrument(&self, sensor: &SensorSpec, condition: usize) -> Result<Instrument, Error> {
        let mean_length = self.mean_length(condition);
        Instrument::new(sensor, &self.spec.spring.spring, self.coil, mean_length)
    }

    fn model<'m>(
        &'m self,
        sensor: &'m SensorSpec,
        instrument: &'m Instrument,
        scene: Scene<'_>,
        steady: &[f64],
    ) -> Result<Model<'m>, Error> {
        let truth = scene.signals.channel(self.spec.goal.force)?;
        let errors: Vec<f64> = steady.iter().zip(truth).map(|(force, truth)| force - truth).collect();
        let by_size = |a: &usize, b: &usize| truth[*a].abs().total_cmp(&truth[*b].abs());
        let largest = scene.judged.clone().max_by(by_size).unwrap_or(scene.judged.start);
        let quantity = instrument.quantity(scene.signals)?;
        Ok(Model {
            spec: self.spec,
            coil: self.coil,
            sensor,
            instrument,
            reading: quantity[largest],
            errors: band::within(&errors, scene.signals.time(), scene.judged, self.spec.goal.bandwidth)?,
            sample_rate: self.spec.conditions[scene.condition].sample_rate,
            mean_force: self.spec.spring.spring.static_force(self.mean_length(scene.condition)),
        })
    }

    fn mean_length(&self, condition: usize) -> f64 {
        self.spec.conditions[condition].excitation.mean_length()
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

/// A sensor tried out.
pub(super) struct Trial {
    /// The largest combined uncertainty \[N\].
    pub combined: f64,
    /// Whether it reaches the wanted bandwidth.
    pub reaches: bool,
    /// How much later the force comes \[s\].
    pub lag: f64,
}

/// Number of the case with the largest uncertainty; of cases that are alike, the first.
fn worst(assessments: &[Assessment]) -> usize {
    let by_size = |a: &usize, b: &usize| assessments[*a].combined.total_cmp(&assessments[*b].combined);
    (0..assessments.len()).rev().max_by(by_size).unwrap_or(0)
}

fn rms(errors: &[f64]) -> f64 {
    (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt()
}
