//! A study: conditions, noise, tolerances; every candidate on all of them.
//!
//! Next door: what comes of it (`answer`), the candidates (`candidates`), how they are judged (`judge`), the answer as text and JSON (`report`).

use std::sync::atomic::{AtomicUsize, Ordering};

use coilsense::excitation::{EndInput, Start, VelocityProfile};
use coilsense::mitigation::{SampledSpring, ToleranceBox};
use coilsense::{Channel, Damping, Error, Excitation, FarEnd, Spring};
use coilsense_rt::Measured;
use rand_distr::Normal;
use rayon::prelude::*;

use super::answer::Answer;
use super::candidate::{Candidate, Truth};
use super::candidates::{Brief, Candidates};
use super::judge::{Judgement, Trial, order};
use super::runs;
use super::shaping::Shaping;
use crate::recording::{Recording, RecordingError};
use crate::spec::Spec;

/// What candidates are to be good at.
#[derive(Debug, Clone)]
pub struct Study {
    /// The nominal spring.
    pub spring: Spring,
    /// What end 2 is tied to; its position is measured in any case.
    pub far_end: FarEnd,
    /// A log to judge on in place of the conditions.
    pub recorded: Option<Recorded>,
    /// Name, excitation and duration \[s\] of each condition.
    pub conditions: Vec<(String, Excitation, f64)>,
    /// Label and damping; the spring may have any of them.
    pub dampings: Vec<(String, Damping)>,
    /// Which of them designs take for true.
    pub nominal_damping: usize,
    /// What may be off about k and m.
    pub tolerances: ToleranceBox,
    /// How often the controller samples \[Hz\].
    pub rate: f64,
    /// White noise of F_i \[N rms\].
    pub noise: f64,
    /// Up to which frequency the force moves by itself \[Hz\].
    pub bandwidth: f64,
    /// Most lag at the bandwidth that a recommendation may have \[degrees\].
    pub most_lag: f64,
    /// How many series of noise.
    pub seeds: u64,
    /// The first one's seed.
    pub seed: u64,
}

/// A log as candidates take it.
#[derive(Debug, Clone)]
pub struct Recorded {
    /// The file's name.
    pub name: String,
    /// F_i, u1, u2; at least one sample.
    pub measured: Vec<Measured<f64>>,
    /// F_o \[N\], where it was recorded; without it there is nothing to hold estimators against.
    pub output: Option<Vec<f64>>,
}

/// What the command line adds to a spec.
#[derive(Debug, Clone, Copy)]
pub struct Asked {
    /// Sampling rate \[Hz\].
    pub rate: f64,
    /// Noise \[N rms\].
    pub noise: Option<f64>,
    /// Bandwidth \[Hz\].
    pub bandwidth: Option<f64>,
    /// Tolerances of k and m.
    pub tolerances: ToleranceBox,
    /// Most lag at the bandwidth \[degrees\].
    pub most_lag: f64,
    /// Series of noise.
    pub seeds: u64,
}

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The spec has nothing to judge on.
    #[error("{0}: [[condition]] must be there at least once to judge on")]
    NoCondition(String),
    /// The science refuses.
    #[error("{file}: {source}")]
    Science {
        /// The spec's name.
        file: String,
        /// Why.
        source: Error,
    },
}

impl Study {
    /// S_T's scenario on which designs are compared: 0.23 m long, ζ = 0.005 (and half and twice that), hit at 0.25 m/s at t = 0 while u1 moves by
    /// 5 mm · sin(2π · 1.5 t), 2.5 kHz, 0.24 N rms of noise, 0 to 2 s, 50 seeds, k and m ± 10 %.
    ///
    /// # Errors
    /// Those of [`ToleranceBox::new`] and [`Excitation::new`], which these values do not meet.
    pub fn stated(spring: &Spring) -> Result<Self, Error> {
        let start = Start::Moving { velocity: 0.25, profile: VelocityProfile::Uniform };
        let excitation = Excitation::new(0.23, EndInput::harmonic(0.005, 1.5, 0.0), EndInput::Held, start)?;
        let damping = |ratio: f64| (format!("ζ = {ratio}"), Damping::Modal(ratio));
        Ok(Self {
            spring: spring.clone(),
            far_end: FarEnd::Position,
            recorded: None,
            conditions: vec![("stated scenario".to_owned(), excitation, 2.0)],
            dampings: [0.0025, 0.005, 0.01].map(damping).to_vec(),
            nominal_damping: 1,
            tolerances: ToleranceBox::new(0.1, 0.1)?,
            rate: 2500.0,
            noise: 0.24,
            bandwidth: 1.5,
            most_lag: 30.0,
            seeds: 50,
            seed: 1,
        })
    }

