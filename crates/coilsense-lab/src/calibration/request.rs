//! What may be asked of a calibration beside its log: the options of `coilsense calibrate`, of Python's function and of the page.
//!
//! Next door: what a row says (`crate::request`), the options of the log (`crate::recording::request`), what comes of them (`plan`).

use coilsense::calibrate::Inversion;

use super::{ForceLaw, Method, Plan, Preload};
use crate::quantity::Dimension;
use crate::recording::request::is_lab_data;
use crate::request::{self, Allowed, Door, Given, IfAbsent, KNOWN_SPRING, LENGTH, Row, Takes, Wrong};

/// The options, in the order in which they are told.
pub const OPTIONS: [Row; 11] = [
    LENGTH_AT_ZERO,
    WIRE,
    RADIUS,
    WINDINGS,
    SPEC,
    METHOD,
    PRELOAD,
    INVERSION,
    STIFFNESS,
    STIFFNESS_UNCERTAINTY,
    LENGTH_AT_ZERO_FORCE,
];

/// The length where positions read zero.
pub const LENGTH_AT_ZERO: Row = Row {
    name: "length_at_zero",
    if_absent: IfAbsent::Found("u2 − u1, or u2, is the length itself"),
    meaning: "Length of the coil, from wire end to wire end along the axis, where the log's positions read zero",
    ..LENGTH
};
/// Diameter.
pub const WIRE: Row = Row {
    name: "wire",
    meaning: "Diameter of the wire, for the theories",
    requires: &["radius", "windings"],
    elsewhere: &[(Door::Python, "spring")],
    ..LENGTH
};
/// Of the coil.
pub const RADIUS: Row = Row {
    name: "radius",
    meaning: "Radius of the coil, from the axis to the centre of the wire",
    requires: &["wire", "windings"],
    elsewhere: &[(Door::Python, "spring")],
    ..LENGTH
};
/// N.
pub const WINDINGS: Row = Row {
    meaning: "Windings, may be fractional",
    requires: &["wire", "radius"],
    elsewhere: &[(Door::Python, "spring")],
    ..request::WINDINGS
};
/// A known spring.
pub const SPEC: Row = Row {
    meaning: "Take coil, stiffness and length at zero force from the [spring] of a spec",
    conflicts: &["wire", "stiffness"],
    ..KNOWN_SPRING
};
/// How the curve is found.
pub const METHOD: Row = Row {
    name: "method",
    takes: Takes::Word(&[Method::ALL[0].0, Method::ALL[1].0, Method::ALL[2].0]),
    if_absent: IfAbsent::Found("through-preload where a preload is given, two-point with --preset lab-data, else all"),
    meaning: "How the curve is put through the points",
    ..Row::PLAIN
};
/// What it must meet.
pub const PRELOAD: Row = Row {
    name: "preload",
    takes: Takes::Form("LENGTH[, L]", |text| Preload::parse(text).map(|_| ())),
    meaning: "Length of the coil at the preload, and its inductance where the log has no point there, as in \"141.8 mm, 3.35 uH\"",
    ..Row::PLAIN
};
/// How a theory is turned round.
pub const INVERSION: Row = Row {
    name: "inversion",
    takes: Takes::Word(&["exact", "25-lengths"]),
    if_absent: IfAbsent::Found(
        "25-lengths (straight lines) with --preset lab-data, as the runs' authors do, else exact",
    ),
    meaning: "How a length is read from a theory",
    ..Row::PLAIN
};
/// k.
pub const STIFFNESS: Row = Row {
    name: "stiffness",
    takes: Takes::Quantity(Dimension::Stiffness),
    allowed: Allowed::AboveZero,
    meaning: "Stiffness, to go on to force, as in \"760 N/m\"",
    requires: &["length_at_zero_force"],
    elsewhere: &[(Door::Page, "spring")],
    ..Row::PLAIN
};
/// Of k.
pub const STIFFNESS_UNCERTAINTY: Row = Row {
    name: "stiffness_uncertainty",
    takes: Takes::Quantity(Dimension::Share),
    allowed: Allowed::Below(0.0, 1.0),
    if_absent: IfAbsent::Value("0 %"),
    meaning: "Standard uncertainty of the stiffness, as in \"0.2 %\"",
    requires: &["stiffness"],
    elsewhere: &[(Door::Page, "spring")],
    ..Row::PLAIN
};
/// l_0.
pub const LENGTH_AT_ZERO_FORCE: Row = Row {
    name: "length_at_zero_force",
    meaning: "Length of the coil at which its force is zero",
    requires: &["stiffness"],
    elsewhere: &[(Door::Page, "spring")],
    ..LENGTH
};

impl Preload {
    /// From a length, or a length and an inductance: `141.8 mm, 3.35 uH`.
    ///
    /// # Errors
    /// What is allowed.
    pub fn parse(text: &str) -> Result<Self, String> {
        let read = |dimension, part| Row { takes: Takes::Quantity(dimension), ..PRELOAD_PART }.number(part);
        let (length, inductance) = text.split_once(',').map_or((text, None), |(at, henry)| (at, Some(henry)));
        let inductance = inductance.map(|henry| read(Dimension::Inductance, henry)).transpose()?;
        Ok(Self { length: read(Dimension::Length, length)?, inductance })
    }
}

/// A length or an inductance of the preload.
const PRELOAD_PART: Row = Row { name: "preload", allowed: Allowed::AboveZero, ..Row::PLAIN };

impl Plan {
    /// Of what was given, without coil and force; the measured runs are processed as their authors do unless told otherwise. `preload` is
    /// for who has it as numbers.
    ///
    /// # Errors
    /// [`Wrong`] where options do not fit each other.
    pub fn of(given: &Given, preload: Option<Preload>) -> Result<Self, Wrong> {
        let preload = preload.or_else(|| Preload::parse(&given.text(&PRELOAD)?).ok());
        let told = given.text(&METHOD);
        let method = match Method::ALL.into_iter().find(|(name, _)| Some(*name) == told.as_deref()) {
            Some((_, method)) => method,
            None if preload.is_some() => Method::ThroughPreload,
            None if is_lab_data(given) => Method::TwoPoint,
            None => Method::All,
        };
        if preload.is_some() && method != Method::ThroughPreload {
            return Err(PRELOAD.wrong("goes with the method through-preload only"));
        }
        let coarse = given.text(&INVERSION).map_or(is_lab_data(given), |word| word == "25-lengths");
        let inversion = match (coarse, given.number(&LENGTH_AT_ZERO)) {
            (false, _) => Inversion::Exact,
            (true, Some(zero_length)) => Inversion::TwentyFiveLengths { zero_length },
            (true, None) => return Err(LENGTH_AT_ZERO.wrong("is needed, from which the 25 lengths start")),
        };
        Ok(Self { method, preload, inversion, coil: None, force: None })
    }
}

impl ForceLaw {
    /// Of a stiffness and a length at zero force that were given; none without them.
    pub fn given(given: &Given) -> Option<Self> {
        let (stiffness, rest_length) = (given.number(&STIFFNESS)?, given.number(&LENGTH_AT_ZERO_FORCE)?);
        let stiffness_u = stiffness * given.number(&STIFFNESS_UNCERTAINTY).unwrap_or_default();
        Some(Self { stiffness, stiffness_u, rest_length, rest_length_u: 0.0 })
    }
}
