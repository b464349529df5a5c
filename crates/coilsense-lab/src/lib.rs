//! coilsense for people: specs with units, files in and out, reports, and the paper reproduced.
//!
//! The science is next door in `coilsense`; the command, Python and the page are doors to what is here.

pub mod quantity;

pub mod spec;

pub mod published;

pub mod reproduce;

pub mod plot;

pub mod report;

pub mod output;
