//! The two ends over frequency: what becomes of the force at the driven end at the other one, on a case's mount and under its damping.
//!
//! Next door: the response itself (`coilsense::plant`), where its curve is sampled and what stands out of it (`curve`), the case over time (`exact`).

mod curve;

use std::f64::consts::TAU;

use coilsense::excitation::Content;
use coilsense::modes::ModalModel;
use coilsense::plant::{ModalPlant, Order};
use coilsense::{End, Error, FarEnd};
use coilsense_lab::spec::Spec;
use coilsense_lab::study;
use num_complex::Complex64;
use serde_json::{Value, json};

use crate::answer::Answer;

/// How much F_o may depart from the force at the driven end to be taken for it \[1\].
const WITHIN: f64 = 0.01;
/// Most places along the coil that are asked for.
const MOST_PLACES: usize = 2000;
/// From where to where the curve reaches, in surge frequencies; and from where in first modes.
const FROM: f64 = 0.02;
const TO: f64 = 4.2;
const FROM_FIRST: f64 = 0.25;
/// Of the highest mode of a chain.
const HIGHEST: f64 = 0.98;

/// Which case is asked for.
#[derive(Debug, Clone, Copy)]
pub struct Asked {
    /// Numbers of the condition and the damping in the spec.
    pub condition: usize,
    /// See `condition`.
    pub damping: usize,
    /// Masses of the chain for each winding, those of the exact case.
    pub masses: usize,
}

/// A spring driven at one end, by its position or, where that is what is prescribed, by its force.
struct Driven {
    plant: ModalPlant,
    end: End,
    /// What the forces are counted in: k where the end is moved, 1 where it is pulled.
    scale: f64,
    /// Highest frequency of the curve \[Hz\], and its lowest.
    range: (f64, f64),
    tied: FarEnd,
}

/// The forces at one frequency over k times the motion of the driven end, or over the force there.
#[derive(Clone, Copy)]
struct Forces {
    own: Complex64,
    other: Complex64,
    by_length: Complex64,
}

impl Forces {
    fn through(&self) -> Complex64 {
        self.other / self.own
    }

    fn length_over_own(&self) -> Complex64 {
        self.by_length / self.own
    }
}

impl Driven {
    fn of(spec: &Spec, asked: Asked) -> Result<Self, String> {
        let (Some(condition), Some(case)) = (spec.conditions.get(asked.condition), spec.mount.cases.get(asked.damping))
        else {
            return Err(format!("there is no case of condition {} and damping {}", asked.condition, asked.damping));
        };
        let science = |error: Error| error.to_string();
        let spring = spec.spring.spring.clone().with_masses_per_winding(asked.masses).map_err(science)?;
        let mount = study::mounted(&case.mount, &spring).map_err(science)?;
        let tied = mount.far_end();
        let rests = |end| condition.excitation.input(end).content() == Content::Nothing;
        let end = match tied {
            FarEnd::Force => End::Two,
            _ if rests(End::One) && !rests(End::Two) => End::Two,
            _ => End::One,
        };
        let length = condition.excitation.mean_length();
        let plant = ModalPlant::new(&spring, &mount, length, Order::All).map_err(science)?;
        let modes = ModalModel::chain(&spring, tied);
        let hertz = |mode: Option<&f64>| mode.copied().unwrap_or(f64::INFINITY) / TAU;
        let surge = spring.surge_frequency();
        let range = (
            (FROM * surge).min(FROM_FIRST * hertz(modes.frequencies().first())),
            (TO * surge).min(HIGHEST * hertz(modes.frequencies().last())),
        );
        let is_moved = end == End::One || tied == FarEnd::Position;
        Ok(Self { scale: if is_moved { spring.stiffness() } else { 1.0 }, plant, end, range, tied })
    }

    /// The number of the driven end's input, and of its force.
    fn own(&self) -> usize {
        usize::from(self.end == End::Two)
    }

    fn at(&self, frequency: f64) -> Result<Forces, Error> {
        let (own, response) = (self.own(), self.plant.response(frequency)?);
        let force = |output: usize| response[output][own] / self.scale;
        // A mass that is pulled is not the spring: what the spring feels there is its own force.
        Ok(Forces { own: force(own), other: force(1 - own), by_length: force(2) })
    }

