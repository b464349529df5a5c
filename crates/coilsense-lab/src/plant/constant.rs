//! A plant as a Rust constant for `coilsense-rt`.
//!
//! Next door: the same in C (`header`).

use std::fmt::Write as _;

use super::{Plant, PlantError, header};
use crate::mitigation::export::check_name;

/// `<name>.rs`.
pub(super) fn text(made: &Plant, name: &str) -> Result<String, PlantError> {
    check_name(name)?;
    let (plant, upper) = (&made.plant, name.to_ascii_uppercase());
    let numbers = header::Numbers::of(plant);
    let mut text = format!("// {}\n", header::title(made, name));
    let _ = write!(
        text,
        "\nuse coilsense_rt::{{FarEnd, PlantMode, PlantSettings}};\n\n\
         /// How many modes there are.\npub const {upper}_MODES: usize = {};\n\n\
         /// Inputs: u1, and {}. `{upper}.plant::<f32>(step)` is ready to be stepped.\n\
         pub const {upper}: PlantSettings<{upper}_MODES> = PlantSettings {{\n",
        plant.count(),
        header::second_input(plant)
    );
    let _ = write!(
        text,
        "    stiffness: {:?},\n    mass: {:?},\n    damping_ratio: {:?},\n    damped_frequency: {:?},\n    dashpots: {},\n    \
         stretch: {:?},\n    far_end: FarEnd::{:?},\n    modes: [\n",
        numbers.stiffness,
        numbers.mass,
        numbers.damping_ratio,
        numbers.damped_frequency,
        numbers.dashpots,
        numbers.stretch,
        plant.far_end()
    );
    for mode in plant.modes() {
        let _ = writeln!(
            text,
            "        PlantMode {{\n            frequency: {:?},\n            damping: {:?},\n            participations: {:?},\n            \
             weights: {:?},\n            end: {:?},\n        }},",
            mode.frequency, mode.damping, mode.participations, mode.weights, mode.end
        );
    }
    text.push_str("    ],\n};\n");
    Ok(text)
}
