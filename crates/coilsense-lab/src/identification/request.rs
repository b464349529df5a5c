//! What may be asked of an identification beside its log: the options of `coilsense identify`, of Python's function and of the page.
//!
//! Next door: what a row says (`crate::request`), the options of the log (`crate::recording::request`).

use coilsense::identify::Settings;
use coilsense::{Channel, FarEnd, Spring};

use super::{Coil, Expected};
use crate::quantity::Dimension;
use crate::request::{self, Allowed, Door, Given, IfAbsent, KNOWN_SPRING, LENGTH, Row, Takes, Wrong};

/// The options, in the order in which they are told.
pub const OPTIONS: [Row; 13] = [
    SPEC,
    MASS,
    WINDINGS,
    RADIUS,
    WIRE,
    END2,
    END_MASS,
    TURN,
    PREDICTION_TOLERANCE,
    TOLERANCE,
    ACCURACY_FORCE,
    ACCURACY_POSITION,
    SPEC_OUT,
];

/// A share above zero.
const OPEN_SHARE: Row =
    Row { takes: Takes::Quantity(Dimension::Share), allowed: Allowed::Between(0.0, 1.0), ..Row::PLAIN };
/// A limit of error.
const ACCURACY: Row = Row {
    takes: Takes::Quantity(Dimension::Share),
    allowed: Allowed::Below(0.0, 1.0),
    if_absent: IfAbsent::Value("0 %"),
    ..Row::PLAIN
};
const A_MASS: Row = Row { takes: Takes::Quantity(Dimension::Mass), allowed: Allowed::AboveZero, ..Row::PLAIN };

/// A known spring.
pub const SPEC: Row = Row {
    meaning: "Predict f1, and take windings, radius and wire, from the [spring] of a spec",
    conflicts: &["mass", "windings", "radius", "wire"],
    ..KNOWN_SPRING
};
/// m.
pub const MASS: Row =
    Row { name: "mass", meaning: "Mass of the active coil: with the stiffness it predicts f1", ..A_MASS };
/// N.
pub const WINDINGS: Row = Row {
    meaning: "Active windings, whole or not; needed by --spec-out. Modes are then also held against those of a chain with one mass for each winding",
    ..request::WINDINGS
};
/// Of the coil.
pub const RADIUS: Row = Row {
    name: "radius",
    meaning: "Radius of the coil to the wire's centre, for --spec-out",
    elsewhere: &[(Door::Python, "Identification.to_spec")],
    ..LENGTH
};
/// Diameter.
pub const WIRE: Row = Row {
    name: "wire",
    meaning: "Diameter of the wire, for --spec-out",
    elsewhere: &[(Door::Python, "Identification.to_spec")],
    ..LENGTH
};
/// The mount of end 2.
pub const END2: Row = Row {
    name: "end2",
    takes: Takes::Word(&["held", "free", "mass"]),
    if_absent: IfAbsent::Found("the record decides, by whether u2 moves with the ringing"),
    meaning: "What end 2 is tied to",
    ..Row::PLAIN
};
/// What end 2 carries.
pub const END_MASS: Row = Row {
    name: "end_mass",
    if_absent: IfAbsent::Found("F_o over the acceleration of u2"),
    meaning: "Mass at end 2",
    ..A_MASS
};
/// A sign that is wrong in the log.
pub const TURN: Row = Row {
    name: "turn",
    takes: Takes::Word(&["F_i", "F_o", "u1", "u2"]),
    if_absent: IfAbsent::Found("no sign is turned; where one is, it is said"),
    meaning: "Channel whose sign is turned before anything else",
    ..Row::PLAIN
};
/// Of f1.
pub const PREDICTION_TOLERANCE: Row = Row {
    name: "prediction_tolerance",
    if_absent: IfAbsent::Value("5 %"),
    meaning: "How far a predicted f1 may be off",
    ..OPEN_SHARE
};
/// Of a trusted force.
pub const TOLERANCE: Row = Row {
    name: "tolerance",
    if_absent: IfAbsent::Value("1 %"),
    meaning: "Dynamic error up to which a force counts as trusted",
    ..OPEN_SHARE
};
/// Of forces.
pub const ACCURACY_FORCE: Row = Row {
    name: "accuracy_force",
    meaning: "Limit of error of the force sensors, of reading, which the intervals then hold",
    ..ACCURACY
};
/// Of positions.
pub const ACCURACY_POSITION: Row =
    Row { name: "accuracy_position", meaning: "Limit of error of the position sensors, of reading", ..ACCURACY };
/// What was identified, as a spec.
pub const SPEC_OUT: Row = Row {
    name: "spec_out",
    takes: Takes::File("FILE"),
    meaning: "Write what was identified as a spec that `coilsense analyze` reads; needs --spec, or --windings, --radius and --wire",
    elsewhere: &[(Door::Python, "Identification.to_spec"), (Door::Page, "its buttons that save")],
    ..Row::PLAIN
};

/// What a record is judged by, of what was given and what is expected of a known spring.
///
/// # Errors
/// [`Wrong`] for a mass at an end that carries none.
pub fn settings(given: &Given, expected: Option<Expected>) -> Result<Settings, Wrong> {
    let share = |row| given.number(row).unwrap_or_default();
    Ok(Settings {
        windings: expected.map_or(given.number(&WINDINGS), |expected| expected.windings),
        mass: given.number(&MASS).filter(|_| expected.is_none()),
        predicted: expected.map(|expected| expected.first_frequency),
        prediction_tolerance: share(&PREDICTION_TOLERANCE),
        far_end: far_end(given)?,
        turned: given.text(&TURN).and_then(|name| TURNABLE.into_iter().find(|channel| channel.name() == name)),
        tolerance: share(&TOLERANCE),
        accuracy_force: share(&ACCURACY_FORCE),
        accuracy_position: share(&ACCURACY_POSITION),
    })
}

/// Channels whose sign may be turned.
const TURNABLE: [Channel; 4] = [Channel::InputForce, Channel::OutputForce, Channel::U1, Channel::U2];

fn far_end(given: &Given) -> Result<Option<FarEnd>, Wrong> {
    let mass = given.number(&END_MASS).map(FarEnd::Mass);
    let told = match given.text(&END2).as_deref() {
        Some("held") => Some(FarEnd::Position),
        Some("free") => Some(FarEnd::Force),
        _ => return Ok(mass),
    };
    if mass.is_some() { Err(END_MASS.wrong("goes with a mass at end 2 only")) } else { Ok(told) }
}

/// What no record tells of the coil, of a known spring or of what was given; none where a part of it is missing.
pub fn coil(given: &Given, spring: Option<&Spring>) -> Option<Coil> {
    match spring {
        Some(spring) => Some(Coil {
            windings: spring.windings(),
            coil_radius: spring.coil_radius(),
            wire_radius: spring.wire_radius(),
        }),
        None => Some(Coil {
            windings: given.number(&WINDINGS)?,
            coil_radius: given.number(&RADIUS)?,
            wire_radius: 0.5 * given.number(&WIRE)?,
        }),
    }
}
