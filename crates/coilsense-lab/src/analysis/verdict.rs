//! Each sensor judged over all cases: its combined uncertainty, whether it meets the goal, and what breaks it.
//!
//! Next door: what makes a force uncertain (`budget`), what would help (`fix`), the judgement by itself (`assessed`).

use std::ops::Range;

use coilsense::inductance::MaxwellSum;
use coilsense::sensors::{MAX_ORDER, Readout};
use coilsense::{Error, Signals};

use super::band;
use super::budget::{CHAIN, Model, SensorBudget, with_bias};
use super::case::Case;
use super::fix::{self, Fix};
use super::instrument::Instrument;
use super::response::{Asked, Moments, Responses};
use super::specimen::Specimens;
use super::spread::Spread;
use crate::spec::{SensorSpec, Spec, Tolerances};

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
    /// How much later the force comes at the wanted bandwidth, or slowly where none is wanted, behind the filter if it needs one \[s\].
    pub lag: f64,
    /// The low-pass without which the sensor does not meet a goal with a bandwidth; `None` where it needs none.
    pub filter: Option<GoalFilter>,
    /// Whether the sensor does not reach the wanted bandwidth.
    pub too_slow: bool,
    /// Single changes with which it meets the goal, the quickest first.
    pub fixes: Vec<Fix>,
}

/// A sensor in a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Assessment {
    /// Rms deviation from the true force at the same instant within the wanted bandwidth, without noise and resolution \[N\]: surge,
    /// and the lag behind a moving force; on the nominal spring.
    pub oscillation: f64,
    /// The same over the springs that the tolerances allow \[N\].
    pub over_specimens: f64,
    /// The same on the spring on which it is largest \[N\].
    pub loudest: f64,
    /// Combined standard uncertainty over them, with the bias that stays uncorrected \[N\].
    pub combined: f64,
    /// Of the nominal spring: its oscillation and the instrument's own errors \[N\].
    pub nominal: f64,
    /// The same with errors of every frequency, where the goal has a bandwidth \[N\].
    pub raw: f64,
    /// Share of the specimens whose rms error meets the goal \[1\]; `None` without a goal, and where it was not asked for.
    pub inside: Option<f64>,
    /// Rms error of the worst specimen that was drawn \[N\].
    pub worst: f64,
}

/// What makes a goal with a bandwidth true: errors above it count for nothing only behind a low-pass there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GoalFilter {
    /// Where it has lost 3 dB \[Hz\].
    pub bandwidth: f64,
    /// Its order, a Butterworth.
    pub order: usize,
    /// How much later a slow force comes behind it \[s\].
    pub lag: f64,
    /// Rms error without it in the case where it is largest \[N\].
    pub raw: f64,
    /// Number of that case.
    pub case: usize,
}

impl Verdict {
    /// The assessment of the worst case.
    pub fn at_worst(&self) -> &Assessment {
        &self.assessments[self.worst]
    }

    /// The smallest share of specimens inside the goal over all cases.
    pub fn least_inside(&self) -> Option<f64> {
        self.assessments.iter().filter_map(|assessment| assessment.inside).min_by(f64::total_cmp)
    }

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
    pub springs: &'a Springs,
}

/// The springs over which sensors are judged.
#[derive(Debug, Clone)]
pub(super) struct Springs {
    /// As tolerances allow them.
    pub specimens: Specimens,
    /// The same as if each were the chain that the model is, where its line is wanted.
    pub as_chains: Option<Specimens>,
    /// Whether shares and the worst of them are wanted.
    pub one_by_one: bool,
}

impl Springs {
    /// Of a spec, within other tolerances than its own where they are given.
    pub fn of(spec: &Spec, tolerances: &Tolerances, count: usize) -> Self {
        let specimens = Specimens::of(&spec.spring.spring, tolerances, count);
        Self { as_chains: None, specimens, one_by_one: false }
    }

