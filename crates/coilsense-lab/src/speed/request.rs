//! What may be asked of a speed map: the options of `coilsense speed`.
//!
//! Next door: what a row says (`crate::request`), what comes of them (the parent).

use crate::quantity::Dimension;
use crate::request::{Allowed, Door, IfAbsent, Row, Takes};

/// The options, in the order in which they are told.
pub const OPTIONS: [Row; 5] = [FROM, TO, STEP, CAM_RATIO, PART];

/// Speeds of an engine.
const OF_ENGINE: Row = Row {
    takes: Takes::Quantity(Dimension::Frequency),
    allowed: Allowed::AboveZero,
    if_absent: IfAbsent::Refused,
    ..Row::PLAIN
};
/// The lowest speed.
pub const FROM: Row = Row {
    name: "from",
    meaning: "Lowest speed of the engine, such as 1000rpm",
    elsewhere: &[(Door::Python, "from_")],
    ..OF_ENGINE
};
/// The highest speed.
pub const TO: Row = Row { name: "to", meaning: "Highest speed of the engine, such as 8000rpm", ..OF_ENGINE };
/// From speed to speed.
pub const STEP: Row = Row {
    name: "step",
    if_absent: IfAbsent::Value("100rpm"),
    meaning: "From speed to speed; more are added about those at which a harmonic of the cam has the first surge frequency",
    ..OF_ENGINE
};
/// Turns of the camshaft for one of the engine.
pub const CAM_RATIO: Row = Row {
    name: "cam_ratio",
    takes: Takes::Number,
    allowed: Allowed::Within(1e-3, 100.0),
    if_absent: IfAbsent::Value("0.5"),
    meaning: "Turns of the camshaft for one of the engine",
    ..Row::PLAIN
};
/// Which share of a map is computed.
pub const PART: Row = Row {
    name: "part",
    takes: Takes::Text("K/N"),
    meaning: "Compute only share K of N, such as 2/5, and keep it in DIR.points, for several machines to make one map; the same command without it then writes the map",
    ..Row::PLAIN
};
