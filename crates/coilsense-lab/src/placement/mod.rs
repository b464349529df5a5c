//! `coilsense placement`: which force to feed back, and how fast the loop may then be.
//!
//! Next door: the loop itself (`coilsense::control`), the table `[control]` (`spec::ControlSpec`), how it is told (`report`).

mod allowed;
mod answer;
mod calm;
mod estimated;
mod head;
mod judged;
mod loops;
mod over_time;
mod reading;
mod told;
mod words;

use std::f64::consts::TAU;

use coilsense::control::{ForceLoop, Point};
use coilsense::{Channel, Error};
use rayon::prelude::*;

pub use allowed::{Allowed, Varied};
pub use answer::answer;
pub(crate) use answer::answered;
pub use calm::{MOST_PEAK, Peak};
pub use estimated::{Estimated, TOLERANCE};
pub(crate) use head::FOLLOWS;
pub use judged::Assessment;
use loops::{Under, UnitLoops};
pub use over_time::{BESIDE, LoopRun, Verdict};
pub use reading::{CLEAR, Reading};
pub use told::drive_words;

use crate::quantity::digits;
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

/// A force that could be fed back, judged on some springs: the least of what holds on them.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The force.
    pub channel: Channel,
    /// One for each damping, as [`Placement::dampings`].
    pub judged: Vec<Assessment>,
    /// The largest crossover with a sensitivity of at most 2 at which both end forces stay within [`MOST_PEAK`] of their static answer at
    /// every damping \[Hz\]; zero without one.
    pub calm_crossover: f64,
    /// What exceeds that at the largest crossover with a sensitivity of at most 2 \[Hz\], or the largest that is asked.
    pub rings: Option<(f64, Peak)>,
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
    /// The springs that the spec allows.
    pub allowed: Allowed,
    /// How late each force is read, as [`Channel::FORCES`].
    pub readings: Vec<Reading>,
    /// F_i, F_o, F_x, F_L, on all of them.
    pub candidates: Vec<Candidate>,
    /// The same on the nominal spring alone.
    pub nominal: Vec<Candidate>,
    /// Which of those would be fed back if there were no other spring.
    pub nominal_best: usize,
    /// The same behind estimators, where they can be had.
    pub estimates: Vec<Estimated>,
    /// The one with the fastest loop of a sensitivity of at most 2 at every damping in which neither end rings; where all ring, without that.
    pub best: usize,
    /// Those that are as fast within 1 %.
    pub ties: Vec<usize>,
    /// The crossover of the loop as it is set, with a spring without mass \[Hz\].
    pub crossover: f64,
    /// The proportional gain that makes it so (command unit per N).
    pub gain: f64,
    /// F_o over a slow reference \[1\], and up to where it stays within 3 dB of the reference \[Hz\], infinite where nothing up to the fourth surge line
    /// ends that: with the loop as set on the nominal spring, the least of all dampings; `None` where that loop is unstable.
    pub follows: Option<[f64; 2]>,
    /// Every loop over time, in samples or continuous as it is judged: each force, then each estimate.
    pub runs: Vec<LoopRun>,
}