    /// The same, each of them looked at.
    pub fn one_by_one(self) -> Self {
        Self { as_chains: Some(self.specimens.as_chains()), one_by_one: true, ..self }
    }
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
    /// The verdict on a sensor of the analysis; `responses` are those of all its sensors in each case.
    pub fn verdict(&self, index: usize, sensor: &SensorSpec, responses: &[Responses]) -> Result<Verdict, Error> {
        let assessments = self.assessments(index, sensor, responses)?;
        let worst = worst(&assessments);
        let budget = self.model(index, sensor, worst, responses)?.with_monte_carlo()?;
        let readout = Readout::new(sensor.readout.clone())?;
        let bandwidth = readout.bandwidth_3db();
        let wanted = self.spec.goal.bandwidth;
        let filter = self.filter(&assessments);
        let mut verdict = Verdict {
            sensor: index,
            meets: self.meets(&assessments),
            assessments,
            worst,
            budget,
            bandwidth,
            lag: readout.lag(wanted.unwrap_or(0.0)) + filter.map_or(0.0, |filter| filter.lag),
            filter,
            too_slow: wanted.is_some_and(|wanted| bandwidth < wanted),
            fixes: Vec::new(),
        };
        if verdict.meets_always() == Some(false) {
            verdict.fixes = fix::of(self, sensor, &verdict)?;
        }
        Ok(verdict)
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
            let counted = self.counted(case.scene(), &case.readings[index].steady)?;
            self.assessment(sensor, &instrument, case.scene(), counted, Some(over))
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
        let scene = case.scene();
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
        let model = self.model_of(sensor, instrument, scene, errors, over)?;
        let budget = model.budget()?;
        let of_spring = |name: &str| name.starts_with("tolerance of the ") || name == "oscillation" || name == CHAIN;
        let instrument_only: f64 = budget
            .contributions()
            .iter()
            .filter(|line| !of_spring(&line.name))
            .map(|line| line.contribution * line.contribution)
            .sum();
        let (mut inside, mut worst) = (None, f64::NAN);
        if self.springs.one_by_one && over.is_some() {
            let each = model.of_specimens(&self.springs.specimens)?;
            let met = |goal: f64| each.iter().filter(|error| **error <= goal).count() as f64 / each.len() as f64;
            inside = self.spec.goal.error.map(met);
            worst = each.iter().fold(0.0, |worst: f64, error| worst.max(*error));
        }
        let oscillation = model.spread.nominal.square().sqrt();
        Ok(Assessment {
            oscillation,
            over_specimens: model.spread.rms(),
            loudest: model.spread.loudest(),
            combined: with_bias(&budget),
            nominal: oscillation.hypot(instrument_only.sqrt()),
            raw: raw.hypot(instrument_only.sqrt()),
            inside,
            worst,
        })
    }

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
                let steady = instrument.forces(&instrument.steady_readings(&case.signals)?);
                let counted = self.counted(case.scene(), &steady)?;
                let responses = match over_springs {
                    true => Some(self.responses(case, sensor, &instrument, Moments::of(&counted.errors))?),
                    false => None,
                };
                let over = responses.as_ref().map(|responses| Over { responses, sensor: 0 });
                let assessment = self.assessment(sensor, &instrument, case.scene(), counted, over)?;
                if assessment.combined > goal {
                    return Ok(None);
                }
                (combined, raw) = (combined.max(assessment.combined), raw.max(assessment.raw));
            }
        }
        let behind = if raw > goal { band::lag(wanted) } else { 0.0 };
        Ok(Some(Trial { combined, lag: readout.lag(wanted.unwrap_or(0.0)) + behind }))
    }

    fn responses(
        &self,
        case: &Case,
        sensor: &SensorSpec,
        instrument: &Instrument,
        nominal: Moments,
    ) -> Result<Responses, Error> {
        let beside = self.beside(sensor, instrument, case.scene())?;
        let (condition, damping) = (case.condition, case.damping);
        let asked = Asked {
            spec: self.spec,
            coil: self.coil,
            condition,
            damping,
            sensors: &[sensor],
            beside: &[beside],
            nominal: &[nominal],
            goal: self.spec.goal.error,
        };
        Responses::of(&asked, &self.springs.specimens)
    }

    /// Variance of everything but the oscillation \[N²\].
    pub fn beside(&self, sensor: &SensorSpec, instrument: &Instrument, scene: Scene<'_>) -> Result<f64, Error> {
        let budget = self.model_of(sensor, instrument, scene, vec![0.0], None)?.budget()?;
        let each = budget.contributions().iter().filter(|line| line.name != "oscillation");
        Ok(each.map(|line| line.contribution * line.contribution).sum())
    }

    /// A sensor as it is set up for a condition.
    pub fn instrument(&self, sensor: &SensorSpec, condition: usize) -> Result<Instrument, Error> {
        let mean_length = self.mean_length(condition);
        Instrument::new(sensor, &self.spec.spring.spring, self.coil, mean_length)
    }

    /// Errors of the force \[N\] that a sensor reads without noise and resolution.
    pub fn counted(&self, scene: Scene<'_>, steady: &[f64]) -> Result<Counted, Error> {
        let truth = scene.signals.channel(self.spec.goal.force)?;
        let errors: Vec<f64> = steady.iter().zip(truth).map(|(force, truth)| force - truth).collect();
        let raw = rms(&errors[scene.judged.clone()]);
        let errors = band::within(&errors, scene.signals.time(), scene.judged, self.spec.goal.bandwidth)?;
        Ok(Counted { errors, raw })
    }

    fn model_of<'m>(
        &'m self,
        sensor: &'m SensorSpec,
        instrument: &'m Instrument,
        scene: Scene<'_>,
        errors: Vec<f64>,
        over: Option<Over<'_>>,
    ) -> Result<Model<'m>, Error> {
        let truth = scene.signals.channel(self.spec.goal.force)?;
        let by_size = |a: &usize, b: &usize| truth[*a].abs().total_cmp(&truth[*b].abs());
        let largest = scene.judged.clone().max_by(by_size).unwrap_or(scene.judged.start);
        let quantity = instrument.quantity(scene.signals)?;
        let nominal = Moments::of(&errors);
        let spread = match over {
            Some(over) => {
                let as_chains = self.springs.as_chains.as_ref();
                Spread::over(over.responses, over.sensor, nominal, &self.springs.specimens, as_chains)
            }
            None => Spread::nominal(nominal),
        };
        Ok(Model {
            spec: self.spec,
            coil: self.coil,
            sensor,
            instrument,
            reading: quantity[largest],
            errors,
            spread,
            sample_rate: self.spec.conditions[scene.condition].sample_rate,
            mean_force: self.spec.spring.spring.static_force(self.mean_length(scene.condition)),
        })
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

/// Errors of a sensor in a case on the nominal spring.
#[derive(Debug, Clone)]
pub(super) struct Counted {
    /// As far as they count, over the judged samples \[N\].
    pub errors: Vec<f64>,
    /// Their rms at every frequency \[N\].
    pub raw: f64,
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
        self.judge.model_of(self.sensor, &self.instrument, self.scene, errors, Some(self.over))?.with_monte_carlo()
    }
}

/// A sensor tried out, which meets the goal.
pub(super) struct Trial {
    /// The largest combined uncertainty \[N\].
    pub combined: f64,
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
