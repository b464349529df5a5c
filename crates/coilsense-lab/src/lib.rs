//! coilsense for people: specs with units, files in and out, reports, and the paper reproduced.
//!
//! The science is next door in `coilsense`; the command, Python and the page are doors to what is here.

// What a user can send must not end in a panic, and a library does not print.
#![cfg_attr(
    not(test),
    warn(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout, clippy::print_stderr)
)]

mod likeness;
pub mod quantity;

pub mod spec;

pub mod condition;

pub mod published;

pub mod reproduce;

pub mod series;

pub mod sweep;

pub mod recording;

pub mod study;

pub mod analysis;

pub mod data_sheet;

pub mod calibration;

pub mod identification;
pub mod placement;

pub mod experiment;
pub mod mitigation;

pub mod rig;

pub mod report;

pub mod output;

pub mod pareto;
pub mod sensitivity;