impl Placement {
    /// Judges every force of a spec's loop.
    ///
    /// # Errors
    /// [`PlacementError`] where the spec has no `[control]`, no damping above zero, or the science refuses.
    pub fn of(mut spec: Spec) -> Result<Self, PlacementError> {
        let (control, dampings) = asked(&spec)?;
        spec.spring.look_up_surges(&spec.mount.ends);
        let file = spec.file.clone();
        let science = |source| PlacementError::Science { file: file.clone(), source };
        let readings = Reading::all(&spec, &control).map_err(science)?;
        let unit = UnitLoops { spec: &spec, control: &control, readings: &readings };
        let allowed = Allowed::of(&spec.spring).map_err(science)?;
        allowed.check_samples(&spec.file, control.sample_time)?;
        let judge = Judge { unit, dampings: &dampings, springs: &allowed.each };
        let alone = Judge { springs: allowed.nominal(), ..judge };
        let (mut candidates, mut nominal) = (judge.all().map_err(science)?, alone.all().map_err(science)?);
        let crossover = match control.crossover {
            Some(crossover) => crossover,
            None => advised(&candidates[leading(&candidates, &readings, false)[0]], unit.most()).ok_or_else(|| {
                PlacementError::Spec(format!("{file}: [control]: no loop on any of the forces is stable at any gain"))
            })?,
        };
        let gain = unit.gain_for(&dampings[0], crossover).map_err(science)?;
        if unit.is_observers(&dampings[0], crossover).map_err(science)? {
            return Err(PlacementError::Spec(format!(
                "{file}: [control]: at a crossover of {} Hz the observer alone carries the loop, whatever the gain: set a larger crossover or a smaller \
                 observer_bandwidth",
                digits(crossover)
            )));
        }
        judge.set(&mut candidates, gain).map_err(science)?;
        alone.set(&mut nominal, gain).map_err(science)?;
        let is_given = control.crossover.is_some();
        let leading_of = |candidates: &[Candidate]| leading(candidates, &readings, is_given);
        let (leading, nominal_best) = (leading_of(&candidates), leading_of(&nominal)[0]);
        let best = leading[0];
        let estimates = estimated::all(&unit, &dampings, gain, &allowed).map_err(science)?;
        let runs = over_time::runs(&unit, &dampings, &candidates, &estimates, &allowed, gain).map_err(science)?;
        let undamped_left_out = dampings.len() < spec.mount.cases.len();
        let ties = leading[1..].to_vec();
        let mut placement = Self {
            control,
            dampings,
            undamped_left_out,
            nominal_best,
            allowed,
            readings,
            candidates,
            nominal,
            estimates,
            best,
            ties,
            crossover,
            gain,
            runs,
            follows: None,
            spec,
        };
        placement.follows = placement.followed().map_err(science)?;
        Ok(placement)
    }

    /// How late a force is read.
    pub fn reading(&self, channel: Channel) -> &Reading {
        let place = Channel::FORCES.iter().position(|force| *force == channel);
        &self.readings[place.unwrap_or_default()]
    }

    fn followed(&self) -> Result<Option<[f64; 2]>, Error> {
        if !self.nominal[self.best].is_stable() {
            return Ok(None);
        }
        let mut least = [f64::INFINITY; 2];
        for damping in 0..self.dampings.len() {
            let points = self.tracking(damping, self.candidates[self.best].channel)?;
            let slow = points.first().map_or(0.0, |point| point.response.norm());
            least = [least[0].min(slow), least[1].min(followed_up_to(&points))];
        }
        Ok(Some(least))
    }

    /// The run of the force that is to be fed back.
    pub fn best_run(&self) -> &LoopRun {
        &self.runs[self.best]
    }

    /// The damping whose curves are shown: the middle one.
    pub fn shown(&self) -> usize {
        self.dampings.len() / 2
    }

    /// F_o over its reference with the loop on a force closed as it is set, in samples where the controller is, on the nominal spring, read as late as makes
    /// it largest.
    ///
    /// # Errors
    /// Those of the science.
    pub fn tracking(&self, damping: usize, channel: Channel) -> Result<Vec<Point>, Error> {
        let (unit, spring) = (self.unit(), &self.spec.spring.spring);
        let mut loudest: Vec<Point> = Vec::new();
        let largest = |points: &[Point]| points.iter().map(|point| point.response.norm()).fold(0.0, f64::max);
        for &delay in unit.delays(channel) {
            let under = Under { place: 0, spring, delay };
            let closed = unit.closed(unit.on(under, &self.dampings[damping], channel, self.gain)?)?;
            let watched = calm::watched(&closed)?;
            let points = watched.iter().map(|watched| calm::tracked(&closed, watched));
            let points = points.collect::<Result<Vec<_>, Error>>()?;
            if largest(&points) > largest(&loudest) {
                loudest = points;
            }
        }
        Ok(loudest)
    }

