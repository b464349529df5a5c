//! A study: conditions, noise, tolerances.
//!
//! Next door: what may be asked (`request`), a log to judge on (`recorded`), how it is run (`run`), what comes of it (`ranking`), the answer as text and JSON (`report`).

use std::borrow::Cow;

use coilsense::excitation::{EndInput, Start, VelocityProfile};
use coilsense::mitigation::{SampledSpring, ToleranceBox};
use coilsense::{Damping, Error, Excitation, FarEnd, Spring};

use super::recorded::{Known, Recorded};
use super::request::{BANDWIDTH, NOISE, RATE, Refused, Request, SEEDS};
use super::sources::{self, Source, Sources};
use crate::calibration::Applied;
use crate::recording::{Recording, RecordingError};
use crate::request::Row;
use crate::spec::{Spec, SpecError};

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
    /// Most lag at the bandwidth that a recommendation may have \[rad\].
    pub most_lag: f64,
    /// Where its numbers are from.
    pub sources: Sources,
    /// How many series of noise.
    pub seeds: u64,
    /// The first one's seed.
    pub seed: u64,
}

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The spec has nothing to judge on.
    #[error("{0}: [[condition]] must be there at least once to judge on")]
    NoCondition(String),
    /// The spec's model is none for this.
    #[error(transparent)]
    Model(#[from] SpecError),
    /// Its tolerances, with those that are asked for, are none.
    #[error("{0}")]
    Tolerances(String),
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
            most_lag: 30_f64.to_radians(),
            sources: Sources::ASKED,
            seeds: 50,
            seed: 1,
        })
    }

    /// The conditions and dampings of a spec. What is not asked is the spec's: the rate of its `[control]`, the noise of its load cell at end 1, its
    /// tolerances, its goal's bandwidth; where it says nothing, 2.5 kHz, 0.2 % of F_nom, 10 % and f1/20.
    ///
    /// # Errors
    /// [`StudyError::NoCondition`] for a spec without conditions, [`StudyError::Model`] for one of a helix,
    /// [`StudyError::Tolerances`] where spec and options leave none.
    pub fn of(spec: &Spec, asked: &Request) -> Result<Self, StudyError> {
        spec.needs_chain("mitigate")?;
        spec.needs_no_contact("mitigate")?;
        if spec.conditions.is_empty() {
            return Err(StudyError::NoCondition(spec.file.clone()));
        }
        Self::without_log(spec, asked).map_err(StudyError::Tolerances)
    }

    /// A log of F_i, u1, u2 and, for estimators, F_o, with the spec's spring, or with that of the log's stiffness where that is another; the
    /// log's own rate counts. A held end 2 needs no u2.
    ///
    /// # Errors
    /// [`RecordingError`] for a log without one of the three, not evenly sampled, of another spring, or with a turned sign.
    pub fn on(spec: &Spec, asked: &Request, log: &Recording) -> Result<Self, RecordingError> {
        Self::on_log(spec, asked, log, None)
    }

    /// The same with the coil's length by its inductance: it takes the place of an end that was not recorded; where both were, it tells where they
    /// count from.
    ///
    /// - `applied`: a stored calibration, applied to this log
    ///
    /// # Errors
    /// As [`Self::on`], and for lengths that are not those of the ends.
    pub fn on_lengths(
        spec: &Spec,
        asked: &Request,
        log: &Recording,
        applied: &Applied,
    ) -> Result<Self, RecordingError> {
        Self::on_log(spec, asked, log, Some(applied))
    }

    fn on_log(
        spec: &Spec,
        asked: &Request,
        log: &Recording,
        by_inductance: Option<&Applied>,
    ) -> Result<Self, RecordingError> {
        let plain = Self::without_log(spec, asked).map_err(RecordingError::of_words)?;
        let rate = log.sample_rate()?;
        let is_held = matches!(plain.far_end, FarEnd::Position);
        let known = Known { spring: &plain.spring, is_held, tolerance: plain.tolerances.stiffness() };
        let (recorded, spring) = Recorded::of(&known, asked, log, by_inductance)?;
        let sources = Sources { rate: Source::Asked, ..plain.sources.clone() };
        Ok(Self { recorded: Some(recorded), spring, rate, sources, seeds: 1, conditions: Vec::new(), ..plain })
    }

    fn without_log(spec: &Spec, asked: &Request) -> Result<Self, String> {
        let spring = &spec.spring.spring;
        let conditions = spec.conditions.iter();
        let cases = spec.mount.cases.iter();
        let ((rate, rate_by), (noise, noise_by)) = (sources::rate(spec, asked), sources::noise(spec, asked));
        let (tolerances, [stiffness, mass]) =
            sources::tolerances(spec, asked).map_err(|error| format!("{}: {error}", spec.file))?;
        Ok(Self {
            recorded: None,
            spring: spring.clone(),
            far_end: spec.mount.far_end(),
            conditions: conditions.map(|c| (c.name.clone(), c.excitation.clone(), c.duration)).collect(),
            dampings: cases.map(|case| (case.label.clone(), case.mount.damping().clone())).collect(),
            nominal_damping: spec.mount.cases.len() / 2,
            tolerances,
            rate,
            noise,
            bandwidth: asked.bandwidth.or(spec.goal.bandwidth).unwrap_or(spring.surge_frequency() / 20.0),
            most_lag: asked.most_lag,
            sources: Sources { rate: rate_by, noise: noise_by, stiffness, mass },
            seeds: asked.seeds,
            seed: spec.uncertainty.seed,
        })
    }

    /// Whether what is asked for can be: the sampling rate, the bandwidth, the noise, the series; [`Self::run`] asks first.
    ///
    /// # Errors
    /// [`Refused`] for the first that cannot, with the option that it is about.
    pub fn check(&self) -> Result<(), Refused> {
        let of = |row: &'static Row| move |error| Refused::of(row, error);
        SampledSpring::check_rate(&self.spring, self.rate).map_err(|error| self.of_rate(error))?;
        SampledSpring::new(&self.spring, &self.dampings[self.nominal_damping].1, self.rate)?;
        if !(self.bandwidth > 0.0 && self.bandwidth < self.spring.surge_frequency()) {
            let allowed = "above zero and below the first surge frequency";
            return Err(of(&BANDWIDTH)(unfit(&BANDWIDTH, "bandwidth", self.bandwidth, "Hz", allowed)));
        }
        if !(self.noise > 0.0 && self.noise.is_finite()) {
            return Err(of(&NOISE)(unfit(&NOISE, "noise of the force", self.noise, "N", POSITIVE)));
        }
        if self.seeds == 0 {
            return Err(of(&SEEDS)(unfit(&SEEDS, "seeds", 0.0, "", "at least 1")));
        }
        let most = MOST_SAMPLES / self.longest();
        if self.rate > most {
            let allowed = format!("at most {most:.0} Hz, two million samples of the longest run");
            return Err(self.of_rate(unfit(&RATE, "sampling rate", self.rate, "Hz", allowed)));
        }
        Ok(())
    }

    /// A rate that cannot be: the option's, or the spec's.
    fn of_rate(&self, error: Error) -> Refused {
        match (&self.sources.rate, error) {
            (Source::Spec(_), Error::Value { value, unit, allowed, .. }) => Refused::from(Error::Value {
                field: None,
                quantity: "1/sample_time of [control]".into(),
                value,
                unit,
                allowed,
            }),
            (_, error) => Refused::of(&RATE, error),
        }
    }

    /// How long the longest run takes \[s\].
    pub(super) fn longest(&self) -> f64 {
        match &self.recorded {
            Some(recorded) => recorded.measured.len() as f64 / self.rate,
            None => self.conditions.iter().map(|condition| condition.2).fold(0.0, f64::max),
        }
    }
}

/// Every candidate runs over every spring of the box so often: minutes on one core.
const MOST_SAMPLES: f64 = 2e6;
pub(super) const POSITIVE: &str = "above zero and finite";

/// That the value of an option cannot be, with what people call it.
pub(super) fn unfit(
    row: &Row,
    quantity: &'static str,
    value: f64,
    unit: &'static str,
    allowed: impl Into<Cow<'static, str>>,
) -> Error {
    Error::Value { field: Some(row.name), quantity: quantity.into(), value, unit, allowed: allowed.into() }
}
