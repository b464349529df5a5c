//! `coilsense placement`: which force to feed back, and how fast the loop may then be.
//!
//! Next door: the loop itself (`coilsense::control`), the table `[control]` (`spec::ControlSpec`), how it is told (`report`).

mod answer;
mod judged;

use std::f64::consts::TAU;

use coilsense::control::{Controller, ForceLoop, Gains, Passivity, Plant, Run, SampledLoop, simulate};
use coilsense::{Channel, Error};

pub use answer::answer;
pub use judged::Judged;

use crate::spec::{ControlSpec, DampingCase, Spec};

/// What can go wrong on the way.
#[derive(Debug, thiserror::Error)]
pub enum PlacementError {
    /// The spec has no loop, or none whose spring is damped.
    #[error("{0}")]
    Spec(String),
    /// The science refuses.
    #[error("{file}: [control]: {source}")]
    Science {
        /// The spec.
        file: String,
        /// Why.
        source: Error,
    },
}

/// A force that could be fed back, judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The force.
    pub channel: Channel,
    /// One for each damping, as [`Placement::dampings`].
    pub judged: Vec<Judged>,
}

/// All forces judged, and the gain at which they are compared.
#[derive(Debug, Clone, PartialEq)]
pub struct Placement {
    /// The spec.
    pub spec: Spec,
    /// Its loop.
    pub control: ControlSpec,
    /// The dampings, each above zero.
    pub dampings: Vec<DampingCase>,
    /// Whether the spec also asks for a spring without damping, which is left out.
    pub undamped_left_out: bool,
    /// F_i, F_o, F_x, F_L.
    pub candidates: Vec<Candidate>,
    /// The one with the fastest loop of a sensitivity of at most 2 at every damping.
    pub best: usize,
    /// The crossover of the loop as it is set, with a spring without mass \[Hz\].
    pub crossover: f64,
    /// The proportional gain that makes it so (command unit per N).
    pub gain: f64,
    /// The sampled loop over time with the best force, where it can be run, at the set gain.
    pub run: Option<Run>,
    /// Whether the same loop, run at 0.98 and 1.02 of the limit that was predicted for it, stayed and ran away; `None` where there is no
    /// limit, or no run.
    pub confirmed: Option<bool>,
}

/// Samples of the run that is shown, and of those that confirm a limit.
const SHOWN: f64 = 1.0;
const CONFIRMED_PERIODS: f64 = 1500.0;

impl Placement {
    /// Judges every force of a spec's loop.
    ///
    /// # Errors
    /// [`PlacementError`] where the spec has no `[control]`, no damping above zero, or the science refuses.
    pub fn of(spec: Spec) -> Result<Self, PlacementError> {
        let Some(control) = spec.control else {
            return Err(PlacementError::Spec(format!("{}: the table [control] is missing", spec.file)));
        };
        let is_damped = |case: &&DampingCase| case.ratio.is_none_or(|ratio| ratio > 0.0);
        let dampings: Vec<DampingCase> = spec.mount.cases.iter().filter(is_damped).cloned().collect();
        if dampings.is_empty() {
            let text =
                "[mount] damping_ratio = 0: must be above zero for a loop: without damping none on F_o is stable";
            return Err(PlacementError::Spec(format!("{}: {text}", spec.file)));
        }
        let file = spec.file.clone();
        let science = |source| PlacementError::Science { file: file.clone(), source };
        let unit = UnitLoops { spec: &spec, control: &control };
        let shape = unit.gain_for(&dampings[0], control.crossover.unwrap_or(0.1 * unit.surge())).map_err(science)?;
        let judge = |channel| {
            let judged = dampings.iter().map(|damping| Judged::of(&unit, damping, channel, shape));
            Ok(Candidate { channel, judged: judged.collect::<Result<_, Error>>()? })
        };
        let mut candidates = Channel::FORCES.map(judge).into_iter().collect::<Result<Vec<_>, _>>().map_err(science)?;
        let best = best(&candidates);
        let robust = candidates[best].robust_crossover();
        let crossover = control.crossover.unwrap_or(robust.min(unit.most()));
        let gain = unit.gain_for(&dampings[0], crossover).map_err(science)?;
        for candidate in &mut candidates {
            for (judged, damping) in candidate.judged.iter_mut().zip(&dampings) {
                judged.set(&unit, damping, candidate.channel, gain).map_err(science)?;
            }
        }
        let (run, confirmed) = runs(&unit, &dampings, &candidates[best], gain).map_err(science)?;
        let undamped_left_out = dampings.len() < spec.mount.cases.len();
        Ok(Self { control, dampings, undamped_left_out, candidates, best, crossover, gain, run, confirmed, spec })
    }

    /// The damping whose curves are shown: the middle one.
    pub fn shown(&self) -> usize {
        self.dampings.len() / 2
    }

    /// The loop of a force at the set gain.
    ///
    /// # Errors
    /// Those of the science.
    pub fn force_loop(&self, damping: usize, channel: Channel) -> Result<ForceLoop, Error> {
        UnitLoops { spec: &self.spec, control: &self.control }.force_loop(&self.dampings[damping], channel, self.gain)
    }
}

impl Candidate {
    /// The largest crossover at which it is stable at every damping \[Hz\], of the loop with a spring without mass.
    pub fn stable_crossover(&self) -> f64 {
        self.judged.iter().map(|judged| judged.stable_crossover).fold(f64::INFINITY, f64::min)
    }

    /// The same with a sensitivity of at most 2.
    pub fn robust_crossover(&self) -> f64 {
        self.judged.iter().map(|judged| judged.robust_crossover).fold(f64::INFINITY, f64::min)
    }