    /// The loop of a force at the set gain, on the nominal spring.
    ///
    /// # Errors
    /// Those of the science.
    pub fn force_loop(&self, damping: usize, channel: Channel) -> Result<ForceLoop, Error> {
        self.unit().force_loop(&self.dampings[damping], channel, self.gain)
    }

    fn unit(&self) -> UnitLoops<'_> {
        UnitLoops { spec: &self.spec, control: &self.control, readings: &self.readings }
    }
}

/// The loop of a spec and its dampings.
fn asked(spec: &Spec) -> Result<(ControlSpec, Vec<DampingCase>), PlacementError> {
    spec.needs_chain("placement").map_err(|refused| PlacementError::Spec(refused.to_string()))?;
    spec.needs_no_contact("placement").map_err(|refused| PlacementError::Spec(refused.to_string()))?;
    let Some(control) = spec.control else {
        let text = "the table [control] is missing; it says how the spring is driven, at least: drive = \"velocity\", or drive = \"force\" and motor_mass";
        return Err(PlacementError::Spec(format!("{}: {text}", spec.file)));
    };
    let is_damped = |case: &&DampingCase| case.ratio.is_none_or(|ratio| ratio > 0.0);
    let dampings: Vec<DampingCase> = spec.mount.cases.iter().filter(is_damped).cloned().collect();
    if dampings.is_empty() {
        let text = "[mount] damping_ratio = 0: must be above zero for a loop: without damping none on F_o is stable";
        return Err(PlacementError::Spec(format!("{}: {text}", spec.file)));
    }
    Ok((control, dampings))
}

/// Where a response leaves what follows a reference within 3 dB \[Hz\], on the straight line between two of its points; infinite where it never does.
fn followed_up_to(points: &[Point]) -> f64 {
    let size = |point: &Point| point.response.norm();
    let follows = |point: &Point| (head::FOLLOWS..=1.0 / head::FOLLOWS).contains(&size(point));
    let lost = points.windows(2).find(|pair| follows(&pair[0]) && !follows(&pair[1]));
    let Some([a, b]) = lost else { return f64::INFINITY };
    let bound = if size(b) < size(a) { head::FOLLOWS } else { 1.0 / head::FOLLOWS };
    let share = (size(a) - bound) / (size(a) - size(b));
    (a.angular_frequency + share * (b.angular_frequency - a.angular_frequency)) / TAU
}

/// Judges all forces on some springs.
#[derive(Clone, Copy)]
struct Judge<'a> {
    unit: UnitLoops<'a>,
    dampings: &'a [DampingCase],
    springs: &'a [Varied],
}

impl Judge<'_> {
    fn all(&self) -> Result<Vec<Candidate>, Error> {
        let Self { unit, dampings, springs } = self;
        let shape = unit.gain_for(&dampings[0], unit.control.crossover.unwrap_or(0.1 * unit.surge()))?;
        let judge = |channel| {
            let judged = dampings.iter().map(|damping| Assessment::of(unit, damping, channel, shape, springs));
            let mut candidate =
                Candidate { channel, judged: judged.collect::<Result<_, Error>>()?, calm_crossover: 0.0, rings: None };
            let most = candidate.robust_crossover().min(unit.most());
            let calm = calm::calm(unit, dampings, springs, channel, [candidate.robust_from(), most])?;
            candidate.calm_crossover = calm.crossover;
            candidate.rings = calm.rings.map(|peak| (most, peak));
            Ok(candidate)
        };
        Channel::FORCES.into_par_iter().map(judge).collect()
    }

    fn set(&self, candidates: &mut [Candidate], gain: f64) -> Result<(), Error> {
        candidates.par_iter_mut().try_for_each(|candidate| {
            let channel = candidate.channel;
            let mut each = candidate.judged.iter_mut().zip(self.dampings);
            each.try_for_each(|(judged, damping)| judged.set(&self.unit, damping, channel, gain, self.springs))
        })
    }
}

