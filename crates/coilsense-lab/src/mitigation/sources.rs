//! Where the numbers of a study are from: asked for, the spec's own, or assumed since nobody says them.
//!
//! Next door: the study (`study`), how its answer tells them (`crate::report::mitigation`).

use coilsense::mitigation::ToleranceBox;
use coilsense::sensors::Quantity;
use coilsense::{End, Error};

use super::request::Request;
use crate::quantity::plainly;
use crate::spec::Spec;

/// Where a number is from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Source {
    /// It was asked for, or belongs to a stated scenario or a log.
    Asked,
    /// The spec says it, in these words: a sensor's name, a table.
    Spec(String),
    /// Nobody says it.
    Assumed,
}

impl Source {
    /// Its words; `None` of what was asked for.
    pub fn words(&self) -> Option<&str> {
        match self {
            Self::Asked => None,
            Self::Spec(words) => Some(words),
            Self::Assumed => Some("assumed"),
        }
    }

    /// What stands behind the number, in brackets; nothing of what was asked for.
    pub fn told(&self) -> String {
        self.words().map(|words| format!(" ({words})")).unwrap_or_default()
    }
}

/// Where a study's rate, noise, and tolerances of k and m are from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sources {
    /// How often the controller samples.
    pub rate: Source,
    /// White noise of F_i.
    pub noise: Source,
    /// How far k may be off.
    pub stiffness: Source,
    /// How far m may be off.
    pub mass: Source,
}

impl Sources {
    /// All that is asked for.
    pub const ASKED: Self =
        Self { rate: Source::Asked, noise: Source::Asked, stiffness: Source::Asked, mass: Source::Asked };
}

/// Sampling rate where neither an option nor `[control]` says it \[Hz\].
const RATE: f64 = 2500.0;
/// Noise of F_i over F_nom where no load cell at end 1 says it \[1\].
const NOISE: f64 = 0.002;
/// How far k and m may be off where nothing says it, as a share \[1\].
const TOLERANCE: f64 = 0.1;

/// A number, and where it is from.
type Found = (f64, Source);

fn first(asked: Option<f64>, of_spec: Option<Found>, assumed: f64) -> Found {
    let asked = asked.map(|value| (value, Source::Asked));
    asked.or(of_spec).unwrap_or((assumed, Source::Assumed))
}

/// How often the controller samples \[Hz\].
pub(super) fn rate(spec: &Spec, asked: &Request) -> Found {
    let step = spec.control.as_ref().and_then(|control| control.sample_time);
    first(asked.rate, step.map(|step| (step.recip(), Source::Spec("[control]".to_owned()))), RATE)
}

/// White noise of F_i \[N rms\]: that of the spec's quietest load cell at end 1.
pub(super) fn noise(spec: &Spec, asked: &Request) -> Found {
    let cells = spec.sensors.iter().filter(|sensor| sensor.quantity == Quantity::Force(End::One));
    let noisy = cells.filter(|sensor| sensor.readout.noise > 0.0);
    let quietest = noisy.min_by(|a, b| a.readout.noise.total_cmp(&b.readout.noise));
    let of_spec = quietest.map(|sensor| (sensor.readout.noise, Source::Spec(sensor.name.clone())));
    first(asked.noise, of_spec, NOISE * spec.spring.spring.nominal_force())
}

/// How far k and m may be off. What the model leaves open of the surge frequencies, δ, is as good as 2 δ of m.
///
/// # Errors
/// [`Error::Value`] for shares that no spring has.
pub(super) fn tolerances(spec: &Spec, asked: &Request) -> Result<(ToleranceBox, [Source; 2]), Error> {
    let own = &spec.spring.tolerances;
    let model = spec.spring.open_frequency();
    let says = || Source::Spec("from the spec".to_owned());
    let of_stiffness = (!own.is_silent_on_stiffness()).then(|| (own.of_stiffness(), says()));
    let of_mass = (own.mass.is_some() || own.geometry_is_given)
        .then(|| {
            (
                own.of_mass().hypot(2.0 * model),
                Source::Spec("from the spec, with the model's uncertainty of f1".to_owned()),
            )
        })
        .filter(|(share, _)| *share < 1.0);
    let (stiffness, stiffness_by) = first(asked.stiffness_tolerance, of_stiffness, TOLERANCE);
    let (mass, mass_by) = first(asked.mass_tolerance, of_mass.filter(|(mass, _)| stiffness + mass > 0.0), TOLERANCE);
    Ok((ToleranceBox::new(stiffness, mass)?, [stiffness_by, mass_by]))
}

/// A corner of the box in words: by how much k and m are off.
pub(super) fn corner_label(corner: [f64; 2]) -> String {
    let [stiffness, mass] = corner.map(|share| {
        let sign = if share.is_sign_negative() { '-' } else { '+' };
        format!("{sign}{}", plainly(100.0 * share.abs()))
    });
    format!("k {stiffness} %, m {mass} %")
}
