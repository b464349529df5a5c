//! The curve over frequency: sampled more finely where it bends; where it peaks, and up to where one end may be taken for the other.
//!
//! Next door: the forces at one frequency (the parent).

use coilsense::excitation::{Content, Excitation};
use coilsense::{End, Error};
use serde_json::{Value, json};

use super::{Driven, Forces, WITHIN};
use crate::answer::Answer;

/// Steps of the coarse curve, each the same factor.
const STEPS: usize = 300;
/// How often a step is halved at most, and from which bend of a logarithm on.
const HALVINGS: usize = 14;
const BEND: f64 = 0.01;
/// Logarithms are no larger: undamped, a force has no limit.
const LARGEST: f64 = 40.0;
/// Halvings that find a place to the last digit.
const EXACT: usize = 60;
/// Most peaks that are told.
const MOST_PEAKS: usize = 12;

/// The forces at a frequency.
#[derive(Clone, Copy)]
struct Sample {
    frequency: f64,
    forces: Forces,
}

impl Sample {
    fn of(driven: &Driven, frequency: f64) -> Result<Self, Error> {
        Ok(Self { frequency, forces: driven.at(frequency)? })
    }

    /// Logarithms of all three.
    fn logarithms(&self) -> [f64; 3] {
        let Forces { own, other, by_length } = self.forces;
        [own, other, by_length].map(|force| force.norm().ln().clamp(-LARGEST, LARGEST))
    }

    /// How much is off where the other end's force, or k times the deflection, is taken for the driven end's \[1\].
    fn off(&self, of_length: bool) -> f64 {
        let ratio = if of_length { self.forces.length_over_own() } else { self.forces.through() };
        (ratio - 1.0).norm()
    }

    fn through(&self) -> f64 {
        self.forces.through().norm()
    }
}

/// See [`super::curve()`].
pub(super) fn answer(driven: &Driven, excitation: Excitation) -> Result<Answer, Error> {
    let samples = samples(driven)?;
    let mut meta = driven.facts();
    meta["until"] = json!({
        "through": until(driven, &samples, false)?,
        "length": until(driven, &samples, true)?,
    });
    meta["peaks"] = peaks(driven, &samples)?;
    meta["modes"] = modes(driven);
    meta["lines"] = lines(&excitation);
    let series = |name: &str, of: &dyn Fn(&Sample) -> f64| (name.to_owned(), samples.iter().map(of).collect());
    Ok(Answer::new(
        &meta,
        vec![
            series("frequency", &|sample| sample.frequency),
            series("through", &Sample::through),
            series("length", &|sample| sample.forces.length_over_own().norm()),
            series("own", &|sample| sample.forces.own.norm()),
            series("other", &|sample| sample.forces.other.norm()),
            series("by length", &|sample| sample.forces.by_length.norm()),
        ],
    ))
}

fn samples(driven: &Driven) -> Result<Vec<Sample>, Error> {
    let (from, to) = driven.range;
    let coarse = (0..=STEPS).map(|step| Sample::of(driven, from * (to / from).powf(step as f64 / STEPS as f64)));
    let coarse = coarse.collect::<Result<Vec<_>, Error>>()?;
    let mut samples = vec![coarse[0]];
    for pair in coarse.windows(2) {
        between(driven, [pair[0], pair[1]], HALVINGS, &mut samples)?;
        samples.push(pair[1]);
    }
    Ok(samples)
}

/// Adds what is needed between two samples, in order.
fn between(driven: &Driven, [low, high]: [Sample; 2], halvings: usize, to: &mut Vec<Sample>) -> Result<(), Error> {
    let middle = Sample::of(driven, (low.frequency * high.frequency).sqrt())?;
    let (a, b, c) = (low.logarithms(), middle.logarithms(), high.logarithms());
    let bends = (0..3).any(|force| (b[force] - 0.5 * (a[force] + c[force])).abs() > BEND);
    if halvings == 0 || !bends {
        return Ok(());
    }
    between(driven, [low, middle], halvings - 1, to)?;
    to.push(middle);
    between(driven, [middle, high], halvings - 1, to)
}

/// Up to where one force may be taken for the driven end's \[Hz\]; none where that is nowhere so.
fn until(driven: &Driven, samples: &[Sample], of_length: bool) -> Result<Option<f64>, Error> {
    let is_off = |sample: &Sample| sample.off(of_length) > WITHIN;
    match samples.iter().position(is_off) {
        Some(0) => Ok(None),
        None => Ok(samples.last().map(|sample| sample.frequency)),
        Some(first) => {
            let (mut low, mut high) = (samples[first - 1].frequency, samples[first].frequency);
            for _ in 0..EXACT {
                let middle = 0.5 * (low + high);
                if is_off(&Sample::of(driven, middle)?) { high = middle } else { low = middle }
            }
            Ok(Some(low))
        }
    }
}

/// Where the other end has most of the driven end's force: frequency \[Hz\] and how much; nothing where it has no limit.
fn peaks(driven: &Driven, samples: &[Sample]) -> Result<Value, Error> {
    let mut peaks = Vec::new();
    for three in samples.windows(3) {
        let [before, top, after] = [0, 1, 2].map(|at| three[at].through());
        if top <= 1.0 || top < before || top <= after || peaks.len() == MOST_PEAKS {
            continue;
        }
        let (mut low, mut high) = (three[0].frequency, three[2].frequency);
        for _ in 0..EXACT {
            let [near, far] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            let [a, b] = [Sample::of(driven, near)?.through(), Sample::of(driven, far)?.through()];
            if a < b { low = near } else { high = far }
        }
        let found = Sample::of(driven, 0.5 * (low + high))?;
        let limit = driven.plant.ratios().any(|ratio| ratio > 0.0).then(|| found.through());
        peaks.push(json!([found.frequency, limit]));
    }
    Ok(Value::Array(peaks))
}

/// Modes of the mounted spring within the curve \[Hz\].
fn modes(driven: &Driven) -> Value {
    let hertz = driven.plant.modes().iter().map(|mode| mode.frequency / std::f64::consts::TAU);
    hertz.filter(|hertz| *hertz <= driven.range.1).take(MOST_PEAKS).collect()
}

/// Sines that the condition drives the ends with \[Hz\].
fn lines(excitation: &Excitation) -> Value {
    let of = |end| match excitation.input(end).content() {
        Content::Lines(sines) => sines.iter().filter(|sine| sine.amplitude != 0.0).map(|sine| sine.frequency).collect(),
        Content::Nothing | Content::Broad => Vec::new(),
    };
    [End::One, End::Two].into_iter().flat_map(of).collect()
}
