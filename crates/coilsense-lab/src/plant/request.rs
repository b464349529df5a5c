//! What may be asked of `coilsense export`.
//!
//! Next door: what a row says (`crate::request`), what is made of it (the parent).

use coilsense::plant::Order;

use super::{Also, Fmi, Form};
use crate::mitigation::export::Precision;
use crate::quantity::Dimension;
use crate::request::{Allowed, Door, Given, IfAbsent, LENGTH, OUT, Row, Takes, Wrong};

/// In what form. A form that is added is one more word here and one more of [`Form`].
pub const AS: Row = Row {
    name: "as",
    takes: Takes::Word(&["c", "rust", "state-space", "fmu"]),
    if_absent: IfAbsent::Refused,
    meaning: "As what: a C99 header, a Rust constant for coilsense-rt, matrices as JSON, or an FMU (co-simulation; FMI 2.0 also has model exchange)",
    elsewhere: &[(Door::Python, "Plant.save(form=)")],
    ..Row::PLAIN
};
/// Where to.
pub const FILE: Row = Row {
    takes: Takes::File("FILE"),
    if_absent: IfAbsent::Refused,
    meaning: "File to write; its name without ending is the name in C, Rust and the FMU",
    elsewhere: &[(Door::Python, "Plant.save")],
    ..OUT
};
/// How many modes.
pub const MODES: Row = Row {
    name: "modes",
    takes: Takes::Count,
    allowed: Allowed::Within(1.0, 1e6),
    if_absent: IfAbsent::Found("as few as --error asks for, else all"),
    meaning: "How many of the spring's modes are kept; two more stand for all others",
    ..Row::PLAIN
};
/// What may be missing.
pub const ERROR: Row = Row {
    name: "error",
    takes: Takes::Quantity(Dimension::Share),
    allowed: Allowed::Between(0.0, 1.0),
    meaning: "Error of F_i, F_o, F_x (and F_L, where also asks for it) up to --bandwidth, over k times the motion of an end, or over the force at end 2",
    ..Row::PLAIN
};
/// Up to where.
pub const BANDWIDTH: Row = Row {
    name: "bandwidth",
    takes: Takes::Quantity(Dimension::Frequency),
    allowed: Allowed::AboveZero,
    meaning: "Up to where --error holds; the error that is left is told up to there",
    ..Row::PLAIN
};
/// A step of the matrices.
pub const STEP: Row = Row {
    name: "step",
    takes: Takes::Quantity(Dimension::Time),
    allowed: Allowed::AboveZero,
    if_absent: IfAbsent::Found("no such matrices, and 1 ms in an FMU"),
    meaning: "Adds matrices for this step to a state space, is the default one of an FMU, and that in which readings are made; C and Rust without these are told theirs when they start",
    elsewhere: &[(Door::Python, "Plant.to_state_space(step=)")],
    ..Row::PLAIN
};
/// Which damping.
pub const DAMPING_RATIO: Row = Row {
    name: "damping_ratio",
    takes: Takes::Number,
    allowed: Allowed::Within(0.0, 10.0),
    if_absent: IfAbsent::Found("the spec's, where it has one"),
    meaning: "ζ of the plant, one of the spec's where it names any",
    ..Row::PLAIN
};
/// About which length.
pub const MEAN_LENGTH: Row = Row {
    name: "mean_length",
    if_absent: IfAbsent::Found(
        "that of the spec's conditions, and the middle of the operating range where they have not one",
    ),
    meaning: "Length about which inputs count",
    ..LENGTH
};
/// Which outputs beside the forces.
pub const ALSO: Row = Row {
    name: "also",
    takes: Takes::Form("WORDS", |text| Also::of(text).map(|_| ())),
    if_absent: IfAbsent::Found("F_i, F_o, F_x and u2 only"),
    meaning: "Further outputs, with commas between: F_L (with L, to second order, and the bounds of both), closest_pitch (of the windings), readings (of the spec's sensors; C and Rust, with --step)",
    ..Row::PLAIN
};
/// In which numbers it is stepped.
pub const PRECISION: Row = Row {
    name: "precision",
    takes: Takes::Word(&["single", "double"]),
    if_absent: IfAbsent::Value("double"),
    meaning: "Numbers of a step in C, float or double; in Rust those of F_L, closest_pitch and readings, f32 or f64",
    elsewhere: &[(Door::Python, "Plant.save(precision=)")],
    ..Row::PLAIN
};

