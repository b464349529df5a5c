//! A plant as a header of C99.
//!
//! Next door: the header's text (`plant.h`), of which every line computes what `coilsense-rt` computes.

use coilsense::plant::ModalPlant;
use coilsense_rt::FarEnd;
use minijinja::{AutoEscape, Environment, context};

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

/// `<name>.h`.
pub(super) fn text(made: &Plant, name: &str, precision: Precision) -> Result<String, PlantError> {
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
        environment.add_template("plant", include_str!("plant.h"))?;
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
            modes => modes,
            coil => made.coil.as_ref().map(|coil| of_coil(coil, precision)),
            windings => made.windings.as_ref().map(|windings| of_windings(windings, precision)),
        })
    };
    Ok(render().map_err(ExportError::from)? + "\n")
}
