//! A spec made ready: what all of its cases share, how one case is followed from spring to spring, and what is concluded of all of them.
//!
//! Next door: the cases themselves (`case`), all at once (the parent) or one by one (`under_way`).

use coilsense::Error;
use rayon::prelude::*;

use super::case::{Case, Reading};
use super::judge::Judge;
use super::moments::Moments;
use super::rank::Rank;
use super::response::Responses;
use super::specimen::{MANY, SOME, Specimens, Springs};
use super::verdict::Verdict;
use super::{
    Analysis, AnalysisError, IfUsual, Progress, USUAL_TOLERANCE, fix, helices, judged_sensors, overload, prepare,
    resonance, simulate_watched, sooner, warnings,
};
use crate::data_sheet::DataSheet;
use crate::spec::{Model, SensorSpec, Spec, SpringInductance, Tolerances};
use crate::study::{Helices, Masses};

/// What all cases of a spec share.
pub(super) struct Prepared {
    /// Its spring has as many masses as its figures need.
    pub spec: Spec,
    pub sensors: Vec<SensorSpec>,
    pub coil: SpringInductance,
    pub helices: Helices,
    masses: Masses,
    springs: Springs,
    /// Of a spec that is silent on its stiffness: the springs of the usual tolerance.
    usual: Option<Springs>,
    as_chain: Option<Vec<f64>>,
}

/// How the errors of all sensors in a case change over the springs that tolerances allow, and over those of the usual tolerance.
#[derive(Debug, Clone)]
pub(super) struct OverSprings {
    told: Responses,
    usual: Option<Responses>,
}

/// Whether to go on after every case has been simulated.
pub(super) fn go_on(progress: &Progress<'_>, cases: usize) -> Result<(), AnalysisError> {
    match progress(cases, cases) {
        true => Ok(()),
        false => Err(AnalysisError::Interrupted),
    }
}

impl Prepared {
    pub fn of(mut spec: Spec, progress: &Progress<'_>) -> Result<Self, AnalysisError> {
        spec.needs_one_spring("analyze")?;
        let as_chain = as_chain(&spec, progress)?;
        let masses = prepare(&mut spec)?;
        Ok(Self {
            sensors: judged_sensors(&spec),
            helices: helices(&spec)?,
            coil: SpringInductance::of(&spec.spring)?,
            springs: Springs::of(&spec, &spec.spring.tolerances, MANY).one_by_one(),
            usual: usual(&spec),
            masses,
            as_chain,
            spec,
        })
    }

    /// Every case, condition by condition.
    pub fn cases(&self, progress: &Progress<'_>) -> Result<Vec<Case>, AnalysisError> {
        simulate_watched(&self.spec, &self.sensors, &self.coil, &self.helices, progress)
    }

    /// How the sensors' errors in a case change from spring to spring.
    pub fn responses(&self, case: &Case) -> Result<OverSprings, AnalysisError> {
        let judge = self.judge(&[]);
        let over = |springs: &Springs| responses(&judge, &self.sensors, case, &springs.specimens);
        Ok(OverSprings { told: over(&self.springs)?, usual: self.usual.as_ref().map(over).transpose()? })
    }

    /// What follows of all cases.
    pub fn conclude(
        self,
        cases: Vec<Case>,
        over: Vec<OverSprings>,
        progress: &Progress<'_>,
    ) -> Result<Analysis, AnalysisError> {
        let judge = self.judge(&cases);
        let sensors = &self.sensors;
        let (told, usual): (Vec<Responses>, Vec<_>) = over.into_iter().map(|over| (over.told, over.usual)).unzip();
        let mut verdicts: Vec<Verdict> = (0..sensors.len())
            .into_par_iter()
            .map(|index| {
                go_on(progress, cases.len())?;
                let verdict = judge.verdict(index, &sensors[index], &told)?;
                let fixes = if verdict.meets_always() == Some(false) && verdict.overload.is_none() {
                    fix::of(&judge, &sensors[index], &verdict)?
                } else {
                    overload::wider(&self.spec, &verdict).into_iter().collect()
                };
                let sooner = sooner::of(&judge, index, &sensors[index], &verdict)?;
                Ok(Verdict { fixes, sooner, ..verdict })
            })
            .collect::<Result<_, AnalysisError>>()?;
        verdicts.sort_by(|a, b| Rank::of(a).compared(&Rank::of(b)));
        let if_usual = match &self.usual {
            Some(springs) => {
                let usual: Vec<Responses> = usual.into_iter().flatten().collect();
                Some(if_usual(&Judge { springs, ..judge }, sensors, &usual, &verdicts)?)
            }
            None => None,
        };
        let data_sheet = DataSheet::of(&self.spec)?;
        let mut warnings = resonance::of(&judge, sensors, &verdicts, &told)?;
        warnings.extend(resonance::without_limit(&self.masses, self.spec.spring.model));
        warnings.extend(sooner::warnings(&self.spec, sensors, &cases, &verdicts));
        warnings.extend(warnings::of(&judge, sensors, &data_sheet)?);
        let Self { spec, sensors, masses, as_chain, .. } = self;
        Ok(Analysis { spec, sensors, cases, verdicts, warnings, data_sheet, masses, if_usual, as_chain })
    }