/// Of which standard an FMU is.
pub const FMI: Row = Row {
    name: "fmi",
    takes: Takes::Word(&["2.0", "3.0"]),
    if_absent: IfAbsent::Found("2.0 of an FMU"),
    meaning: "Version of the standard that an FMU keeps to",
    elsewhere: &[(Door::Python, "Plant.save(fmi=)")],
    ..Row::PLAIN
};

/// The step of an FMU's default experiment where none is asked for \[s\].
const DEFAULT_STEP: f64 = 1e-3;

/// Its options, in the order in which they are told.
pub const OPTIONS: [Row; 11] =
    [AS, FILE, ALSO, MODES, ERROR, BANDWIDTH, STEP, DAMPING_RATIO, MEAN_LENGTH, PRECISION, FMI];

/// What was asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// As what.
    pub form: Form,
    /// What it tells beside the forces.
    pub also: Also,
    /// How many modes, where that is said.
    pub modes: Option<usize>,
    /// The error that is wanted.
    pub error: Option<f64>,
    /// Up to where it is wanted or told \[Hz\].
    pub bandwidth: Option<f64>,
    /// ζ, where that is said.
    pub damping_ratio: Option<f64>,
    /// \[m\], where that is said.
    pub mean_length: Option<f64>,
}

impl Form {
    /// What was given of it.
    ///
    /// # Errors
    /// [`Wrong`] for a step, a precision or a version of FMI that the form has not.
    pub fn of(given: &Given) -> Result<Self, Wrong> {
        let step = given.number(&STEP);
        let word = given.text(&AS);
        let fmi = given.text(&FMI);
        if let (Some(word), Some(fmi)) = (word.as_deref().filter(|word| *word != "fmu"), &fmi) {
            return Err(FMI.wrong(format!("goes with fmu, got {fmi} with {word}")));
        }
        let version = if fmi.as_deref() == Some("3.0") { Fmi::Three } else { Fmi::Two };
        let single = given.text(&PRECISION).as_deref() == Some("single");
        let precision = if single { Precision::Single } else { Precision::Double };
        let form = match (word.as_deref(), step) {
            (Some("state-space"), step) => Form::StateSpace { step },
            (Some("fmu"), _) if single => return Err(PRECISION.wrong("must be double of an fmu, got single")),
            (Some("fmu"), step) => Form::Fmu { version, step: step.unwrap_or(DEFAULT_STEP) },
            (Some("rust"), step) => Form::Rust { precision, step },
            (Some("c"), step) => Form::C { precision, step },
            (None, Some(_)) => return Err(AS.wrong("must be given")),
            (_, step) => Form::C { precision, step },
        };
        Ok(form)
    }
}

impl Request {
    /// What was given.
    ///
    /// # Errors
    /// [`Wrong`] for a step where there are no matrices, or an error without a bandwidth.
    pub fn of(given: &Given) -> Result<Self, Wrong> {
        if given.holds(&ERROR) && !given.holds(&BANDWIDTH) {
            return Err(ERROR.wrong("needs --bandwidth, up to where it holds"));
        }
        Ok(Self {
            form: Form::of(given)?,
            also: given
                .text(&ALSO)
                .map_or_else(|| Ok(Also::default()), |text| Also::of(&text))
                .map_err(|why| ALSO.wrong(why))?,
            modes: given.count(&MODES).map(|modes| modes as usize),
            error: given.number(&ERROR),
            bandwidth: given.number(&BANDWIDTH),
            damping_ratio: given.number(&DAMPING_RATIO),
            mean_length: given.number(&MEAN_LENGTH),
        })
    }

    /// The order that is asked of the science.
    pub(super) fn order(&self) -> Order {
        match (self.modes, self.error, self.bandwidth) {
            (Some(modes), _, _) => Order::Modes(modes),
            (None, Some(error), Some(bandwidth)) => Order::Within { error, bandwidth },
            _ => Order::All,
        }
    }
}