    /// The conditions and dampings of a spec; noise is 0.2 % of F_nom and the bandwidth the goal's, or f1/20, unless asked otherwise.
    ///
    /// # Errors
    /// [`StudyError::NoCondition`] for a spec without conditions.
    pub fn of(spec: &Spec, asked: &Asked) -> Result<Self, StudyError> {
        if spec.conditions.is_empty() {
            return Err(StudyError::NoCondition(spec.file.clone()));
        }
        Ok(Self::without_log(spec, asked))
    }

    /// A log of F_i, u1, u2 and, for estimators, F_o, with the spec's spring; the log's own rate counts.
    ///
    /// # Errors
    /// [`RecordingError`] for a log without one of the three, or not evenly sampled.
    pub fn on(spec: &Spec, asked: &Asked, log: &Recording) -> Result<Self, RecordingError> {
        let [force, first, second] =
            [log.channel(Channel::InputForce)?, log.channel(Channel::U1)?, log.channel(Channel::U2)?];
        let each = force.iter().zip(first).zip(second);
        let measured = each.map(|((force, first), second)| Measured { force: *force, ends: [*first, *second] });
        let recorded = Recorded {
            name: log.account().file.display().to_string(),
            measured: measured.collect(),
            output: log.signals().channel(Channel::OutputForce).ok().map(<[f64]>::to_vec),
        };
        let plain = Self::without_log(spec, asked);
        Ok(Self { recorded: Some(recorded), rate: log.sample_rate()?, seeds: 1, conditions: Vec::new(), ..plain })
    }

    fn without_log(spec: &Spec, asked: &Asked) -> Self {
        let spring = &spec.spring.spring;
        let conditions = spec.conditions.iter();
        let cases = spec.mount.cases.iter();
        Self {
            recorded: None,
            spring: spring.clone(),
            far_end: spec.mount.far_end(),
            conditions: conditions.map(|c| (c.name.clone(), c.excitation.clone(), c.duration)).collect(),
            dampings: cases.map(|case| (case.label.clone(), case.mount.damping().clone())).collect(),
            nominal_damping: spec.mount.cases.len() / 2,
            tolerances: asked.tolerances,
            rate: asked.rate,
            noise: asked.noise.unwrap_or(0.002 * spring.nominal_force()),
            bandwidth: asked.bandwidth.or(spec.goal.bandwidth).unwrap_or(spring.surge_frequency() / 20.0),
            most_lag: asked.most_lag,
            seeds: asked.seeds,
            seed: spec.uncertainty.seed,
        }
    }

    /// Designs and judges every candidate.
    ///
    /// # Errors
    /// Those of the science; a candidate that cannot be is no error but left out.
    pub fn run(self) -> Result<Answer, Error> {
        self.run_watched(&|_, _| ())
    }