    fn judge<'a>(&'a self, cases: &'a [Case]) -> Judge<'a> {
        Judge { spec: &self.spec, coil: &self.coil, helices: &self.helices, cases, springs: &self.springs }
    }
}

/// Springs of a spec that is silent on its stiffness, within the usual tolerance.
fn usual(spec: &Spec) -> Option<Springs> {
    let tolerances = &spec.spring.tolerances;
    let wider = Tolerances { stiffness: Some(USUAL_TOLERANCE), ..*tolerances };
    tolerances.is_silent_on_stiffness().then(|| Springs::of(spec, &wider, SOME))
}

/// How the errors of all sensors in a case change from spring to spring.
fn responses(
    judge: &Judge<'_>,
    sensors: &[SensorSpec],
    case: &Case,
    specimens: &Specimens,
) -> Result<Responses, Error> {
    let of = |(sensor, reading): (&SensorSpec, &Reading)| {
        let instrument = judge.instrument(sensor, case.condition)?;
        let scene = case.scene(sensor, &judge.spec.goal);
        let beside = judge.beside(sensor, &instrument, scene)?;
        Ok((beside, Moments::of(&judge.counted(scene, &reading.steady)?.errors)))
    };
    let known: Vec<(f64, Moments)> = sensors.iter().zip(&case.readings).map(of).collect::<Result<_, Error>>()?;
    let sensors: Vec<&SensorSpec> = sensors.iter().collect();
    judge.responses((case.condition, case.damping), &sensors, &known, specimens)
}

/// The answer within the usual tolerance.
fn if_usual(
    judge: &Judge<'_>,
    sensors: &[SensorSpec],
    responses: &[Responses],
    verdicts: &[Verdict],
) -> Result<IfUsual, Error> {
    let mut spec = judge.spec.clone();
    spec.spring.tolerances.stiffness = Some(USUAL_TOLERANCE);
    let judge = Judge { spec: &spec, ..*judge };
    let each = (0..sensors.len()).into_par_iter().map(|index| judge.combined(index, &sensors[index], responses));
    let combined: Vec<f64> = each.collect::<Result<_, Error>>()?;
    let rank = |verdict: &&Verdict| Rank::with(verdict, combined[verdict.sensor], spec.goal.error);
    let mut order: Vec<&Verdict> = verdicts.iter().collect();
    order.sort_by(|a, b| rank(a).compared(&rank(b)));
    Ok(IfUsual { order: order.iter().map(|verdict| verdict.sensor).collect(), combined })
}

/// The same sensors by the coil's chain.
fn as_chain(spec: &Spec, progress: &Progress<'_>) -> Result<Option<Vec<f64>>, AnalysisError> {
    if spec.spring.model != Model::Helix {
        return Ok(None);
    }
    let mut chain = Spec { mount: spec.mount.without_ways(), ..spec.clone() };
    chain.spring.model = Model::Coil;
    let analysis = Analysis::run(chain, &|_, _| progress(0, 1))?;
    let mut combined = vec![0.0; analysis.verdicts.len()];
    analysis.verdicts.iter().for_each(|verdict| combined[verdict.sensor] = verdict.combined());
    Ok(Some(combined))
}
