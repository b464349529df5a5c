//! A plant as a Rust constant for `coilsense-rt`.
//!
//! Next door: the same in C (`header`).

use std::fmt::Write as _;

use coilsense::plant::ModalCoil;

use super::readings::{Sensor, in_rust};
use super::{Plant, PlantError, header};
use crate::mitigation::export::{Precision, check_name};

/// `<name>.rs`.
pub(super) fn text(made: &Plant, name: &str, precision: Precision, sensors: &[Sensor]) -> Result<String, PlantError> {
    let real = precision.rust();
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
    if let Some(windings) = &made.windings {
        let gaps = windings.gaps();
        let _ = write!(
            text,
            "\n/// Distances between windings: `{upper}_WINDINGS.closest_pitch(&plant, &state)`.\n\
             pub const {upper}_WINDINGS: coilsense_rt::PlantWindings<{real}, {upper}_MODES, {}> = coilsense_rt::PlantWindings {{\n    \
             mean_length: {:?},\n    share: {:?},\n    contact_pitch: {:?},\n    gaps: {},\n}};\n",
            gaps.len(),
            windings.mean_length(),
            windings.share(),
            windings.contact_pitch(),
            table(gaps, precision)
        );
    }
    if let Some(coil) = &made.coil {
        let _ = write!(text, "{}", of_coil(&upper, coil, precision));
    }
    text += &in_rust(&upper, sensors, precision);
    Ok(text)
}

/// L and F_L.
fn of_coil(upper: &str, coil: &ModalCoil, precision: Precision) -> String {
    let real = precision.rust();
    let [slopes, curvatures, remainders] = coil.by_lag().map(|rows| table(rows, precision));
    let calibration = [coil.calibration().alpha(), coil.calibration().beta()];
    format!(
        "\n/// L and F_L, of wire that is not magnetic: `{upper}_COIL.reading(&plant, &state)`.\n\
         pub const {upper}_COIL: coilsense_rt::PlantCoil<{real}, {upper}_MODES, {}, {}> = coilsense_rt::PlantCoil {{\n    \
         mean_length: {:?},\n    windings: {:?},\n    pitches: {:?},\n    calibration: {calibration:?},\n    left: {:?},\n    \
         inductance: {},\n    slopes: {slopes},\n    curvatures: {curvatures},\n    remainders: {remainders},\n    gaps: {},\n}};\n",
        coil.gaps().len(),
        coil.inductance().len(),
        coil.mean_length(),
        coil.windings(),
        coil.pitches(),
        coil.left(),
        row(coil.inductance(), precision),
        table(coil.gaps(), precision)
    )
}

/// Numbers as Rust reads them to the bit.
fn row(values: &[f64], precision: Precision) -> String {
    match precision {
        Precision::Single => format!("{:?}", values.iter().map(|value| *value as f32).collect::<Vec<f32>>()),
        Precision::Double => format!("{values:?}"),
    }
}

/// Rows of them, a line each.
fn table(rows: &[Vec<f64>], precision: Precision) -> String {
    let lines = rows.iter().map(|values| format!("        {},\n", row(values, precision)));
    format!("[\n{}    ]", lines.collect::<String>())
}
