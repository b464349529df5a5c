//! What may be asked of a calibration beside its log: the options of `coilsense calibrate`, of Python's function and of the page.
//!
//! Next door: what a row says (`crate::request`), the options of the log (`crate::recording::request`), what comes of them (`plan`).

use coilsense::calibrate::{Inversion, Permeability};
use coilsense::inductance::Leads;

use super::{ForceLaw, Method, Plan, Preload, Relation, SteelPlan};
use crate::quantity::Dimension;
use crate::recording::request::is_lab_data;
use crate::request::{self, Allowed, Door, Given, IfAbsent, KNOWN_SPRING, LENGTH, Row, Takes, Wrong};

/// The options, in the order in which they are told.
pub const OPTIONS: [Row; 19] = [
    LENGTH_AT_ZERO,
    WIRE,
    RADIUS,
    WINDINGS,
    SPEC,
    THEORY,
    KNOWN_PERMEABILITY,
    LEADS,
    METER_NOISE,
    FREQUENCY,
    FORM,
    POINTS,
    METHOD,
    PRELOAD,
    RE_ZERO,
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
/// The theory that is fitted.
pub const THEORY: Row = Row {
    name: "theory",
    takes: Takes::Word(&["steel"]),
    meaning: "Fit the theory of a coil of magnetic wire, by its permeability and one constant: two points are enough",
    conflicts: &["form"],
    ..Row::PLAIN
};
/// μ_r.
pub const KNOWN_PERMEABILITY: Row = Row {
    name: "known_permeability",
    takes: Takes::Number,
    allowed: Allowed::Within(1.0, 20.0),
    if_absent: IfAbsent::Found("fitted"),
    meaning: "Relative permeability of the wire where it is known, such as 2.1 from another spring of the same wire",
    requires: &["theory"],
    ..Row::PLAIN
};
/// Where the current goes back.
pub const LEADS: Row = Row {
    name: "leads",
    takes: Takes::Form("open|none|DISTANCE", |text| parse_leads(text).map(|_| ())),
    if_absent: IfAbsent::Value("open"),
    meaning: "Return lead of the meter: open (far away), its distance from the coil's axis, as in \"50 mm\", or none (the current along the coil is left out, as in simulated logs)",
    requires: &["theory"],
    ..Row::PLAIN
};
/// u(L).
pub const METER_NOISE: Row = Row {
    name: "meter_noise",
    takes: Takes::Quantity(Dimension::Inductance),
    allowed: Allowed::AboveZero,
    if_absent: IfAbsent::Found("what readings of one point scatter by, else 0.05 % of L"),
    meaning: "Standard uncertainty of a reading of L, as in \"2 nH\"",
    requires: &["theory"],
    ..Row::PLAIN
};
/// Of the meter.
pub const FREQUENCY: Row = Row {
    name: "frequency",
    takes: Takes::Quantity(Dimension::Frequency),
    allowed: Allowed::AboveZero,
    if_absent: IfAbsent::Found("low enough for the wire"),
    meaning: "Frequency of the meter, as in \"1 kHz\": the theory is for direct current, and a frequency too high for it is warned of",
    requires: &["theory"],
    ..Row::PLAIN
};
/// The form that is fitted.
pub const FORM: Row = Row {
    name: "form",
    takes: Takes::Word(&["inverse-length", "cubic"]),
    if_absent: IfAbsent::Value("inverse-length"),
    meaning: "Fit 1/l = αL + β (inverse-length), or L = α/l + β + γ/l² from three points on (cubic)",
    conflicts: &["theory"],
    ..Row::PLAIN
};
/// How many points are fitted.
pub const POINTS: Row = Row {
    name: "points",
    takes: Takes::Count,
    allowed: Allowed::Within(2.0, 1e6),
    if_absent: IfAbsent::Found("all, but as --method says"),
    meaning: "Fit this many of the points, spread from the shortest to the longest, and check on the others",
    conflicts: &["method", "preload"],
    elsewhere: &[(Door::Python, "fit_points")],
    ..Row::PLAIN
};
/// A calibration that was made before.
pub const CALIBRATION: Row = Row {
    name: "calibration",
    takes: Takes::File("FILE"),
    meaning: "A stored calibration (calibration.toml of coilsense calibrate --out): adds length and F_L by the log's L, with their standard uncertainties",
    ..Row::PLAIN
};
/// A spring that was mounted anew.
pub const RE_ZERO: Row = Row {
    name: "re_zero",
    takes: Takes::Form("LENGTH, L", |text| parse_pair(text).map(|_| ())),
    meaning: "Shift the fitted curve in L so that it passes this point, for a spring that was remounted, as in \"141.8 mm, 3.35 uH\"",
    ..Row::PLAIN
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

/// A length and an inductance: `141.8 mm, 3.35 uH`.
///
/// # Errors
/// What is allowed.
pub fn parse_pair(text: &str) -> Result<(f64, f64), String> {
    let Preload { length, inductance } = Preload::parse(text)?;
    let needed = || "must be a length and an inductance, as in \"141.8 mm, 3.35 uH\"".to_owned();
    Ok((length, inductance.ok_or_else(needed)?))
}

/// `open`, `none`, or a distance.
///
/// # Errors
/// What is allowed.
pub fn parse_leads(text: &str) -> Result<Leads, String> {
    if let Some(leads) = Leads::named(text.trim()) {
        return Ok(leads);
    }
    let distance = Row { takes: Takes::Quantity(Dimension::Length), ..PRELOAD_PART }.number(text);
    distance
        .map(Leads::Beside)
        .map_err(|_| "must be open, none, or a distance above zero with its unit, as in \"50 mm\"".to_owned())
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
        let relation = match (given.text(&THEORY), given.text(&FORM).as_deref()) {
            (Some(_), _) => Relation::Steel,
            (None, Some("cubic")) => Relation::Cubic,
            (None, _) => Relation::InverseLength,
        };
        if relation != Relation::InverseLength && method == Method::ThroughPreload {
            return Err(PRELOAD.wrong("goes with 1/l = αL + β only; another relation passes a point by --re-zero"));
        }
        let known = given.number(&KNOWN_PERMEABILITY);
        let steel = SteelPlan {
            permeability: known.map_or(Permeability::Fitted, Permeability::Known),
            leads: given.text(&LEADS).and_then(|text| parse_leads(&text).ok()).unwrap_or_default(),
            meter_noise: given.number(&METER_NOISE),
            frequency: given.number(&FREQUENCY),
            measured_at: given.number(&LENGTH_AT_ZERO_FORCE).or(given.number(&LENGTH_AT_ZERO)),
        };
        // Told by name; what a preset does without being told is eq. (13)'s way alone.
        let by_ends = told.as_deref() == Some(Method::ALL[0].0);
        let points = given
            .count(&POINTS)
            .map(|count| count as usize)
            .or((by_ends && relation != Relation::InverseLength).then_some(2));
        let re_zero = given.text(&RE_ZERO).and_then(|text| parse_pair(&text).ok());
        Ok(Self { relation, points, re_zero, steel, method, preload, inversion, coil: None, force: None })
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
