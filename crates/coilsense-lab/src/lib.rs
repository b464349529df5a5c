//! coilsense for people: specs with units, files in and out, reports, and the paper reproduced.
//!
//! The science is next door in `coilsense`; the command, Python and the page are doors to what is here.

// What a user can send must not end in a panic, and a library does not print.
#![cfg_attr(
    not(test),
    warn(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout, clippy::print_stderr)
)]

/// A word that is not known to the known one that was probably meant.
mod likeness;

/// A Parquet file that ends.
#[cfg(feature = "parquet")]
mod bounded;

/// A damaged file that a decoder falls over to an error.
#[cfg(feature = "decoders")]
mod guarded;

/// A number with a unit as people write it to its SI value, and back.
pub mod quantity;

/// What is said to a user, with options as each door calls them.
pub mod message;

/// What may be asked of a verb to checked values.
pub mod request;

/// The names of the five conditions of the paper.
pub mod condition;

/// Tables II and III as printed.
pub mod published;

/// Signals and readings to text and files.
pub mod series;

/// What the system says of a file to plain words.
pub mod system;

/// Files that were read to what must not be overwritten.
pub mod input;

/// All files of a command to their places, or none.
pub mod output;

/// A coil as a helix, its ends held as they are.
pub mod helix;

/// A calibration as a file: an inductance to a length and a force.
pub mod stored;

/// A TOML file to a checked input model.
pub mod spec;

/// A spring to what follows from it alone.
pub mod data_sheet;

/// A setup to its simulation.
pub mod study;

/// Springs and conditions to the paper's tables and figures.
pub mod reproduce;

/// A measured log to signals.
pub mod recording;

/// A spec to verdicts on its sensors.
pub mod analysis;

/// Lengths and inductances to a curve.
pub mod calibration;

/// A log to the spring that rings in it.
pub mod identification;

/// The logs of an experiment to the figures of a paper on it.
pub mod experiment;

/// A spring and a load to where the force sensor should sit.
pub mod placement;

/// Conditions to ranked candidates against the ringing, and their settings.
pub mod mitigation;

/// A spec's spring to a part of another's model: C, Rust, matrices.
pub mod plant;

/// A spring under a cam to what it does at each speed of an engine.
pub mod speed;

/// A spec whose values are varied to a dataset of designs.
pub mod sweep;

/// A dataset to the designs that none other beats.
pub mod pareto;

/// A dataset to the variables that matter.
pub mod sensitivity;

/// A folder of measured logs to what is missing in it, and to one file to send.
pub mod record;

/// A spec to the files that a real rig would write.
pub mod rig;

/// Results to text, pages and JSON.
pub mod report;