impl Candidate {
    /// The largest crossover at which it is stable at every damping \[Hz\], of the loop with a spring without mass.
    pub fn stable_crossover(&self) -> f64 {
        self.judged.iter().map(|judged| judged.stable_crossover).fold(f64::INFINITY, f64::min)
    }

    /// The same with a sensitivity of at most 2; zero without one.
    pub fn robust_crossover(&self) -> f64 {
        self.robust()[1]
    }

    /// The crossover from which on its sensitivity is at most 2 at every damping \[Hz\]; zero where it is in the slowest loop, too.
    pub fn robust_from(&self) -> f64 {
        self.robust()[0]
    }

    fn robust(&self) -> [f64; 2] {
        let from = self.judged.iter().map(|judged| judged.robust_from).fold(0.0, f64::max);
        let up_to = self.judged.iter().map(|judged| judged.robust_crossover).fold(f64::INFINITY, f64::min);
        if from < up_to { [from, up_to] } else { [0.0; 2] }
    }

    /// How good the loop is as it is set: stable, with a sensitivity of at most 2, and quiet besides.
    fn as_set(&self) -> f64 {
        let peaks = self.judged.iter().filter_map(|judged| judged.peaks).flatten();
        let is_quiet = peaks.fold(0.0, |most: f64, peak| most.max(peak.over_static)) <= MOST_PEAK * (1.0 + SLACK);
        let is_robust = self.judged.iter().all(|judged| judged.margins.modulus >= 0.5 * (1.0 - SLACK));
        let each = [true, is_robust, is_robust && is_quiet].map(|holds| self.is_stable() && holds);
        each.into_iter().map(|holds| f64::from(u8::from(holds))).sum()
    }

    /// Whether it is stable as it is set, at every damping.
    pub fn is_stable(&self) -> bool {
        self.judged.iter().all(|judged| judged.margins.stable)
    }
}

/// A limit that was found by halving is met this nearly \[1\].
const SLACK: f64 = 1e-3;

/// Crossovers this near each other count as one \[1\]: no spring and no controller is known better.
pub(super) const TIE: f64 = 0.01;

/// The fastest in which neither end rings, of equals the fastest at all: each that is within [`TIE`] of them, F_L last, which needs a calibration and a
/// meter that is quick enough. Where the crossover `is_given`, one with which nothing rings as set, else a sensible one, else a stable one. Forces that the
/// spec's sensors measure come first, then, where it has sensors, those that none does, then those that one shows too coarsely.
fn leading(candidates: &[Candidate], readings: &[Reading], is_given: bool) -> Vec<usize> {
    let has_sensors = readings.iter().any(|reading| reading.sensor.is_some());
    let clear = |index: usize| match &readings[index] {
        Reading { coarse: Some(_), .. } => 1.0,
        Reading { sensor: None, .. } if has_sensors => 2.0,
        _ => 3.0,
    };
    let as_set = |index: usize| if is_given { candidates[index].as_set() } else { 0.0 };
    let measures: [&dyn Fn(usize) -> f64; 5] = [
        &|index| if candidates[index].stable_crossover() > 0.0 { clear(index) } else { 0.0 },
        &as_set,
        &|index| candidates[index].calm_crossover,
        &|index| candidates[index].robust_crossover(),
        &|index| if candidates[index].robust_crossover() > 0.0 { 0.0 } else { candidates[index].stable_crossover() },
    ];
    let mut left: Vec<usize> = (0..candidates.len()).collect();
    for measure in measures {
        let most = left.iter().map(|&index| measure(index)).fold(0.0, f64::max);
        left.retain(|&index| measure(index) >= (1.0 - TIE) * most);
    }
    left
}

/// The crossover that is set where none is given \[Hz\]: quiet, else robust, else half of what is stable; `None` where nothing is.
fn advised(best: &Candidate, most: f64) -> Option<f64> {
    let each = [best.calm_crossover, best.robust_crossover().min(most), 0.5 * best.stable_crossover().min(most)];
    each.into_iter().find(|crossover| *crossover > 0.0)
}
