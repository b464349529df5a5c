//! How far off: measures of a force against its reference, of a signal over frequency, of drift from run to run, and of windings that touch.
//!
//! Next door: the signals (`signals`), the motion (`motion`). A measure of signals knows neither spring nor sensor; clash looks at the motion itself.

mod clash;
mod clock_offset;
mod deviation;
mod sinusoid;
mod spectrum;
mod transform;
mod trend;

pub use clash::Clash;
pub use clock_offset::{ClockDrift, ClockOffset};
pub use deviation::Deviation;
pub use sinusoid::Sinusoid;
pub use spectrum::{Spectrum, alias_of};
pub use trend::Trend;
