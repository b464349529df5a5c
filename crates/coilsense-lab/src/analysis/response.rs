//! How far each sensor is off in a case, as a function of where a spring's frequencies lie: found at few places and drawn out between them.
//!
//! Next door: the springs that the tolerances allow (`specimen`), what they make of a verdict (`spread`), one curve (`curve`).

use std::cell::RefCell;

use coilsense::modes::ChainModes;
use coilsense::{Channel, End, EndInput, Error, FarEnd, Mount, Spring, SpringParameters};

use super::curve::Curve;
use super::refinement::Refinement;
use super::specimen::{Specimen, Specimens};
use super::trial_run::TrialRun;
use crate::spec::{SensorSpec, Spec};

/// A change of stiffness at the same surge frequencies, and of surge frequencies at the same stiffness: ln κ and ln s.
pub(super) type Change = [f64; 2];

/// How far the sensors of a case are off over the springs that tolerances allow.
#[derive(Debug, Clone)]
pub(super) struct Responses {
    axes: Vec<Axis>,
    /// Whether all errors are in proportion to the stiffness at the same frequencies.
    in_proportion: bool,
}

/// A way in which frequencies move, and how far each sensor is off along it.
#[derive(Debug, Clone)]
struct Axis {
    /// Change of stiffness and of surge frequencies per unit of the coordinate.
    along: Change,
    /// The coordinate of a change.
    coordinate: Change,
    /// One per sensor.
    curves: Vec<Curve>,
}

/// Mean and spread of an error over time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Moments {
    /// Mean \[N\].
    pub mean: f64,
    /// Variance about it \[N²\].
    pub variance: f64,
}

impl Moments {
    pub fn of(errors: &[f64]) -> Self {
        let count = errors.len().max(1) as f64;
        let mean = errors.iter().sum::<f64>() / count;
        Self { mean, variance: errors.iter().map(|error| (error - mean).powi(2)).sum::<f64>() / count }
    }

    /// Mean square \[N²\].
    pub fn square(&self) -> f64 {
        self.variance + self.mean * self.mean
    }
}

/// What a case's responses are found for.
pub(super) struct Asked<'a> {
    pub spec: &'a Spec,
    pub coil: &'a coilsense::inductance::MaxwellSum,
    pub condition: usize,
    pub damping: usize,
    pub sensors: &'a [&'a SensorSpec],
    /// Variances \[N²\] beside which an oscillation need not be known better, one per sensor.
    pub beside: &'a [f64],
    /// Errors on the nominal spring, one per sensor, by the whole run.
    pub nominal: &'a [Moments],
    /// The goal \[N\], where the share of springs inside it is wanted.
    pub goal: Option<f64>,
}

/// Runs along an axis, each made once for all sensors.
struct Runs<'a> {
    run: &'a TrialRun<'a>,
    along: Change,
    /// Coordinates, and the moments of every sensor's errors there.
    done: RefCell<Vec<(f64, Vec<Moments>)>>,
}

impl Runs<'_> {
    /// Moments of a sensor's errors at a coordinate.
    fn moments(&self, x: f64, sensor: usize) -> Result<Moments, Error> {
        let asked = self.run.asked;
        // By inductance only changes count: L is found to second order here.
        if x == 0.0 && !needs_coil(asked.spec, &asked.sensors[sensor..=sensor]) {
            return Ok(asked.nominal[sensor]);
        }
        let known =
            |done: &Vec<(f64, Vec<Moments>)>| done.iter().find(|(at, _)| *at == x).map(|(_, each)| each[sensor]);
        if let Some(moments) = known(&self.done.borrow()) {
            return Ok(moments);
        }
        let each = self.run.moments(&changed(&asked.spec.spring.spring, self.along.map(|part| part * x))?)?;
        let moments = each[sensor];
        self.done.borrow_mut().push((x, each));
        Ok(moments)
    }
}

