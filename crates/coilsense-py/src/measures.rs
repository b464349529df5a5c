//! `coilsense.Deviation`, `Clash` and `Spectrum`: how far off, whether windings touch, a signal over frequency.
//!
//! Next door: the signals (`signals`), the motion (`motion`).

mod clash;
mod deviation;
pub mod spectrum;

pub use clash::PyClash;
pub use deviation::PyDeviation;
