//! A plant as a header of C99.
//!
//! Next door: the header's text (`plant.h` and what it includes), of which every line computes what `coilsense-rt` computes.

use coilsense::plant::ModalPlant;
use coilsense_rt::FarEnd;
use minijinja::{AutoEscape, Environment, context};

use super::readings::{Sensor, in_c};
use super::windings::{of_coil, of_windings};
use super::{Plant, PlantError, digits};
use crate::mitigation::export::{ExportError, Precision, check_name};

/// What a plant has beside its modes.
pub(super) struct Numbers {
    pub stiffness: f64,
    pub mass: f64,
    pub damping_ratio: f64,
    pub damped_frequency: f64,
    pub dashpots: bool,
    pub stretch: f64,
}

impl Numbers {
    pub fn of(plant: &ModalPlant) -> Self {
        let (damping_ratio, damped_frequency) = plant.damped();
        Self {
            stiffness: plant.spring().stiffness(),
            mass: plant.spring().mass(),
            damping_ratio,
            damped_frequency,
            dashpots: plant.dashpot_time() > 0.0,
            stretch: plant.stretch(),
        }
    }
}

/// What a file begins with.
pub(super) fn title(made: &Plant, name: &str) -> String {
    let version = env!("CARGO_PKG_VERSION");
    // A comment of C ends where a name says so.
    let spring = made.spring.replace("*/", "* /");
    format!(
        "{name}: the spring {spring:?}, {}, {} modes. Made by coilsense {version}.",
        made.damping,
        made.plant.count()
    )
}

/// Input 2 in words.
pub(super) fn second_input(plant: &ModalPlant) -> &'static str {
    match plant.far_end() {
        FarEnd::Position => "u2 [m]",
        FarEnd::Force => "the force at end 2 [N]",
        FarEnd::Mass => "the force on the mass at end 2 [N]",
    }
}

/// The header's text, and what it includes.
const PARTS: [(&str, &str); 4] = [
    ("plant", include_str!("plant.h")),
    ("windings_tables", include_str!("windings_tables.h")),
    ("windings", include_str!("windings.h")),
    ("readout", include_str!("readout.h")),
];

/// `<name>.h`.
pub(super) fn text(made: &Plant, name: &str, precision: Precision, sensors: &[Sensor]) -> Result<String, PlantError> {
    check_name(name)?;
    let plant = &made.plant;
    let numbers = Numbers::of(plant);
    let modes: Vec<Vec<String>> = plant
        .modes()
        .iter()
        .map(|mode| {
            let [first, second] = mode.participations;
            let [input, output] = mode.weights;
            [mode.frequency, mode.damping, first, second, input, output, mode.end].map(digits).to_vec()
        })
        .collect();
    let render = || -> Result<String, minijinja::Error> {
        let mut environment = Environment::new();
        environment.set_auto_escape_callback(|_| AutoEscape::None);
        for (part, text) in PARTS {
            environment.add_template(part, text)?;
        }
        environment.get_template("plant")?.render(context! {
            title => title(made, name),
            name => name,
            upper => name.to_ascii_uppercase(),
            real => precision.c(),
            zero => precision.literal(0.0),
            largest => if precision == Precision::Single { "FLT_MAX" } else { "DBL_MAX" },
            rounding => if precision == Precision::Single { "(double)FLT_EPSILON" } else { "DBL_EPSILON" },
            is_single => precision == Precision::Single,
            mends => if precision == Precision::Single { <f32 as coilsense_rt::Real>::STEPS_TO_MEND } else { 0 },
            second => second_input(plant),
            is_position => plant.far_end() == FarEnd::Position,
            has_mass => plant.far_end() == FarEnd::Mass,
            dashpots => numbers.dashpots,
            stiffness => digits(numbers.stiffness),
            mass => digits(numbers.mass),
            damping_ratio => digits(numbers.damping_ratio),
            damped_frequency => digits(numbers.damped_frequency),
            stretch => digits(numbers.stretch),
            half_whole => if precision == Precision::Single { "4194304.0" } else { "2251799813685248.0" },
            rounds => if precision == Precision::Single { "12582912.0" } else { "6755399441055744.0" },
            modes => modes,
            mean_length => digits(plant.mean_length()),
            sensors => (!sensors.is_empty()).then(|| in_c(name, sensors, precision)),
            coil => made.coil.as_ref().map(|coil| of_coil(coil, precision)),
            windings => made.windings.as_ref().map(|windings| of_windings(windings, precision)),
        })
    };
    Ok(render().map_err(ExportError::from)? + "\n")
}