impl Responses {
    /// Of sensors in a case, as far as `specimens` reach.
    pub fn of(asked: &Asked<'_>, specimens: &Specimens) -> Result<Self, Error> {
        let spec = asked.spec;
        let mount = &spec.mount.cases[asked.damping].mount;
        let condition = &spec.conditions[asked.condition];
        let run = TrialRun::new(asked)?;
        let mut axes = Vec::new();
        for (number, (along, coordinate)) in directions(&spec.spring.spring, mount.far_end()).into_iter().enumerate() {
            let of = |specimen: &Specimen| dot(coordinate, specimen.change);
            let ends =
                specimens.each.iter().map(of).fold((0.0_f64, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
            let places = places(spec, condition, mount, number, ends)?;
            let runs = Runs { run: &run, along, done: RefCell::default() };
            let curve = |sensor: usize| {
                let (beside, goal) = (asked.beside[sensor], asked.goal);
                let samples = Refinement { places: &places, ends, beside, goal }.run(|x| runs.moments(x, sensor))?;
                Ok(Curve::new(samples))
            };
            let curves = (0..asked.sensors.len()).map(curve).collect::<Result<_, Error>>()?;
            axes.push(Axis { along, coordinate, curves });
        }
        let held = |end| matches!(condition.excitation.input(end), EndInput::Held);
        let in_proportion = match mount.far_end() {
            FarEnd::Position => true,
            FarEnd::Force => held(End::Two),
            FarEnd::Mass(_) => false,
        };
        Ok(Self { axes, in_proportion })
    }

    /// What a sensor's error is on a specimen; `nominal` is it on the spec's own spring, as well as it is known.
    pub fn on(&self, sensor: usize, specimen: &Specimen, nominal: Moments) -> Moments {
        let mut moments = nominal;
        for axis in &self.axes {
            let curve = &axis.curves[sensor];
            let at = curve.at(dot(axis.coordinate, specimen.change));
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

    /// How far from the spec's own spring a sensor's error is largest: the factor of the surge frequencies there.
    pub fn loudest(&self, sensor: usize) -> f64 {
        let each = self.axes.iter().map(|axis| (axis.along[1] * axis.curves[sensor].loudest()).exp());
        each.fold(1.0, |far, factor| if (factor - 1.0_f64).abs() > (far - 1.0_f64).abs() { factor } else { far })
    }
}

fn dot(a: Change, b: Change) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The spring with another stiffness and other surge frequencies; its mass follows.
fn changed(spring: &Spring, [stiffness, frequencies]: Change) -> Result<Spring, Error> {
    let parameters = spring.parameters();
    let stiffer = stiffness.exp();
    Spring::new(SpringParameters {
        stiffness: stiffer * parameters.stiffness,
        mass: stiffer * parameters.mass * (-2.0 * frequencies).exp(),
        nominal_force: Some(spring.nominal_force()),
        ..parameters.clone()
    })?
    .with_masses_per_winding(spring.masses_per_winding())
}

/// Ways in which a mounted spring's frequencies move, each with its coordinate.
///
/// With a prescribed position or force at end 2 all move together, ∝ √(k/m). With an end mass the first, the swing of the mass, moves by
/// itself: the axes are then one along which only it moves, and one along which it alone stays.
fn directions(spring: &Spring, far_end: FarEnd) -> Vec<(Change, Change)> {
    let FarEnd::Mass(_) = far_end else { return vec![([0.0, 1.0], [0.0, 1.0])] };
    const STEP: f64 = 1e-3;
    let first_two = |change: Change| -> Option<[f64; 2]> {
        let modes = ChainModes::mounted(&changed(spring, change).ok()?, far_end);
        let [first, second, ..] = *modes.frequencies() else { return None };
        Some([first.ln(), second.ln()])
    };
    let slope = |change: Change| -> Option<[f64; 2]> {
        let (up, down) = (first_two(change)?, first_two(change.map(|part| -part))?);
        Some([0, 1].map(|mode| (up[mode] - down[mode]) / (2.0 * STEP)))
    };
    let (Some(by_stiffness), Some(by_frequency)) = (slope([STEP, 0.0]), slope([0.0, STEP])) else {
        return vec![([0.0, 1.0], [0.0, 1.0])];
    };
    let rows = [[by_stiffness[0], by_frequency[0]], [by_stiffness[1], by_frequency[1]]];
    let determinant = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
    let inverse = [[rows[1][1], -rows[0][1]], [-rows[1][0], rows[0][0]]].map(|row| row.map(|part| part / determinant));
    vec![([inverse[0][0], inverse[1][0]], rows[0]), ([inverse[0][1], inverse[1][1]], rows[1])]
}

/// Where to look first: both ends, the spec's own spring, and close together where a line of the input meets a mode.
fn places(
    spec: &Spec,
    condition: &crate::spec::ConditionSpec,
    mount: &Mount,
    axis: usize,
    (low, high): (f64, f64),
) -> Result<Vec<f64>, Error> {
    let mut places = vec![low, 0.0, high];
    let modes = ChainModes::mounted(&spec.spring.spring, mount.far_end());
    let ratios = mount.damping().ratios(modes.frequencies())?;
    let swings_alone = matches!(mount.far_end(), FarEnd::Mass(_));
    let of_axis = |mode: usize| !swings_alone || (axis == 0) == (mode == 0);
    let mut lines = Vec::new();
    for end in [End::One, End::Two] {
        match condition.excitation.input(end) {
            EndInput::Harmonics(sines) => lines.extend(sines.iter().map(|sine| std::f64::consts::TAU * sine.frequency)),
            EndInput::Held => {}
            // Whatever line there is, it is no narrower than damping and duration make it.
            _ => {
                let width = width(ratios[0], modes.frequencies()[0], condition.duration);
                let count = ((high - low) / (2.0 * width)).ceil().clamp(2.0, MOST_EVEN);
                places.extend((0..=count as usize).map(|index| low + (high - low) * index as f64 / count));
            }
        }
    }
    let each = modes.frequencies().iter().zip(&ratios).enumerate().filter(|(mode, _)| of_axis(*mode));
    for (_, (frequency, ratio)) in each {
        let width = width(*ratio, *frequency, condition.duration);
        for line in &lines {
            let meets = (line / frequency).ln();
            if (low - 3.0 * width..=high + 3.0 * width).contains(&meets) {
                places.extend(AROUND.iter().flat_map(|far| [meets + far * width, meets - far * width]));
            }
        }
    }
    places.retain(|place| (low..=high).contains(place));
    Ok(places)
}

/// Distances from a resonance at which to look first, in its half widths.
const AROUND: [f64; 6] = [0.0, 0.6, 1.4, 3.0, 6.0, 12.0];
/// Most places spread evenly.
const MOST_EVEN: f64 = 16.0;

/// Half width of a resonance, as a share of its frequency: by damping, or by the time it has.
fn width(ratio: f64, angular: f64, duration: f64) -> f64 {
    ratio.max(2.0 / (angular * duration)).max(1e-6)
}

/// Forces that are looked at: which the goal calls true.
pub(super) fn needs_coil(spec: &Spec, sensors: &[&SensorSpec]) -> bool {
    let by_coil = |sensor: &&SensorSpec| matches!(sensor.quantity, crate::spec::Quantity::Inductance { .. });
    spec.goal.force == Channel::InductanceForce || sensors.iter().any(by_coil)
}