    /// Whether it is stable as it is set, at every damping.
    pub fn is_stable(&self) -> bool {
        self.judged.iter().all(|judged| judged.margins.stable)
    }
}

/// The fastest; of equals the one that comes first but for F_L, which needs a calibration and a meter that is quick enough.
fn best(candidates: &[Candidate]) -> usize {
    let order = |index: &usize| (candidates[*index].robust_crossover(), usize::MAX - index);
    let mut indices: Vec<usize> = (0..candidates.len()).collect();
    indices.sort_by(|a, b| {
        let (a, b) = (order(a), order(b));
        b.0.total_cmp(&a.0).then(b.1.cmp(&a.1))
    });
    indices.first().copied().unwrap_or(0)
}

/// Makes loops of a spec.
#[derive(Clone, Copy)]
struct UnitLoops<'a> {
    spec: &'a Spec,
    control: &'a ControlSpec,
}

impl UnitLoops<'_> {
    fn surge(&self) -> f64 {
        self.spec.spring.spring.surge_frequency()
    }

    /// The crossover past which nothing is asked \[Hz\]: the tenth surge line, or a quarter of the sample rate.
    fn most(&self) -> f64 {
        let by_samples = self.control.sample_time.map_or(f64::INFINITY, |step| 0.25 / step);
        by_samples.min(10.0 * self.surge())
    }

    fn force_loop(&self, damping: &DampingCase, channel: Channel, gain: f64) -> Result<ForceLoop, Error> {
        let spring = &self.spec.spring.spring;
        let plant = Plant::new(spring, damping.mount.damping().clone(), self.control.drive, self.control.environment)?;
        let shape = self.control.shape;
        let controller = Controller::new(Gains {
            proportional: gain * shape.proportional,
            integral: gain * shape.integral,
            derivative: gain * shape.derivative,
            ..shape
        })?;
        ForceLoop::new(plant, controller, channel, self.control.delay)
    }

    fn sampled(&self, force_loop: &ForceLoop) -> Result<Option<SampledLoop>, Error> {
        self.control.sample_time.map(|step| SampledLoop::new(force_loop, step)).transpose()
    }

    /// The proportional gain with which the loop of a spring without mass crosses 1 at so many hertz.
    fn gain_for(&self, damping: &DampingCase, crossover: f64) -> Result<f64, Error> {
        let size = |gain: f64| {
            let unit = self.force_loop(damping, Channel::DeflectionForce, gain)?;
            Ok::<f64, Error>(unit.massless(TAU * crossover)?.norm())
        };
        if self.control.shape.observer_bandwidth.is_none() {
            return Ok(1.0 / size(1.0)?);
        }
        // An observer adds to the loop whatever the gain: from where it alone is below 1, by bisection.
        let (mut low, mut high) = (1e-12, 1e12);
        for _ in 0..200 {
            let middle = f64::sqrt(low * high);
            if size(middle)? < 1.0 { low = middle } else { high = middle }
        }
        Ok(low)
    }

    fn passivity(&self, force_loop: &ForceLoop) -> Result<Option<Passivity>, Error> {
        if force_loop.feedback() == Channel::InductanceForce {
            return Ok(None);
        }
        // A command held for one sample time is late by half of it.
        let late = self.control.delay + 0.5 * self.control.sample_time.unwrap_or(0.0);
        let late = ForceLoop::new(force_loop.plant().clone(), *force_loop.controller(), force_loop.feedback(), late)?;
        Passivity::of(&late, self.control.passive_up_to).map(Some)
    }
}

/// The best force's loop over time at the least damping, and whether its limit holds; neither where the engine cannot run it.
fn runs(
    unit: &UnitLoops<'_>,
    dampings: &[DampingCase],
    best: &Candidate,
    gain: f64,
) -> Result<(Option<Run>, Option<bool>), Error> {
    let Some(step) = unit.control.sample_time else { return Ok((None, None)) };
    let limits = best.judged.iter().map(|judged| judged.limit).enumerate();
    let weakest = limits.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(index, _)| index);
    let Some(sampled) = unit.sampled(&unit.force_loop(&dampings[weakest], best.channel, gain)?)? else {
        return Ok((None, None));
    };
    let reference = 0.01 * unit.spec.spring.spring.nominal_force();
    let samples = (SHOWN / step).min(1e5) as usize;
    let Ok(run) = simulate(&sampled, 1.0, reference, samples) else { return Ok((None, None)) };
    let limit = best.judged[weakest].margins.gain_limit;
    if !limit.is_finite() || limit == 0.0 {
        return Ok((Some(run), None));
    }
    let long = (CONFIRMED_PERIODS / unit.surge() / step).min(2e5) as usize;
    let grows = |factor: f64| Ok::<bool, Error>(grows(&simulate(&sampled, factor * limit, reference, long)?, long));
    let confirmed = !grows(0.98)? && grows(1.02)?;
    Ok((Some(run), Some(confirmed)))
}

/// Whether what rings at the end of a run rings more than half way through it.
fn grows(run: &Run, samples: usize) -> bool {
    let swing = |part: &[f64]| {
        let mean = part.iter().sum::<f64>() / part.len().max(1) as f64;
        part.iter().map(|value| (value - mean).abs()).fold(0.0, f64::max)
    };
    let eighth = samples / 8;
    run.output.len() < samples
        || swing(&run.output[samples - eighth..]) > swing(&run.output[samples / 2..samples / 2 + eighth])
}
