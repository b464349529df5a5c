//! Every loop over time: a step to show, and the runs that confirm its limit.
//!
//! Next door: the limits (`judged`, `estimated`), how they are told (`told`).

use coilsense::control::{ForceLoop, Margins, OverTime, Run, SampledLoop};
use coilsense::{Channel, Error};

use super::Candidate;
use super::allowed::{Allowed, Varied};
use super::estimated::Estimated;
use super::judged::weakest;
use super::loops::{Under, UnitLoops};
use crate::spec::DampingCase;

/// How long a shown run lasts \[s\] and of how many samples it is at most.
const SHOWN: f64 = 1.0;
const MOST_SHOWN: f64 = 1e5;
/// A run that confirms a limit lasts so many periods of the first surge frequency, and at least so many of what oscillates at the limit.
const SURGE_PERIODS: f64 = 600.0;
const PERIODS: f64 = 64.0;
const MOST_CONFIRMED: f64 = 2e6;
/// How far from its limit a loop is run, either way \[1\].
pub const BESIDE: f64 = 0.02;
/// The step of the reference over F_nom \[1\].
const STEP: f64 = 0.01;
/// Samples for which F_L is read off the whole inductance: each is a sum over all pairs of windings.
const MOST_READ: usize = 2000;
/// The part of a shown run by which it is told whether it has come to rest.
const LAST: usize = 10;

/// One loop over time, at the damping and on the spring at which it has the least to spare.
#[derive(Debug, Clone, PartialEq)]
pub struct LoopRun {
    /// What is fed back: a force, or an estimate.
    pub fed_back: &'static str,
    /// The damping.
    pub damping: String,
    /// By which shares the spring's k and its surge frequencies are off \[1\].
    pub off: [f64; 2],
    /// Whether it is stable at the set gain, by its response over frequency.
    pub stable: bool,
    /// A step of the reference of 1 % of F_nom at the set gain; or why there is none.
    pub shown: Result<Run, String>,
    /// Where F_o is in the last tenth of that and how far it swings, either way, over the step \[1\]; `None` where the run ended early.
    pub last: Option<[f64; 2]>,
    /// The largest command of that run.
    pub largest_command: f64,
    /// Whether it stayed at 0.98 and grew at 1.02 times its predicted limit.
    pub verdict: Verdict,
    /// How far the force by the whole inductance is from its straight line at most in the same run, over the step \[1\]; for F_L in samples, where
    /// it is stable and no windings touch.
    pub coil_error: Option<f64>,
}

/// What runs on both sides of a predicted limit say.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// It stayed below and grew above.
    Holds,
    /// It did not.
    Fails,
    /// There is no limit, or the loop is unstable at any gain.
    NoLimit,
    /// What oscillates is too slow for a run of two million steps.
    TooSlow,
    /// There is no run.
    NotRun,
}

impl Verdict {
    /// Whether the limit held; `None` where no run could say.
    pub fn confirmed(self) -> Option<bool> {
        match self {
            Self::Holds => Some(true),
            Self::Fails => Some(false),
            Self::NoLimit | Self::TooSlow | Self::NotRun => None,
        }
    }

    /// In a word or two.
    pub fn words(self) -> &'static str {
        match self {
            Self::Holds => "yes",
            Self::Fails => "no",
            Self::NoLimit => "no limit",
            Self::TooSlow => "too slow to tell",
            Self::NotRun => "not run",
        }
    }
}

/// A loop as it is run.
struct Ready<'a> {
    fed_back: &'static str,
    damping: &'a DampingCase,
    varied: &'a Varied,
    /// At the set gain.
    margins: Margins,
    over_time: Result<OverTime, Error>,
}

