//! How far each sensor is off in a case, as a function of where a spring's frequencies lie: found at few places and drawn out between them.
//!
//! Next door: the springs that the tolerances allow (`specimen`), what they make of a verdict (`spread`), one curve (`curve`).

use std::cell::RefCell;

use coilsense::excitation::Content;
use coilsense::modes::ModalModel;
use coilsense::{End, Error, FarEnd};

use super::curve::Curve;
use super::moments::Moments;
use super::refinement::Refinement;
use super::specimen::{Specimen, Specimens};
use super::trial_run::{Request, TrialRun, needs_coil};
use super::ways::{Way, ways};
use crate::spec::ConditionSpec;

/// How far the sensors of a case are off over the springs that tolerances allow.
#[derive(Debug, Clone)]
pub(super) struct Responses {
    axes: Vec<Axis>,
    beside: Vec<f64>,
    /// Whether all errors are in proportion to the stiffness at the same frequencies.
    in_proportion: bool,
}

/// How far each sensor is off along a way.
#[derive(Debug, Clone)]
struct Axis {
    way: Way,
    /// One per sensor.
    curves: Vec<Curve>,
    /// The factor of the surge frequencies where each is largest.
    loudest: Vec<f64>,
}

/// Runs along a way, each made once for all sensors.
struct Runs<'a> {
    run: &'a TrialRun<'a>,
    way: &'a Way,
    far_end: FarEnd,
    /// Coordinates, and the moments of every sensor's errors there.
    done: RefCell<Vec<(f64, Vec<Moments>)>>,
}

impl Runs<'_> {
    /// Moments of a sensor's errors at a coordinate.
    fn moments(&self, x: f64, sensor: usize) -> Result<Moments, Error> {
        let asked = self.run.asked;
        // By inductance only changes count: L is found to second order here.
        if x == 0.0 && !needs_coil(asked.spec, &asked.sensors[sensor..=sensor]) {
            return Ok(asked.known[sensor].1);
        }
        let known =
            |done: &Vec<(f64, Vec<Moments>)>| done.iter().find(|(at, _)| *at == x).map(|(_, each)| each[sensor]);
        if let Some(moments) = known(&self.done.borrow()) {
            return Ok(moments);
        }
        let spring = &asked.spec.spring.spring;
        let each = self.run.moments(self.way.change_at(spring, self.far_end, x))?;
        let moments = each[sensor];
        self.done.borrow_mut().push((x, each));
        Ok(moments)
    }
}

