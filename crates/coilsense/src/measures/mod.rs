//! How far off: measures of a force against its reference, and of windings that touch.
//!
//! Next door: the signals (`signals`), the motion (`motion`). A measure knows neither spring nor sensor.

mod clash;
mod deviation;

pub use clash::Clash;
pub use deviation::Deviation;