/// All loops: each force, then each estimate.
pub(super) fn runs(
    unit: &UnitLoops<'_>,
    dampings: &[DampingCase],
    candidates: &[Candidate],
    estimates: &[Estimated],
    allowed: &Allowed,
    gain: f64,
) -> Result<Vec<LoopRun>, Error> {
    // What was found of a plant is taken over from loop to loop.
    let mut found: Option<OverTime> = None;
    let mut told = Vec::new();
    for candidate in candidates {
        let weakest = weakest(candidate.judged.iter().map(|judged| judged.margins.gain_limit));
        let (damping, judged) = (&dampings[weakest], &candidate.judged[weakest]);
        let varied = &allowed.each[judged.weakest];
        let under = Under { place: judged.weakest, spring: &varied.spring, delay: judged.delay };
        let force_loop = unit.on(under, damping, candidate.channel, gain)?;
        let over_time = match unit.sampled(&force_loop)? {
            Some(sampled) => OverTime::sampled_beside(&sampled, found.as_ref()),
            None => OverTime::continuous_beside(&force_loop, found.as_ref()),
        };
        found = over_time.as_ref().ok().cloned().or(found);
        let (fed_back, margins) = (candidate.channel.name(), judged.margins);
        told.push(ready(unit, Ready { fed_back, damping, varied, margins, over_time })?);
    }
    for estimate in estimates {
        let behind = |force_loop: &ForceLoop| {
            let step = unit.control.sample_time.unwrap_or_default();
            SampledLoop::new(force_loop, step)?.behind(estimate.estimator.clone())
        };
        let under = unit.under(&allowed.each, Channel::InputForce);
        let cases: Vec<(&DampingCase, Under<'_>)> =
            dampings.iter().flat_map(|damping| under.iter().map(move |under| (damping, *under))).collect();
        let each = cases.iter().map(|(damping, under)| behind(&unit.on(*under, damping, Channel::InputForce, gain)?));
        let loops = each.collect::<Result<Vec<_>, Error>>()?;
        let margins = loops.iter().map(SampledLoop::margins).collect::<Result<Vec<_>, Error>>()?;
        let weakest = weakest(margins.iter().map(|margins| margins.gain_limit));
        let over_time = OverTime::sampled_beside(&loops[weakest], found.as_ref());
        let (fed_back, margins, (damping, under)) = (estimate.name, margins[weakest], cases[weakest]);
        let varied = &allowed.each[under.place];
        told.push(ready(unit, Ready { fed_back, damping, varied, margins, over_time })?);
    }
    Ok(told)
}

fn ready(
    unit: &UnitLoops<'_>,
    Ready { fed_back, damping, varied, margins, over_time }: Ready<'_>,
) -> Result<LoopRun, Error> {
    let mut told = LoopRun {
        fed_back,
        damping: damping.label.clone(),
        off: [varied.stiffness, varied.frequency],
        stable: margins.stable,
        shown: Ok(Run::default()),
        last: None,
        largest_command: 0.0,
        verdict: Verdict::NotRun,
        coil_error: None,
    };
    let over_time = match over_time {
        Ok(over_time) => over_time,
        // Of a loop whose response is known this is what a run cannot take, such as too many windings.
        Err(error) => {
            told.shown = Err(error.to_string());
            return Ok(told);
        }
    };
    let reference = STEP * unit.spec.spring.spring.nominal_force();
    let samples = (SHOWN / over_time.step()).min(MOST_SHOWN) as usize;
    let run = over_time.run(1.0, reference, samples)?;
    if run.time.len() == samples && samples >= LAST {
        told.last = Some(covered(&run.output[samples - samples / LAST..]).map(|force| force / reference));
    }
    told.largest_command = run.command.iter().fold(0.0, |most, command| most.max(command.abs()));
    if margins.stable && fed_back == Channel::InductanceForce.name() {
        told.coil_error = coil_error(&over_time, &run, reference)?;
    }
    told.shown = Ok(run);
    told.verdict = verdict(unit, &over_time, &margins, reference)?;
    Ok(told)
}

/// The middle of what a series covers, and how far that goes either way.
fn covered(series: &[f64]) -> [f64; 2] {
    let [least, most] = series
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], &value| [least.min(value), most.max(value)]);
    [0.5 * (most + least), 0.5 * (most - least)]
}

/// How far the whole inductance takes the loop from its straight line.
fn coil_error(over_time: &OverTime, run: &Run, reference: f64) -> Result<Option<f64>, Error> {
    // A continuous loop without delay has no reading of its own moment.
    let Ok(coil) = over_time.clone().with_coil() else { return Ok(None) };
    let samples = run.time.len().min(MOST_READ);
    let whole = coil.run(1.0, reference, samples)?;
    if whole.time.len() < samples {
        return Ok(None);
    }
    let pairs = run.fed_back.iter().zip(&whole.fed_back);
    Ok(Some(pairs.map(|(line, whole)| (line - whole).abs()).fold(0.0, f64::max) / reference.abs()))
}

/// Runs on both sides of the limit, watched where the loop should oscillate.
fn verdict(unit: &UnitLoops<'_>, over_time: &OverTime, margins: &Margins, reference: f64) -> Result<Verdict, Error> {
    if !margins.gain_limit.is_finite() || margins.gain_limit == 0.0 {
        return Ok(Verdict::NoLimit);
    }
    let frequency = margins.critical_frequency;
    let seconds = (SURGE_PERIODS / unit.surge()).max(PERIODS * std::f64::consts::TAU / frequency);
    let samples = (seconds / over_time.step()).ceil();
    if samples.is_nan() || samples > MOST_CONFIRMED {
        return Ok(Verdict::TooSlow);
    }
    let grows = |share: f64| -> Result<Option<bool>, Error> {
        let run = over_time.run(share * margins.gain_limit, reference, samples as usize)?;
        Ok(run.growth(frequency).map(|growth| growth > 1.0))
    };
    Ok(match [grows(1.0 - BESIDE)?, grows(1.0 + BESIDE)?] {
        [Some(false), Some(true)] => Verdict::Holds,
        [Some(_), Some(_)] => Verdict::Fails,
        _ => Verdict::TooSlow,
    })
}
