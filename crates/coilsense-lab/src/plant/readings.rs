//! What a spec's sensors make of a plant, step by step.
//!
//! Next door: the plant (the parent), an instrument in steps (`coilsense::sensors::ReadoutSteps`), a step of it (`coilsense_rt::Readout`).

use std::fmt::Write as _;

use coilsense::excitation::End;
use coilsense::sensors::{Quantity, Readout, ReadoutSteps};
use coilsense_rt::ReadoutPole;
use minijinja::{Value, context};

use super::{PlantError, digits};
use crate::mitigation::export::Precision;
use crate::spec::SensorSpec;

/// What a sensor looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Seen {
    /// F_i.
    Input,
    /// F_o.
    Output,
    /// The distance between the ends.
    Distance,
    /// L.
    Inductance,
}

impl Seen {
    /// Of a sensor; none of one that looks at what a plant has not.
    pub fn of(sensor: &SensorSpec) -> Option<Self> {
        match sensor.quantity {
            Quantity::Force(End::One) => Some(Self::Input),
            Quantity::Force(End::Two) => Some(Self::Output),
            Quantity::Deflection => Some(Self::Distance),
            Quantity::Inductance { .. } => Some(Self::Inductance),
            Quantity::TwoEncoder { .. } => None,
        }
    }

    fn in_words(self) -> &'static str {
        match self {
            Self::Input => "F_i [N]",
            Self::Output => "F_o [N]",
            Self::Distance => "the distance between the ends [m]",
            Self::Inductance => "L [H]",
        }
    }

    /// What it looks at, and the force that a reading means, in C.
    fn in_c(self, name: &str, index: usize) -> [String; 2] {
        let upper = name.to_ascii_uppercase();
        let of_length = |length: String| {
            format!("plant->preload + plant->stiffness * ({length} - ({name}_real){upper}_MEAN_LENGTH)")
        };
        let read = format!("read[{index}]");
        match self {
            Self::Input => ["out.input".to_owned(), read],
            Self::Output => ["out.output".to_owned(), read],
            Self::Distance => {
                [format!("({name}_real){upper}_MEAN_LENGTH + {name}_longer(plant, state)"), of_length(read)]
            }
            Self::Inductance => {
                let slope = format!("({name}_real){upper}_ALPHA * {read} + ({name}_real){upper}_BETA");
                let length = format!("({name}_real)1.0 / ({slope})");
                [format!("{name}_coil(plant, state).inductance"), of_length(length)]
            }
        }
    }
}

/// A sensor in steps of one length.
pub(super) struct Sensor {
    name: String,
    title: String,
    seen: Seen,
    steps: ReadoutSteps,
}

/// All that are read, in steps of a length \[s\].
///
/// # Errors
/// [`PlantError::Spec`] for a step of which an instrument looks back over too many.
pub(super) fn of(file: &str, sensors: &[SensorSpec], step: f64) -> Result<Vec<Sensor>, PlantError> {
    let mut made: Vec<Sensor> = Vec::new();
    for sensor in sensors {
        let Some(seen) = Seen::of(sensor) else { continue };
        let steps = Readout::new(sensor.readout.clone()).and_then(|readout| readout.steps(step, made.len() as u64));
        let steps = steps.map_err(|refused| PlantError::Spec(format!("{file}: {}: {refused}", sensor.name)))?;
        let mut name = identifier(&sensor.name);
        if made.iter().any(|other| other.name == name) {
            let _ = write!(name, "_{}", made.len() + 1);
        }
        // A comment of C ends where a name says so.
        let title = format!("{}: reads {}", sensor.name.replace("*/", "* /"), seen.in_words());
        made.push(Sensor { name, title, seen, steps });
    }
    Ok(made)
}

/// Words that C or Rust keeps for itself and that might be the name of a sensor.
const KEPT: [&str; 22] = [
    "auto", "break", "case", "const", "double", "extern", "float", "for", "if", "in", "int", "long", "loop", "match",
    "move", "ref", "self", "short", "static", "switch", "type", "union",
];

/// A sensor's name as C and Rust can have it.
fn identifier(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { ' ' };
    let words = name.chars().map(plain).collect::<String>();
    let joined = words.split_whitespace().collect::<Vec<_>>().join("_");
    let begins = joined.starts_with(|first: char| first.is_ascii_lowercase());
    if begins && !KEPT.contains(&joined.as_str()) { joined } else { format!("sensor_{joined}") }
}

