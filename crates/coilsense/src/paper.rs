//! The springs of the paper, Table I.
//!
//! Next door: what they do in its experiments (`coilsense-lab`, `reproduce`).

use crate::spring::{Spring, SpringParameters};

/// S_T, a front spring of the series elastic ankle of the humanoid TUlip, pulled only.
///
/// Source: `[Weijde2017]` Table I.
pub const S_T: SpringParameters = SpringParameters {
    rest_length: 0.104,
    windings: 52.0,
    coil_radius: 0.008,
    wire_radius: 0.001,
    mass: 0.065,
    stiffness: 760.0,
    min_length: 0.196,
    max_length: 0.264,
    nominal_force: None,
    inductance_windings: None,
    sections: None,
};

/// S_A, the parallel spring of the lower-leg prosthesis ANGELAA: of another stiffness and pitch, pulled only.
///
/// Source: `[Weijde2017]` Table I.
pub const S_A: SpringParameters = SpringParameters {
    rest_length: 0.081,
    windings: 25.0,
    wire_radius: 0.0016,
    mass: 0.08,
    stiffness: 9100.0,
    min_length: 0.082,
    max_length: 0.122,
    ..S_T
};

/// S_A as a checked spring.
pub fn s_a() -> Spring {
    checked(S_A)
}

/// S_T as a checked spring.
///
/// ```
/// let spring = coilsense::paper::s_t();
/// assert!((spring.surge_frequency() - 54.06).abs() < 0.01); // Hz, Table I prints 54.06
/// ```
pub fn s_t() -> Spring {
    checked(S_T)
}

fn checked(parameters: SpringParameters) -> Spring {
    Spring::new(parameters).unwrap_or_else(|error| unreachable!("Table I is valid: {error}"))
}
