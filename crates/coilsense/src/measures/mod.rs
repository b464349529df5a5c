//! How far off: measures of a force against its reference, and of windings that touch.
//!
//! Next door: the signals (`signals`), the motion (`motion`). A measure of signals knows neither spring nor sensor; clash looks at the motion itself.

mod clash;
mod deviation;

pub use clash::Clash;
pub use deviation::Deviation;