    /// The same; `told` hears how many candidates are judged, and of how many.
    ///
    /// # Errors
    /// As [`Self::run`].
    pub fn run_watched(self, told: &(dyn Fn(usize, usize) + Sync)) -> Result<Answer, Error> {
        self.check()?;
        let sampled = SampledSpring::new(&self.spring, &self.dampings[self.nominal_damping].1, self.rate)?;
        let nominal = runs::nominal(&self)?;
        let largest = |of: fn(&runs::Run) -> f64| nominal.iter().map(of).fold(0.0, f64::max);
        // An impact at v rings by Z v; without any ringing a hundredth of the noise stands for it.
        let impact = largest(runs::Run::ringing).max(0.01 * self.noise) / self.spring.wave_impedance();
        let brief = Brief {
            spring: &sampled,
            tolerances: self.tolerances,
            noise: self.noise,
            impact,
            interval: self.longest().min(60.0),
            bandwidth: self.bandwidth,
            // A force that stays where it is in these conditions is wanted up to the bandwidth all the same.
            motion: largest(runs::Run::motion).max(0.01 * self.spring.nominal_force()),
        };
        let mut candidates = Candidates::of(&brief);
        if self.recorded.as_ref().is_some_and(|recorded| recorded.output.is_none()) {
            candidates.all.retain(|candidate| candidate.truth == Truth::Static);
        }
        let shaping = Shaping::of(&self, &sampled)?;
        let trial = self.trial(&sampled, nominal, impact)?;
        let (done, of) = (AtomicUsize::new(0), candidates.all.len());
        told(0, of);
        let mut judged: Vec<(Candidate, Judgement)> = candidates
            .all
            .into_par_iter()
            .map(|candidate| {
                let judgement = trial.judge(&candidate);
                told(done.fetch_add(1, Ordering::Relaxed) + 1, of);
                (candidate, judgement)
            })
            .collect();
        judged.sort_by(order);
        let runs = trial.over_the_box.len();
        let mut answer = Answer { study: self, judged, left_out: candidates.left_out, runs, shown: None, shaping };
        let all: Vec<&Candidate> = answer.judged.iter().map(|(candidate, _)| candidate).collect();
        answer.shown = trial.shown(&all, sampled.surge_period());
        Ok(answer)
    }

    /// Whether what is asked for can be: the sampling rate, the bandwidth, the noise, the series; [`Self::run`] asks first.
    ///
    /// # Errors
    /// [`Error::Value`] for the first that cannot.
    pub fn check(&self) -> Result<(), Error> {
        SampledSpring::new(&self.spring, &self.dampings[self.nominal_damping].1, self.rate)?;
        if !(self.bandwidth > 0.0 && self.bandwidth < self.spring.surge_frequency()) {
            return Err(unfit("bandwidth", self.bandwidth, "Hz", "above zero and below the first surge frequency"));
        }
        if !(self.noise > 0.0 && self.noise.is_finite()) {
            return Err(unfit("noise of the force", self.noise, "N", POSITIVE));
        }
        if self.seeds == 0 {
            return Err(unfit("seeds", 0.0, "", "at least 1"));
        }
        let most = MOST_SAMPLES / self.longest();
        if self.rate > most {
            let allowed = format!("at most {most:.0} Hz, two million samples of the longest run").into();
            return Err(Error::Value { quantity: "rate".into(), value: self.rate, unit: "Hz", allowed });
        }
        Ok(())
    }

    /// How long the longest run takes \[s\].
    fn longest(&self) -> f64 {
        match &self.recorded {
            Some(recorded) => recorded.measured.len() as f64 / self.rate,
            None => self.conditions.iter().map(|condition| condition.2).fold(0.0, f64::max),
        }
    }

    fn trial(&self, sampled: &SampledSpring, nominal: Vec<runs::Run>, impact: f64) -> Result<Trial, Error> {
        let noise = Normal::new(0.0, self.noise).map_err(|_| unfit("noise of the force", self.noise, "N", POSITIVE))?;
        Ok(Trial {
            nominal,
            over_the_box: runs::over_the_box(self)?,
            impact: runs::impact(self, impact)?,
            swing: runs::swing(self, self.bandwidth)?,
            bandwidth: self.bandwidth,
            rate: self.rate,
            noise,
            adds_noise: self.recorded.is_none(),
            seeds: self.seeds,
            seed: self.seed,
            longest_delay: (2.0 * sampled.surge_period()) as usize,
        })
    }
}

/// Every candidate runs over every spring of the box so often: minutes on one core.
const MOST_SAMPLES: f64 = 2e6;
const POSITIVE: &str = "above zero and finite";

fn unfit(quantity: &'static str, value: f64, unit: &'static str, allowed: &'static str) -> Error {
    Error::Value { quantity: quantity.into(), value, unit, allowed: allowed.into() }
}
