//! What a sensor makes of the spring: an estimate of force from what it can see.
//!
//! Next door: what happens in the spring (`motion`), how far off the estimate is (`measures`).

mod deflection;
mod inductance;
mod readout;
mod two_encoder;

pub use deflection::deflection_force;
pub use inductance::InductanceSensor;
pub use readout::{MAX_ORDER, Readout, ReadoutParameters};
pub use two_encoder::TwoEncoder;