impl Responses {
    /// Of sensors in a case, as far as `specimens` reach.
    pub fn of(asked: &Request<'_>, specimens: &Specimens) -> Result<Self, Error> {
        let spec = asked.spec;
        let mount = &spec.mount.cases[asked.damping].mount;
        let condition = &spec.conditions[asked.condition];
        let run = TrialRun::new(asked)?;
        let mut axes = Vec::new();
        let (spring, far_end) = (&spec.spring.spring, mount.far_end());
        let corners = specimens.corners();
        for way in ways(spring, far_end, specimens) {
            let of = |specimen: &Specimen| way.coordinate(specimen.change);
            let all = specimens.each.iter().chain(&corners).map(of);
            let ends = all.fold((0.0_f64, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
            let places = places(asked, &way, ends)?;
            let runs = Runs { run: &run, way: &way, far_end, done: RefCell::default() };
            let curve = |sensor: usize| {
                let (beside, goal) = (asked.known[sensor].0, asked.goal);
                let samples = Refinement { places: &places, ends, beside, goal }.run(|x| runs.moments(x, sensor))?;
                Ok(Curve::new(samples))
            };
            let curves: Vec<Curve> = (0..asked.sensors.len()).map(curve).collect::<Result<_, Error>>()?;
            let loudest = |curve: &Curve| way.change_at(spring, far_end, curve.loudest())[1].exp();
            axes.push(Axis { loudest: curves.iter().map(loudest).collect(), curves, way });
        }
        let held = |end| condition.excitation.input(end).content() == Content::Nothing;
        let in_proportion = match mount.far_end() {
            FarEnd::Position => true,
            FarEnd::Force => held(End::Two),
            FarEnd::Mass(_) => false,
        };
        let beside = asked.known.iter().map(|(beside, _)| *beside).collect();
        Ok(Self { axes, beside, in_proportion })
    }

    /// What a sensor's error is on a specimen; `nominal` is it on the spec's own spring, as well as it is known.
    pub fn on(&self, sensor: usize, specimen: &Specimen, nominal: Moments) -> Moments {
        let mut moments = nominal;
        for axis in &self.axes {
            let curve = &axis.curves[sensor];
            let at = curve.at(axis.way.coordinate(specimen.change));
            moments.mean += at.mean - curve.nominal().mean;
            // Of one axis whose nominal error is nothing there is no ratio.
            moments.variance = match curve.nominal().variance {
                none if none <= f64::MIN_POSITIVE => moments.variance + at.variance,
                nominal => moments.variance * (at.variance / nominal),
            };
        }
        let factor = if self.in_proportion { specimen.departure.stiffness } else { 1.0 };
        Moments { mean: factor * moments.mean, variance: factor * factor * moments.variance }
    }

    /// Variance \[N²\] of a sensor beside which its oscillation counts.
    pub fn beside(&self, sensor: usize) -> f64 {
        self.beside[sensor]
    }

    /// The mean square of a sensor's error that no specimen exceeds, as far as it was looked at \[N²\].
    pub fn peak(&self, sensor: usize, nominal: Moments) -> f64 {
        let ratio = |curve: &Curve| curve.peak() / curve.nominal().square().max(f64::MIN_POSITIVE);
        self.axes.iter().map(|axis| ratio(&axis.curves[sensor])).product::<f64>() * nominal.square()
    }

    /// How far from the spec's own spring a sensor's error is largest: the factor of the surge frequencies there.
    pub fn loudest(&self, sensor: usize) -> f64 {
        let each = self.axes.iter().map(|axis| axis.loudest[sensor]);
        each.fold(1.0, |far, factor| if (factor - 1.0_f64).abs() > (far - 1.0_f64).abs() { factor } else { far })
    }
}

/// Where to look first: both ends, the spec's own spring, and close together where a line of the input meets a mode.
fn places(asked: &Request<'_>, way: &Way, (low, high): (f64, f64)) -> Result<Vec<f64>, Error> {
    let (spec, condition) = (asked.spec, &asked.spec.conditions[asked.condition]);
    let mount = &spec.mount.cases[asked.damping].mount;
    let mut places = vec![low, 0.0, high];
    let (spring, far_end) = (&spec.spring.spring, mount.far_end());
    // Modes with an end mass are moved each its own way; those of the chain are near enough to look first.
    let modes = match asked.helix.filter(|_| far_end == FarEnd::Position) {
        Some(helix) => helix.surge().model().frequencies().to_vec(),
        None => ModalModel::chain(spring, far_end).frequencies().to_vec(),
    };
    let ratios = mount.damping().ratios(&modes)?;
    let mut lines = Vec::new();
    for end in [End::One, End::Two] {
        match condition.excitation.input(end).content() {
            Content::Lines(sines) => {
                lines.extend(sines.iter().map(|sine| std::f64::consts::TAU * sine.frequency));
                places.extend(over_beats(modes[0], ratios[0], condition, (low, high)));
            }
            Content::Nothing => {}
            // Whatever line there is, it is no narrower than damping and duration make it.
            Content::Broad => {
                let width = width(ratios[0], modes[0], condition.duration);
                let count = ((high - low) / (2.0 * width)).ceil().clamp(2.0, MOST_EVEN);
                places.extend((0..=count as usize).map(|index| low + (high - low) * index as f64 / count));
            }
        }
    }
    for (mode, (frequency, ratio)) in modes.iter().zip(&ratios).enumerate() {
        let width = width(*ratio, *frequency, condition.duration);
        for line in &lines {
            let meets = way.meets(spring, far_end, (mode, *frequency), *line);
            if let Some(meets) = meets.filter(|meets| (low - 3.0 * width..=high + 3.0 * width).contains(meets)) {
                places.extend(AROUND.iter().flat_map(|far| [meets + far * width, meets - far * width]));
            }
        }
    }
    places.retain(|place| (low..=high).contains(place));
    Ok(places)
}

/// Where the free motion of a mode still beats with what drives it, its error goes up and down with its frequency: a few places a beat.
fn over_beats(
    angular: f64,
    ratio: f64,
    condition: &ConditionSpec,
    (low, high): (f64, f64),
) -> impl Iterator<Item = f64> {
    let left = (-ratio * angular * condition.window.0).exp();
    let beats = (high - low) * angular * condition.window.1 / std::f64::consts::TAU;
    let count = if left > FAINT { (A_BEAT * beats).min(MOST_BEATS) as usize } else { 0 };
    // Not evenly, so that they do not keep step with the beats.
    let golden = 0.618_033_988_749_894_9;
    let place = move |index: usize| (index as f64 + (index as f64 * golden).fract()) / count as f64;
    (0..count).map(move |index| low + (high - low) * place(index))
}

/// Free motion that has decayed to this share is not looked for.
const FAINT: f64 = 0.02;
/// Places a beat, and most of them.
const A_BEAT: f64 = 4.0;
const MOST_BEATS: f64 = 80.0;
/// Distances from a resonance at which to look first, in its half widths.
const AROUND: [f64; 6] = [0.0, 0.6, 1.4, 3.0, 6.0, 12.0];
/// Most places spread evenly.
const MOST_EVEN: f64 = 16.0;

/// Half width of a resonance, as a share of its frequency: by damping, or by the time it has.
fn width(ratio: f64, angular: f64, duration: f64) -> f64 {
    ratio.max(2.0 / (angular * duration)).max(1e-6)
}