    /// How far nodes move, over the motion of the driven end or, where that is pulled, over its force: end 1 is node 0, masses follow, then end 2.
    fn moved(&self, frequency: f64, nodes: &[usize]) -> Vec<Complex64> {
        let model = ModalModel::chain(self.plant.spring(), self.tied);
        let (own, drive) = (self.own(), TAU * frequency);
        let swing = |natural: f64, ratio: f64| {
            let detuning = Complex64::new((natural - drive) * (natural + drive), 2.0 * ratio * natural * drive);
            drive * drive / detuning
        };
        let each = self.plant.modes().iter().zip(self.plant.ratios());
        let swings: Vec<Complex64> =
            each.map(|(mode, ratio)| mode.participations[own] * swing(mode.frequency, ratio)).collect();
        // Where the ends of a spring without mass would be.
        let line = match (self.tied, self.end) {
            (FarEnd::Position, End::One) => [1.0, 0.0],
            (FarEnd::Position, End::Two) => [0.0, 1.0],
            (_, End::One) => [1.0, 1.0],
            (_, End::Two) => [0.0, 1.0 / self.plant.spring().stiffness()],
        };
        let shape = |mode: usize, node: usize| match node {
            0 => 0.0,
            node if node > model.masses() => self.plant.modes()[mode].end,
            mass => model.shape(mode + 1, mass).unwrap_or_default(),
        };
        let moved = |node: &usize| {
            let place = place(*node, model.masses());
            let off = swings.iter().enumerate().map(|(mode, swing)| swing * shape(mode, *node));
            line[0] + place * (line[1] - line[0]) + off.sum::<Complex64>()
        };
        nodes.iter().map(moved).collect()
    }

    /// What a page says of it.
    fn facts(&self) -> Value {
        json!({
            "driven": self.own() + 1,
            "isMoved": self.end == End::One || self.tied == FarEnd::Position,
            "tied": match self.tied { FarEnd::Position => "position", FarEnd::Force => "force", FarEnd::Mass(_) => "mass" },
            "range": [self.range.0, self.range.1],
            "undamped": self.plant.ratios().all(|ratio| ratio == 0.0),
            "within": WITHIN,
        })
    }
}

/// The curve of a case, fine where it bends.
///
/// Series: `frequency` \[Hz\]; over the force at the driven end `through`, the other end's, and `length`, k times the deflection \[1\]; `own`, `other` and
/// `by length`, each over k times the motion of the driven end, or, where that is pulled, over its force \[1\].
///
/// # Errors
/// One line: what the science says of the spring on its mount, such as that a coil of sections has no such response.
pub fn curve(spec: &Spec, asked: Asked) -> Result<Answer, String> {
    let driven = Driven::of(spec, asked)?;
    curve::answer(&driven, spec.conditions[asked.condition].excitation.clone()).map_err(|error| error.to_string())
}

/// A case at one frequency \[Hz\], with `places` (2 to 2000) windings spread over the coil: where they are and how they move.
///
/// Series: `place` along the coil \[1\], `real` and `imaginary` of its motion, over that of the driven end or over its force.
///
/// # Errors
/// As [`curve()`], or what of the question is out of range.
pub fn at(spec: &Spec, asked: Asked, frequency: f64, places: usize) -> Result<Answer, String> {
    if !(2..=MOST_PLACES).contains(&places) {
        return Err(format!("places must be from 2 to {MOST_PLACES}, got {places}"));
    }
    let driven = Driven::of(spec, asked)?;
    let forces = driven.at(frequency).map_err(|error| error.to_string())?;
    let mut meta = driven.facts();
    meta["frequency"] = json!(frequency);
    for (name, value) in [
        ("own", forces.own),
        ("other", forces.other),
        ("byLength", forces.by_length),
        ("through", forces.through()),
        ("lengthOverOwn", forces.length_over_own()),
    ] {
        meta[name] = told(value);
    }
    meta["off"] = json!((forces.through() - 1.0).norm());
    let masses = driven.plant.spring().chain_masses();
    // No more masses than there are; evenly over the coil where there are more than places.
    let step = (masses as f64 / places as f64).max(1.0);
    let spread = (0..places.min(masses)).map(|number| 1 + ((number as f64 + 0.5) * step) as usize);
    let nodes: Vec<usize> = [0].into_iter().chain(spread).chain([masses + 1]).collect();
    let moved = driven.moved(frequency, &nodes);
    let part = |of: fn(&Complex64) -> f64| moved.iter().map(of).collect();
    Ok(Answer::new(
        &meta,
        vec![
            ("place".to_owned(), nodes.iter().map(|node| place(*node, masses)).collect()),
            ("real".to_owned(), part(|node| node.re)),
            ("imaginary".to_owned(), part(|node| node.im)),
        ],
    ))
}

/// Where a node is along the coil \[1\]: masses are half a step from the ends, and a step from each other.
fn place(node: usize, masses: usize) -> f64 {
    match node {
        0 => 0.0,
        node if node > masses => 1.0,
        node => (node as f64 - 0.5) / masses as f64,
    }
}

/// Size and phase \[rad\] of a number; nothing where it has no limit.
fn told(value: Complex64) -> Value {
    match value.is_finite() {
        true => json!([value.norm(), value.arg()]),
        false => Value::Null,
    }
}