/// As the header's template has them.
pub(super) fn in_c(name: &str, sensors: &[Sensor], precision: Precision) -> Value {
    let each = sensors.iter().enumerate().map(|(index, sensor)| {
        let [seen, force] = sensor.seen.in_c(name, index);
        context! {
            name => sensor.name.as_str(),
            title => sensor.title.as_str(),
            initializer => initializer(&sensor.steps, precision),
            seen => seen,
            force => force,
        }
    });
    let most = |count: &dyn Fn(&ReadoutSteps) -> usize| sensors.iter().map(|sensor| count(&sensor.steps)).max();
    context! {
        step => digits(sensors.first().map_or(0.0, |sensor| sensor.steps.step())),
        poles => most(&|steps| steps.poles().len()).unwrap_or(0).max(1),
        slots => most(&ReadoutSteps::slots).unwrap_or(2),
        each => each.collect::<Vec<_>>(),
    }
}

/// An instrument as C has it.
fn initializer(steps: &ReadoutSteps, precision: Precision) -> String {
    let one = |value: f64| precision.literal(value);
    let pairs = |part: &dyn Fn(&ReadoutPole<f64>) -> [f64; 2]| {
        let each = steps.poles().iter().map(|pole| part(pole).map(one).join(", "));
        let each: Vec<String> = each.map(|pair| format!("{{ {pair} }}")).collect();
        if each.is_empty() { format!("{{ {{ {0}, {0} }} }}", one(0.0)) } else { format!("{{ {} }}", each.join(", ")) }
    };
    let (delay, mean) = (steps.delay(), steps.mean());
    format!(
        "{}, {}, {}, {}, {}, {}, {}, {}, {{ {} }}, {:?}, {}, {}",
        steps.poles().len(),
        pairs(&|pole| pole.decay),
        pairs(&|pole| pole.drag),
        pairs(&|pole| pole.share),
        delay.whole,
        one(delay.fraction),
        i32::from(mean.is_some()),
        mean.map_or(0, |mean| mean.whole),
        mean.map_or([0.0; 3], |mean| mean.weights).map(one).join(", "),
        steps.samples().unwrap_or(0.0),
        one(steps.noise()),
        one(steps.resolution().unwrap_or(0.0)),
    )
}

/// A Rust constant for each.
pub(super) fn in_rust(upper: &str, sensors: &[Sensor], precision: Precision) -> String {
    let one = |value: f64| match precision {
        Precision::Single => format!("{:?}", value as f32),
        Precision::Double => format!("{value:?}"),
    };
    let pair = |values: [f64; 2]| format!("[{}, {}]", one(values[0]), one(values[1]));
    let mut text = String::new();
    for Sensor { name, title, steps, .. } in sensors {
        let name = format!("{upper}_{}", name.to_ascii_uppercase());
        let poles = steps.poles().iter().map(|ReadoutPole { decay, drag, share }| {
            let [decay, drag, share] = [*decay, *drag, *share].map(pair);
            format!("        coilsense_rt::ReadoutPole {{ decay: {decay}, drag: {drag}, share: {share} }},\n")
        });
        let mean = steps.mean().map_or("None".to_owned(), |mean| {
            let [far, farther, step] = mean.weights.map(one);
            let weights = format!("[{far}, {farther}, {step}]");
            format!("Some(coilsense_rt::ReadoutMean {{ whole: {}, weights: {weights} }})", mean.whole)
        });
        let _ = write!(
            text,
            "\n/// {title}, in steps of {:?} s. `{name}.settled::<{name}_SLOTS>(…)` is its state.\n\
             pub const {name}: coilsense_rt::Readout<{}, {}> = coilsense_rt::Readout {{\n    poles: [\n{}    ],\n    \
             delay: coilsense_rt::Delay {{ whole: {}, fraction: {} }},\n    mean: {mean},\n    samples: {:?},\n    noise: {},\n    \
             resolution: {},\n    seed: {},\n}};\n/// How many past samples a state of it holds.\npub const {name}_SLOTS: usize = {};\n",
            steps.step(),
            precision.rust(),
            steps.poles().len(),
            poles.collect::<String>(),
            steps.delay().whole,
            one(steps.delay().fraction),
            steps.samples(),
            one(steps.noise()),
            steps.resolution().map_or("None".to_owned(), |step| format!("Some({})", one(step))),
            steps.seed(),
            steps.slots(),
        );
    }
    text
}
